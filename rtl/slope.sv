// SPDX-License-Identifier: Apache-2.0
//
// The gradient of the contour stream, computed again from pixels six rows later.
//
// To carry gx, gy and the magnitude along with the contour would take 6 rows of 31 bits in line
// memories; six rows of pixels take 48 and a second kernel.
//
//   slot and column in   the tail of gradient's window, the slot one clock behind the column;
//                        before_last_i both widths - 2, see slot_tracker
//   valid_o, data_o      {magnitude, gy, gx} of the real pixels of every frame, in raster order;
//                        first_o: a frame's first; begins_o: it comes two clocks later
//
// Latency 2 columns + 8 clocks behind the slot, 1 beat per clock. Border: all 0.
module slope #(
    parameter int MaxWidthPx   = 1920,  // longest line, 5 .. 4080 px
    parameter int FractionBits = 3      // of the gradient, 0 .. 6
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            valid_i,
    input  logic                            sol_i,
    input  logic                            sof_i,
    input  logic                            real_i,
    input  logic [                     1:0] fault_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    input  logic                            column_valid_i,
    input  logic [                    39:0] column_i,
    output logic                            valid_o,
    output logic                            first_o,
    output logic                            begins_o,
    output logic [     3*FractionBits+21:0] data_o
);
  localparam int M = 6 + FractionBits;
  localparam int S = 8 + FractionBits;

  // Clock 3 (column_i is clock 0): what a beat is.
  logic valid, is_real, in_row, in_frame, in_frame_late, sol, sof;
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx),
      .Limited   (1'b1)
  ) i_tracker (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i(1'b1),
      .before_last_i(before_last_i),
      .col_o(),
      .valid1_o(),
      .col1_o(),
      .valid_o(valid),
      .sol_o(sol),
      .eol_o(),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(),
      .in_row_o(in_row),
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  logic signed [S-1:0] gx, gy;
  logic [2*S-1:0] vector7_q, vector8_q;
  logic [M-1:0] magnitude;
  gradient_kernel #(
      .FractionBits(FractionBits)
  ) i_kernel (
      .clk_i,
      .valid_i(column_valid_i),
      .column_i,
      .inside_i(in_frame_late),
      .gx_o(gx),
      .gy_o(gy),
      .magnitude_o(magnitude)
  );
  payload_delay #(
      .Clocks(4)
  ) i_in_frame (
      .clk_i,
      .data_i(in_frame),
      .data_o(in_frame_late)
  );
  logic valid6, first6;
  assign begins_o = valid6 && first6;
  delay_line #(
      .Width (2),
      .Clocks(3)
  ) i_beat (
      .clk_i,
      .rst_ni,
      .data_i({valid && in_row && (is_real || sof), sof && sol}),
      .data_o({valid6, first6})
  );
  delay_line #(
      .Width (2),
      .Clocks(2)
  ) i_late (
      .clk_i,
      .rst_ni,
      .data_i({valid6, first6}),
      .data_o({valid_o, first_o})
  );

  // Clocks 7, 8: the vector waits for the magnitude.
  assign data_o = {magnitude, vector8_q};
  always_ff @(posedge clk_i) begin
    vector7_q <= {gy, gx};
    vector8_q <= in_frame_late ? vector7_q : '0;
  end
endmodule
