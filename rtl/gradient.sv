// SPDX-License-Identifier: Apache-2.0
//
// Stage 1: the gradient's magnitude and the step across the contour.
//
//   magnitude  see gradient_kernel
//   step       neighbour along the gradient: 0 horizontal (2 |gy| < |gx|), 1 vertical
//              (2 |gx| < |gy|), else 2 falling (gx and gy of one sign), 3 rising
//
//   slot in, out      see slot_tracker; in_row_i the column belongs to its row; data_i one pixel, data_o =
//                     {step, magnitude} of the centre pixel, each one clock behind its slot
//   tail_column_o     in the clocks with tail_column_valid_o, the window's five oldest rows: around
//                     the centre that leaves second_contour, for slope
//   tail_*            one clock later, the slot stream six rows back
//
// Latency 2 rows + 2 columns + 8 clocks (data_o 9), 1 beat per clock. Border: magnitude 0.
module gradient #(
    parameter int MaxWidthPx   = 1920,  // longest line, 5 .. 4080 px
    parameter int FractionBits = 3      // of the gradient, 0 .. 6
) (
    input  logic                    clk_i,
    input  logic                    rst_ni,
    input  logic                    valid_i,
    input  logic                    sol_i,
    input  logic                    sof_i,
    input  logic                    real_i,
    input  logic [             1:0] fault_i,
    input  logic                    in_row_i,
    input  logic [             7:0] data_i,
    output logic                    valid_o,
    output logic                    sol_o,
    output logic                    sof_o,
    output logic                    real_o,
    output logic [             1:0] fault_o,
    output logic [FractionBits+7:0] data_o,
    output logic                    tail_column_valid_o,
    output logic [            39:0] tail_column_o,
    output logic                    tail_valid_o,
    output logic                    tail_sol_o,
    output logic                    tail_sof_o,
    output logic                    tail_real_o,
    output logic [             1:0] tail_fault_o
);
  localparam int M = 6 + FractionBits;
  localparam int S = 8 + FractionBits;
  localparam int Rows = 11;
  localparam int Latency = 6;

  logic valid, sol, sof, is_real, in_frame, in_frame_late;
  logic in_row_q;
  always_ff @(posedge clk_i) in_row_q <= in_row_i;
  logic [1:0] fault;
  logic [39:0] column;
  logic [8*(Rows-10)-1:0] unused_rows;
  line_window #(
      .Width     (8),
      .Rows      (Rows),
      .MaxWidthPx(MaxWidthPx)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i(in_row_q),
      .before_last_i((2 * $clog2(MaxWidthPx))'(0)),
      .data_i,
      .side_i(1'b0),
      .column_valid_o(tail_column_valid_o),
      .column_o({column, unused_rows, tail_column_o}),
      .window_o(),
      .side_o(),
      .valid_o(valid),
      .sol_o(sol),
      .eol_o(),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(fault),
      .in_row_o(),
      .inside_o(in_frame),
      .tail_sol_o,
      .tail_sof_o,
      .tail_real_o,
      .tail_fault_o,
      .end_o(),
      .end_fault_o()
  );

  logic signed [S-1:0] gx, gy;
  logic [M-1:0] magnitude;
  gradient_kernel #(
      .FractionBits(FractionBits)
  ) i_kernel (
      .clk_i,
      .valid_i(tail_column_valid_o),
      .column_i(column),
      .inside_i(in_frame_late),
      .gx_o(gx),
      .gy_o(gy),
      .magnitude_o(magnitude)
  );

  assign tail_valid_o = valid;

  // Clocks 7, 8. |gx|, |gy| < 96 scale fit S - 1 bits. Top operands: see first_contour.
  logic [S-2:0] ax_q, ay_q;
  logic same_sign_q, same_sign_late_q, horizontal_q, vertical_q;
  logic [S:0] margin_x, margin_y;
  assign margin_x = {ay_q[S-2], 1'b0, ax_q} - {ay_q[S-2], ay_q, 1'b1};
  assign margin_y = {ay_q[S-2], ax_q, 1'b0} - {ay_q[S-2], 1'b0, ay_q};
  always_ff @(posedge clk_i) begin
    ax_q             <= gx[S-1] ? (S - 1)'(-gx) : gx[S-2:0];
    ay_q             <= gy[S-1] ? (S - 1)'(-gy) : gy[S-2:0];
    same_sign_q      <= gx[S-1] == gy[S-1];
    horizontal_q     <= !margin_x[S];
    vertical_q       <= margin_y[S];
    same_sign_late_q <= same_sign_q;
  end
  assign data_o = {!horizontal_q && !vertical_q,
                   vertical_q || (!horizontal_q && !same_sign_late_q), magnitude};

  slot_delay #(
      .Clocks(Latency)
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
  payload_delay #(
      .Clocks(Latency)
  ) i_in_frame (
      .clk_i,
      .data_i(in_frame),
      .data_o(in_frame_late)
  );
endmodule
