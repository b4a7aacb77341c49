// SPDX-License-Identifier: Apache-2.0
//
// Stage 3, first window: first-contour pixels on the ridge of the magnitude m.
//
//   ridge = crest and sum{5x5, first} m >= support
//   floor = m >= noise_floor
//
//   support_i, noise_floor_i   thresholds
//   slot in, data_i            see first_contour
//   slot out, data_o           {floor, first} of the pixel two rows above the centre, which
//                              second_contour needs next, and ridge of the centre pixel, one clock
//                              behind their slot
//
// The magnitudes of a row and the two above come with data_i; two older ones wait in the line
// memory. The sum goes column by column, then along the row.
//
// Latency 2 rows + 2 columns + 5 clocks (data_o 6), 1 beat per clock. Border: no ridge.
module ridge #(
    parameter int MaxWidthPx    = 1920,  // longest line, 5 .. 4080 px
    parameter int MagnitudeBits = 9      // 6 .. 12
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
    input  logic [3*MagnitudeBits+1:0] data_i,
    output logic                     valid_o,
    output logic                     sol_o,
    output logic                     sof_o,
    output logic                     real_o,
    output logic [              1:0] fault_o,
    output logic [              2:0] data_o
);
  if (MagnitudeBits < 6 || MagnitudeBits > 12) begin : gen_illegal
    illegal_MagnitudeBits_must_be_6_to_12 stop ();
  end
  localparam int M = MagnitudeBits;
  localparam int ColBits = $clog2(MaxWidthPx);
  localparam int Latency = 4;

  logic valid1, valid, sol, sof, is_real, in_frame;
  logic [1:0] fault;
  logic [ColBits-1:0] col, col1;
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx)
  ) i_tracker (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i(1'b1),
      .before_last_i((2 * ColBits)'(0)),
      .col_o(col),
      .valid1_o(valid1),
      .col1_o(col1),
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

  // Clock 0: the new column: magnitudes m0 (newest row) .. m4, first-contour bits likewise.
  logic [M-1:0] m0, m1, m2, m3, m4;
  logic [4:0] first;
  logic crest0, crest1, crest2;
  assign {crest0, first[0], m2, m1, m0} = data_i;
  line_memory #(
      .Width(2 * M + 6),
      .Depth(MaxWidthPx)
  ) i_rows (
      .clk_i,
      .wen_i  (valid1),
      .waddr_i(col1),
      .wdata_i({crest1, crest0, first[3:0], m3, m2}),
      .raddr_i(col),
      .rdata_o({crest2, crest1, first[4:1], m4, m3})
  );

  // Clocks 1-3: sum of the column's first-contour magnitudes.
  logic [5*M-1:0] kept_q;
  logic [M+1:0] sum012_q;
  logic [M:0] sum34_q;
  logic [M+2:0] column_q;
  logic [2:0] valid_q;
  always_ff @(posedge clk_i) begin
    valid_q <= {valid_q[1:0], valid1};
    kept_q <= {{M{first[4]}} & m4, {M{first[3]}} & m3, {M{first[2]}} & m2, {M{first[1]}} & m1,
               {M{first[0]}} & m0};
    sum012_q <= ((M + 2)'(kept_q[0+:M]) + (M + 2)'(kept_q[M+:M])) + (M + 2)'(kept_q[2*M+:M]);
    sum34_q  <= (M + 1)'(kept_q[3*M+:M]) + (M + 1)'(kept_q[4*M+:M]);
    column_q <= (M + 3)'(sum012_q) + (M + 3)'(sum34_q);
  end

  // Clock 4: sum of the window; sum1_q .. sum4_q are of the last 1 .. 4 columns.
  logic [M+2:0] sum1_q;
  logic [M+3:0] sum2_q;
  logic [M+4:0] sum3_q, sum4_q, not_support_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[2]) begin
      sum1_q <= column_q;
      sum2_q <= (M + 4)'(sum1_q) + (M + 4)'(column_q);
      sum3_q <= (M + 5)'(sum2_q) + (M + 5)'(column_q);
      sum4_q <= sum3_q + (M + 5)'(column_q);
    end
    not_support_q <= ~(sum4_q + (M + 5)'(column_q));
  end

  // Clock 1 and two columns: what the centre column holds, in step with the tracker's centre.
  logic [M-1:0] newest_q;
  logic [1:0] floor_q;
  logic [5:0] centre_q;
  logic [M:0] above_floor;
  assign above_floor = {1'b0, newest_q} - {1'b0, noise_floor_i};
  always_ff @(posedge clk_i) begin
    if (valid1) begin
      newest_q <= m4;
      floor_q  <= {floor_q[0], !above_floor[M]};
      centre_q <= {centre_q[3:0], first[4], crest2};
    end
  end

  // Clock 5.
  logic [1:0] flags_late;
  logic crest_late, short_q;
  payload_delay #(
      .Width (3),
      .Clocks(Latency)
  ) i_flags (
      .clk_i,
      .data_i({floor_q[1], centre_q[5], centre_q[4] && in_frame}),
      .data_o({flags_late, crest_late})
  );
  assign data_o = {flags_late, crest_late && !short_q};
  logic [M+5:0] margin;
  assign margin = {1'b0, support_i} + {1'b0, not_support_q};
  always_ff @(posedge clk_i) short_q <= margin[M+5];

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
