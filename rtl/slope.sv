// SPDX-License-Identifier: Apache-2.0
//
// The gradient vector for the contour stream, computed again from pixels four rows later.
//
// Two more rows of latency through the first and the second contour each would cost 88 bits of
// line memory per column for gx and gy; four rows of pixels cost 32 and a second adder tree.
//
//   gx = (H + 4 A) / 512, gy = (V + 4 B) / 512   see derivatives, slope_rounding
//
//   slot in          the tail of gradient's window
//   valid_o, data_o  {gy, gx} of the real pixels of every frame, in raster order
//
// Latency 2 rows + 2 columns + 13 clocks, 1 beat per clock. Border: gx = gy = 0.
module slope #(
    parameter int MaxWidthPx   = 1920,
    parameter int FractionBits = 3
) (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic                       valid_i,
    input  logic                       sol_i,
    input  logic                       sof_i,
    input  logic                       real_i,
    input  logic [                1:0] fault_i,
    input  logic [                7:0] data_i,
    output logic                       valid_o,
    output logic [2*FractionBits+15:0] data_o
);
  localparam int Latency = 11;

  logic valid, is_real, in_frame, valid_late, in_frame_late;
  logic [39:0] column;
  line_window #(
      .Width(8),
      .Columns(1),
      .MaxWidthPx(MaxWidthPx)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .data_i,
      .window_o(column),
      .valid_o(valid),
      .sol_o(),
      .eol_o(),
      .sof_o(),
      .real_o(is_real),
      .fault_o(),
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .tail_data_o(),
      .end_o(),
      .end_fault_o()
  );

  logic signed [14:0] h, v;
  logic signed [13:0] a, b;
  derivatives i_derivatives (
      .clk_i,
      .valid_i(valid),
      .column_i(column),
      .h_o(h),
      .v_o(v),
      .a_o(a),
      .b_o(b)
  );

  logic signed [FractionBits+7:0] gx, gy;
  slope_rounding #(
      .FractionBits(FractionBits)
  ) i_rounding (
      .clk_i,
      .h_i (h),
      .v_i (v),
      .a_i (a),
      .b_i (b),
      .gx_o(gx),
      .gy_o(gy)
  );

  delay_line #(
      .Width (2),
      .Clocks(Latency - 1)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .data_i({valid && is_real, in_frame}),
      .data_o({valid_late, in_frame_late})
  );

  always_ff @(posedge clk_i) begin
    valid_o <= rst_ni && valid_late;
    data_o  <= in_frame_late ? {gy, gx} : '0;
  end
endmodule
