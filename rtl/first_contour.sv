// SPDX-License-Identifier: Apache-2.0
//
// Stage 2: the pixels where a contour may run, several pixels wide.
//
// With c the magnitude of the centre and n those of its window's 24 other pixels:
//
//   first = c >= noise_floor
//           and 32 sum{n <= c} n < mean_limit c count{n <= c}
//           and 4 p >= 3 c, 4 q >= 3 c for two inner neighbours p, q that do not touch each other
//   crest = first and m(p - s) < c and m(p + s) <= c, s the step across the contour (gradient)
//
//   noise_floor_i, mean_limit_i   thresholds
//   slot in, out                  see line_window; data_i = {step, magnitude}, one clock behind its slot
//   data_o                        one clock behind its slot: {crest, first} of the centre pixel,
//                                 magnitudes of the pixels two and one above it and its own
//
// Latency 2 rows + 2 columns + 8 clocks (data_o 9), 1 beat per clock. Border: not first contour.
module first_contour #(
    parameter int MaxWidthPx    = 1920,  // longest line, 5 .. 4080 px
    parameter int MagnitudeBits = 9      // 6 .. 12
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic [MagnitudeBits-1:0] noise_floor_i,
    input  logic [              4:0] mean_limit_i,
    input  logic                     valid_i,
    input  logic                     sol_i,
    input  logic                     sof_i,
    input  logic                     real_i,
    input  logic [              1:0] fault_i,
    input  logic [MagnitudeBits+1:0] data_i,
    output logic                     valid_o,
    output logic                     sol_o,
    output logic                     sof_o,
    output logic                     real_o,
    output logic [              1:0] fault_o,
    output logic [3*MagnitudeBits+1:0] data_o
);
  if (MagnitudeBits < 6 || MagnitudeBits > 12) begin : gen_illegal
    illegal_MagnitudeBits_must_be_6_to_12 stop ();
  end
  localparam int M = MagnitudeBits;
  localparam int Latency = 7;

  logic [25*M-1:0] window;
  logic column_valid, valid, sol, sof, is_real, in_frame;
  logic [1:0] fault, step;
  line_window #(
      .Width    (M),
      .SideWidth(2),
      .MaxWidthPx(MaxWidthPx)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i(1'b1),
      .before_last_i((2 * $clog2(MaxWidthPx))'(0)),
      .data_i(data_i[M-1:0]),
      .side_i(data_i[M+1:M]),
      .column_valid_o(column_valid),
      .column_o(),
      .window_o(window),
      .side_o(step),
      .valid_o(valid),
      .sol_o(sol),
      .eol_o(),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(fault),
      .in_row_o(),
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  // The pixel that becomes the centre with the next column: inverted, since the carry chains of small
  // FPGAs only add, and three quarters of it, rounded up, inverted.
  logic [M-1:0] centre, next, not_centre_q, not_strong_q;
  assign centre = window[12*M+:M];
  assign next   = window[17*M+:M];
  always_ff @(posedge clk_i) begin
    if (column_valid) begin
      not_centre_q <= ~next;
      not_strong_q <= ~next + (next >> 2);
    end
  end

  // Clocks 1-7.
  logic above;
  neighbour_mean #(
      .MagnitudeBits(M)
  ) i_mean (
      .clk_i,
      .mean_limit_i,
      .window_i(window),
      .lift_i(not_centre_q),
      .above_o(above)
  );

  // a < b and a <= b, by the carry of a sum. Its top operands are inverse to each other, so that the
  // top bit is the inverted carry; constants would be taken out of the carry chain, for a cell and a
  // wire more.
  function automatic logic below(input logic [M-1:0] a, input logic [M-1:0] not_b);
    logic [M+1:0] sum;
    sum = {centre[M-1], a, 1'b1} + {not_centre_q[M-1], not_b, 1'b1};
    below = sum[M+1];
  endfunction
  function automatic logic at_most(input logic [M-1:0] a, input logic [M-1:0] not_b);
    logic [M:0] sum;
    sum = {centre[M-1], a} + {not_centre_q[M-1], not_b};
    at_most = sum[M];
  endfunction

  // Clocks 1, 2: inner neighbours (columns 1-3, rows 1-3) that can carry a path, and the path.
  logic [8*M-1:0] inner;
  logic [7:0] weak_q;
  logic in_frame_q, bright_q, path_q;
  logic nw, n, ne, w, e, sw, s, se;
  assign inner = {window[16*M+:3*M], window[13*M+:M], window[11*M+:M], window[6*M+:3*M]};
  assign {se, e, ne, s, n, sw, w, nw} = ~weak_q;
  always_ff @(posedge clk_i) begin
    for (int i = 0; i < 8; i++) weak_q[i] <= below(inner[i*M+:M], not_strong_q);
    in_frame_q <= in_frame;
    bright_q   <= at_most(noise_floor_i, not_centre_q);
    path_q     <= in_frame_q && bright_q &&
                  ((n && s) || (w && e) || (n && (sw || se)) || (s && (nw || ne)) ||
                   (w && (ne || se)) || (e && (nw || sw)) || (nw && (ne || sw || se)) ||
                   (ne && (sw || se)) || (sw && se));
  end

  // Clocks 1-3: highest across the contour.
  logic [M-1:0] before_q, after_q, not_centre1_q;
  logic below_before_q, below_after_q, highest_q;
  always_ff @(posedge clk_i) begin
    case (step)
      2'd0: {before_q, after_q} <= {window[7*M+:M], window[17*M+:M]};
      2'd1: {before_q, after_q} <= {window[11*M+:M], window[13*M+:M]};
      2'd2: {before_q, after_q} <= {window[6*M+:M], window[18*M+:M]};
      default: {before_q, after_q} <= {window[8*M+:M], window[16*M+:M]};
    endcase
    not_centre1_q    <= not_centre_q;
    below_before_q   <= below(before_q, not_centre1_q);
    below_after_q    <= at_most(after_q, not_centre1_q);
    highest_q        <= below_before_q && below_after_q;
  end

  // Clock 7.
  logic path_late, highest_late, first;
  assign first = path_late && above;
  payload_delay #(
      .Clocks(Latency - 2)
  ) i_path (
      .clk_i,
      .data_i(path_q),
      .data_o(path_late)
  );
  payload_delay #(
      .Clocks(Latency - 3)
  ) i_highest (
      .clk_i,
      .data_i(highest_q),
      .data_o(highest_late)
  );

  logic [3*M-1:0] magnitudes_late;
  assign data_o = {first && highest_late, first, magnitudes_late};
  payload_delay #(
      .Width (3 * M),
      .Clocks(Latency)
  ) i_magnitudes (
      .clk_i,
      .data_i({window[10*M+:M], window[11*M+:M], centre}),
      .data_o(magnitudes_late)
  );
  slot_delay #(
      .Clocks(Latency - 1)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(fault),
      .valid_o,
      .sol_o,
      .sof_o,
      .real_o,
      .fault_o
  );
endmodule
