// SPDX-License-Identifier: Apache-2.0
//
// Stages 1 to 3: from pixels to the second contour, and the gradient of the same pixels.
//
//   gradient -> first_contour -> ridge -> second_contour -> slot out
//         \-> slope -> slope_*
//
//   noise_floor_i, mean_limit_i, support_i   thresholds, see first_contour, ridge
//   slot in, data_i    pixels, see gradient; in_row_i the column belongs to its row; before_last_i
//                      both widths - 2
//   slope_*            {magnitude, gy, gx} of each real pixel, raster order, slope_first_o at a frame's
//                      first, slope_begins_o two clocks before; some clocks ahead of
//   slot out, data_o   {first, contour}, eol_o last column, in_row_o a column of the row; see second_contour
//
// Latency 8 rows + 8 columns + 27 clocks to the slot out, 1 beat per clock. Border: no contour, gradient 0.
module contours #(
    parameter int MaxWidthPx   = 1920,  // longest line, 5 .. 4080 px
    parameter int FractionBits = 3      // of the gradient, 0 .. 6
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic [        FractionBits+5:0] noise_floor_i,
    input  logic [                     4:0] mean_limit_i,
    input  logic [       FractionBits+10:0] support_i,
    input  logic                            valid_i,
    input  logic                            sol_i,
    input  logic                            sof_i,
    input  logic                            real_i,
    input  logic [                     1:0] fault_i,
    input  logic                            in_row_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    input  logic [                     7:0] data_i,
    output logic                            slope_valid_o,
    output logic                            slope_first_o,
    output logic                            slope_begins_o,
    output logic [     3*FractionBits+21:0] slope_data_o,
    output logic                            valid_o,
    output logic                            sol_o,
    output logic                            eol_o,
    output logic                            sof_o,
    output logic                            real_o,
    output logic [                     1:0] fault_o,
    output logic                            in_row_o,
    output logic [                     1:0] data_o
);
  if (FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6 stop ();
  end
  localparam int MagnitudeBits = FractionBits + 6;

  // Slot streams are named after the stage they leave.
  logic gradient_valid, gradient_sol, gradient_sof, gradient_real;
  logic tail_column_valid, tail_valid, tail_sol, tail_sof, tail_real;
  logic [1:0] gradient_fault, tail_fault;
  logic [MagnitudeBits+1:0] gradient_data;
  logic [39:0] tail_column;
  gradient #(
      .MaxWidthPx  (MaxWidthPx),
      .FractionBits(FractionBits)
  ) i_gradient (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .in_row_i,
      .data_i,
      .valid_o(gradient_valid),
      .sol_o(gradient_sol),
      .sof_o(gradient_sof),
      .real_o(gradient_real),
      .fault_o(gradient_fault),
      .data_o(gradient_data),
      .tail_column_valid_o(tail_column_valid),
      .tail_column_o(tail_column),
      .tail_valid_o(tail_valid),
      .tail_sol_o(tail_sol),
      .tail_sof_o(tail_sof),
      .tail_real_o(tail_real),
      .tail_fault_o(tail_fault)
  );

  slope #(
      .MaxWidthPx  (MaxWidthPx),
      .FractionBits(FractionBits)
  ) i_slope (
      .clk_i,
      .rst_ni,
      .valid_i(tail_valid),
      .sol_i(tail_sol),
      .sof_i(tail_sof),
      .real_i(tail_real),
      .fault_i(tail_fault),
      .before_last_i,
      .column_valid_i(tail_column_valid),
      .column_i(tail_column),
      .valid_o(slope_valid_o),
      .first_o(slope_first_o),
      .begins_o(slope_begins_o),
      .data_o(slope_data_o)
  );

  logic first_valid, first_sol, first_sof, first_real;
  logic [1:0] first_fault;
  logic [3*MagnitudeBits+1:0] first_data;
  first_contour #(
      .MaxWidthPx   (MaxWidthPx),
      .MagnitudeBits(MagnitudeBits)
  ) i_first_contour (
      .clk_i,
      .rst_ni,
      .noise_floor_i,
      .mean_limit_i,
      .valid_i(gradient_valid),
      .sol_i(gradient_sol),
      .sof_i(gradient_sof),
      .real_i(gradient_real),
      .fault_i(gradient_fault),
      .data_i(gradient_data),
      .valid_o(first_valid),
      .sol_o(first_sol),
      .sof_o(first_sof),
      .real_o(first_real),
      .fault_o(first_fault),
      .data_o(first_data)
  );

  logic ridge_valid, ridge_sol, ridge_sof, ridge_real;
  logic [1:0] ridge_fault;
  logic [2:0] ridge_data;
  ridge #(
      .MaxWidthPx   (MaxWidthPx),
      .MagnitudeBits(MagnitudeBits)
  ) i_ridge (
      .clk_i,
      .rst_ni,
      .support_i,
      .noise_floor_i,
      .valid_i(first_valid),
      .sol_i(first_sol),
      .sof_i(first_sof),
      .real_i(first_real),
      .fault_i(first_fault),
      .data_i(first_data),
      .valid_o(ridge_valid),
      .sol_o(ridge_sol),
      .sof_o(ridge_sof),
      .real_o(ridge_real),
      .fault_o(ridge_fault),
      .data_o(ridge_data)
  );

  second_contour #(
      .MaxWidthPx(MaxWidthPx)
  ) i_second_contour (
      .clk_i,
      .rst_ni,
      .valid_i(ridge_valid),
      .sol_i(ridge_sol),
      .sof_i(ridge_sof),
      .real_i(ridge_real),
      .fault_i(ridge_fault),
      .before_last_i,
      .data_i(ridge_data),
      .valid_o,
      .sol_o,
      .eol_o,
      .sof_o,
      .real_o,
      .fault_o,
      .in_row_o,
      .data_o
  );
endmodule
