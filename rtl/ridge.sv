// SPDX-License-Identifier: Apache-2.0
//
// Stage 3, first window: first-contour pixels on the ridge of the magnitude m.
//
//   ridge = first and sum{5x5, first} m >= support and m(p - s) < m(p) and m(p + s) <= m(p)
//   floor = m(p) >= noise_floor
//
// with s the step across the contour, from gradient.
//
//   support_i, noise_floor_i   thresholds
//   slot in, out               see slot_tracker; data_i = {first, step, magnitude},
//                              data_o = {floor, first, ridge} of the centre pixel
//
// Latency 2 rows + 2 columns + 10 clocks, 1 beat per clock. Border: no ridge.
module ridge #(
    parameter int MaxWidthPx    = 1920,
    parameter int MagnitudeBits = 9
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic [MagnitudeBits+4:0] support_i,
    input  logic [MagnitudeBits-1:0] noise_floor_i,
    input  logic                     valid_i,
    input  logic                     sol_i,
    input  logic                     sof_i,
    input  logic                     real_i,
    input  logic [              1:0] fault_i,
    input  logic [MagnitudeBits+2:0] data_i,
    output logic                     valid_o,
    output logic                     sol_o,
    output logic                     sof_o,
    output logic                     real_o,
    output logic [              1:0] fault_o,
    output logic [              2:0] data_o
);
  localparam int M = MagnitudeBits;
  localparam int P = M + 1;  // window pixel {first, magnitude}
  localparam int Latency = 8;

  // The four left columns are needed in rows 1 .. 3 around the centre only.
  logic [25*P-1:0] window;
  logic valid, sol, sof, is_real, in_frame;
  logic [1:0] fault, step;
  line_window #(
      .Width     (P),
      .SideWidth (2),
      .MaxWidthPx(MaxWidthPx)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .data_i({data_i[M+2], data_i[M-1:0]}),
      .side_i(data_i[M+1:M]),
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

  // Clocks 1-4: sum of each column's first-contour magnitudes, the last five columns.
  logic [5*M-1:0] kept_q;
  logic [M:0] sum01_q, sum23_q;
  logic [M-1:0] sum4_q, sum4_late_q;
  logic [M+1:0] sum0123_q;
  logic [5*(M+3)-1:0] columns_q;
  logic [2:0] valid_q;
  always_ff @(posedge clk_i) begin
    valid_q <= {valid_q[1:0], valid};
    for (int j = 0; j < 5; j++) begin
      kept_q[j*M+:M] <= window[(20+j)*P+M] ? window[(20+j)*P+:M] : '0;
    end
    sum01_q     <= (M + 1)'(kept_q[0+:M]) + (M + 1)'(kept_q[M+:M]);
    sum23_q     <= (M + 1)'(kept_q[2*M+:M]) + (M + 1)'(kept_q[3*M+:M]);
    sum4_q      <= kept_q[4*M+:M];
    sum0123_q   <= (M + 2)'(sum01_q) + (M + 2)'(sum23_q);
    sum4_late_q <= sum4_q;
    if (valid_q[2]) begin
      columns_q <= {columns_q[4*(M+3)-1:0], (M + 3)'(sum0123_q) + (M + 3)'(sum4_late_q)};
    end
  end

  // Clocks 5-7: sum of the window.
  logic [M+3:0] near_q, far_q;
  logic [M+2:0] last_q, last_late_q;
  logic [M+4:0] both_q, support_q;
  always_ff @(posedge clk_i) begin
    near_q      <= (M + 4)'(columns_q[0+:M+3]) + (M + 4)'(columns_q[M+3+:M+3]);
    far_q       <= (M + 4)'(columns_q[2*(M+3)+:M+3]) + (M + 4)'(columns_q[3*(M+3)+:M+3]);
    last_q      <= columns_q[4*(M+3)+:M+3];
    both_q      <= (M + 5)'(near_q) + (M + 5)'(far_q);
    last_late_q <= last_q;
    support_q   <= both_q + (M + 5)'(last_late_q);
  end

  // Clocks 1, 2: highest across the contour.
  logic [M-1:0] before_q, after_q, centre_q;
  logic first1_q, first2_q, peak_q, floor_q;
  always_ff @(posedge clk_i) begin
    case (step)
      2'd0: {before_q, after_q} <= {window[7*P+:M], window[17*P+:M]};
      2'd1: {before_q, after_q} <= {window[11*P+:M], window[13*P+:M]};
      2'd2: {before_q, after_q} <= {window[6*P+:M], window[18*P+:M]};
      default: {before_q, after_q} <= {window[8*P+:M], window[16*P+:M]};
    endcase
    centre_q <= window[12*P+:M];
    first1_q <= in_frame && window[12*P+M];
    first2_q <= first1_q;
    peak_q   <= first1_q && before_q < centre_q && after_q <= centre_q;
    floor_q  <= centre_q >= noise_floor_i;
  end

  logic peak_late, ridge_q;
  delay_line #(
      .Width (1),
      .Clocks(Latency - 3)
  ) i_peak (
      .clk_i,
      .rst_ni,
      .data_i(peak_q),
      .data_o(peak_late)
  );
  delay_line #(
      .Width (2),
      .Clocks(Latency - 2)
  ) i_flags (
      .clk_i,
      .rst_ni,
      .data_i({floor_q, first2_q}),
      .data_o(data_o[2:1])
  );
  assign data_o[0] = ridge_q;
  always_ff @(posedge clk_i) ridge_q <= peak_late && support_q >= support_i;

  delay_line #(
      .Width (6),
      .Clocks(Latency)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .data_i({valid, sol, sof, is_real, fault}),
      .data_o({valid_o, sol_o, sof_o, real_o, fault_o})
  );
endmodule
