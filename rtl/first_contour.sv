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
//   slot in, out                  see line_window; data_i = {step, magnitude}
//   data_o                        one clock behind its slot: {crest, first} of the centre pixel,
//                                 magnitudes of the pixels two and one above it and its own
//
// Latency 2 rows + 2 columns + 8 clocks (data_o 9), 1 beat per clock. Border: not first contour.
module first_contour #(
    parameter int MaxWidthPx    = 1920,
    parameter int MagnitudeBits = 9
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
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  // Clocks 1-6: sum (clock 6) and count (clock 3) of the neighbours that are not above the centre,
  // each lifted by C = highest magnitude - c: n + C is what the comparison's subtraction leaves.
  // Hence 32 sum{n + C} < (mean_limit c + 32 C) count.
  logic [M-1:0] centre;
  logic [24*M-1:0] kept_q;
  logic [23:0] keeps_q;
  logic [12*(M+1)-1:0] sum12_q;
  logic [6*(M+2)-1:0] sum6_q;
  logic [3*(M+3)-1:0] sum3_q;
  logic [M+3:0] sum2_q;
  logic [M+2:0] sum1_q;
  logic [M+4:0] sum_q;
  logic [17:0] count6_q;
  logic [4:0] count_q;
  assign centre = window[12*M+:M];

  // Comparisons by the borrow of a subtraction: one carry chain, and the inverted b is shared.
  function automatic logic below(input logic [M+1:0] a, input logic [M+1:0] b);
    logic [M+2:0] difference;
    difference = {1'b0, a} - {1'b0, b};
    below = difference[M+2];
  endfunction
  logic [24*(M+2)-1:0] differences;
  for (genvar i = 0; i < 24; i++) begin : gen_differences
    assign differences[i*(M+2)+:M+2] = {1'b0, window[(i<12?i:i+1)*M+:M], 1'b0} -
                                       {1'b0, centre, 1'b1};
  end

  always_ff @(posedge clk_i) begin
    for (int i = 0; i < 24; i++) begin
      keeps_q[i]     <= differences[i*(M+2)+M+1];
      kept_q[i*M+:M] <= differences[i*(M+2)+M+1] ? differences[i*(M+2)+1+:M] : '0;
    end
    for (int i = 0; i < 12; i++) begin
      sum12_q[i*(M+1)+:M+1] <= (M + 1)'(kept_q[2*i*M+:M]) + (M + 1)'(kept_q[(2*i+1)*M+:M]);
    end
    for (int i = 0; i < 6; i++) begin
      count6_q[3*i+:3] <= 3'(keeps_q[4*i]) + 3'(keeps_q[4*i+1]) + 3'(keeps_q[4*i+2]) +
                          3'(keeps_q[4*i+3]);
      sum6_q[i*(M+2)+:M+2] <= (M + 2)'(sum12_q[2*i*(M+1)+:M+1]) +
                              (M + 2)'(sum12_q[(2*i+1)*(M+1)+:M+1]);
    end
    for (int i = 0; i < 3; i++) begin
      sum3_q[i*(M+3)+:M+3] <= (M + 3)'(sum6_q[2*i*(M+2)+:M+2]) +
                              (M + 3)'(sum6_q[(2*i+1)*(M+2)+:M+2]);
    end
    sum2_q       <= (M + 4)'(sum3_q[0+:M+3]) + (M + 4)'(sum3_q[M+3+:M+3]);
    sum1_q       <= sum3_q[2*(M+3)+:M+3];
    sum_q        <= (M + 5)'(sum2_q) + (M + 5)'(sum1_q);
    count_q      <= ((5'(count6_q[0+:3]) + 5'(count6_q[3+:3])) +
                     (5'(count6_q[6+:3]) + 5'(count6_q[9+:3]))) +
                    (5'(count6_q[12+:3]) + 5'(count6_q[15+:3]));
  end

  // Clocks 1-6: (mean_limit c + 32 C) count.
  logic [M+4:0] limit;
  logic [M+9:0] bound;
  scale5 #(
      .Width(M)
  ) i_limit (
      .clk_i,
      .value_i  (centre),
      .factor_i (mean_limit_i),
      .offset_i (~centre),
      .product_o(limit)
  );
  scale5 #(
      .Width(M + 5)
  ) i_bound (
      .clk_i,
      .value_i  (limit),
      .factor_i (count_q),
      .offset_i ({(M + 5) {1'b0}}),
      .product_o(bound)
  );

  // Clocks 1, 2: inner neighbours (columns 1-3, rows 1-3) that can carry a path, and the path.
  logic [8*M-1:0] inner;
  logic [M+1:0] centre3_q;
  logic [7:0] on_q;
  logic floor_q, path_q;
  logic nw, n, ne, w, e, sw, s, se;
  assign inner = {window[16*M+:3*M], window[13*M+:M], window[11*M+:M], window[6*M+:3*M]};
  assign {se, e, ne, s, n, sw, w, nw} = on_q;
  always_ff @(posedge clk_i) begin
    // Three times the pixel that becomes the centre with the next column.
    if (column_valid) centre3_q <= (M + 2)'(window[17*M+:M]) + {1'b0, window[17*M+:M], 1'b0};
    for (int i = 0; i < 8; i++) on_q[i] <= !below({inner[i*M+:M], 2'b0}, centre3_q);
    floor_q <= in_frame && !below({2'b0, centre}, {2'b0, noise_floor_i});
    path_q  <= floor_q && ((n && s) || (w && e) || (n && (sw || se)) || (s && (nw || ne)) ||
                           (w && (ne || se)) || (e && (nw || sw)) || (nw && (ne || sw || se)) ||
                           (ne && (sw || se)) || (sw && se));
  end

  // Clocks 1, 2: highest across the contour.
  logic [M-1:0] before_q, after_q, centre1_q;
  logic highest_q;
  always_ff @(posedge clk_i) begin
    case (step)
      2'd0: {before_q, after_q} <= {window[7*M+:M], window[17*M+:M]};
      2'd1: {before_q, after_q} <= {window[11*M+:M], window[13*M+:M]};
      2'd2: {before_q, after_q} <= {window[6*M+:M], window[18*M+:M]};
      default: {before_q, after_q} <= {window[8*M+:M], window[16*M+:M]};
    endcase
    centre1_q <= centre;
    highest_q <= below({1'b0, before_q, 1'b0}, {1'b0, centre1_q, 1'b0}) &&
                 below({1'b0, after_q, 1'b0}, {1'b0, centre1_q, 1'b1});
  end

  // Clock 7.
  logic path_late, highest_late, first, crest_q, first_q;
  logic [M+10:0] margin;
  assign margin = {1'b0, sum_q, 5'b0} - {1'b0, bound};
  assign first  = path_late && margin[M+10];
  always_ff @(posedge clk_i) begin
    first_q <= first;
    crest_q <= first && highest_late;
  end
  delay_line #(
      .Width (2),
      .Clocks(Latency - 3)
  ) i_path (
      .clk_i,
      .rst_ni,
      .data_i({path_q, highest_q}),
      .data_o({path_late, highest_late})
  );

  logic [3*M-1:0] magnitudes_late;
  assign data_o = {crest_q, first_q, magnitudes_late};
  delay_line #(
      .Width (3 * M),
      .Clocks(Latency)
  ) i_magnitudes (
      .clk_i,
      .rst_ni,
      .data_i({window[10*M+:M], window[11*M+:M], centre}),
      .data_o(magnitudes_late)
  );
  delay_line #(
      .Width (6),
      .Clocks(Latency - 1)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .data_i({valid, sol, sof, is_real, fault}),
      .data_o({valid_o, sol_o, sof_o, real_o, fault_o})
  );
endmodule
