// SPDX-License-Identifier: Apache-2.0
//
// Stage 4: vertices from the second contour and the gradient along it.
//
//   slope_*      {magnitude, gy, gx} of each real pixel, raster order, slope_first_i at a frame's
//                first; some clocks ahead of
//   slot in      see slot_tracker; in_row_i the column belongs to its row; before_last_i both widths - 2;
//                contour_i the second contour
//   branch_floor_i, min_turn_i   thresholds, see direction, vertex_value
//   vertex_*, end_*              see vertex_peak
//
// Latency 5 rows + 6 columns + 17 clocks, 1 beat per clock. A pixel whose 5x5 window leaves the
// image is no vertex.
module vertices #(
    parameter int MaxWidthPx   = 1920,  // longest line, 5 .. 4080 px
    parameter int FractionBits = 3      // of the gradient, 0 .. 6
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic [        FractionBits+5:0] branch_floor_i,
    input  logic [                     4:0] min_turn_i,
    input  logic                            slope_valid_i,
    input  logic                            slope_first_i,
    input  logic [     3*FractionBits+21:0] slope_data_i,
    input  logic                            valid_i,
    input  logic                            sol_i,
    input  logic                            sof_i,
    input  logic                            real_i,
    input  logic [                     1:0] fault_i,
    input  logic                            in_row_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    input  logic                            contour_i,
    output logic                            vertex_valid_o,
    output logic [                    11:0] vertex_x_o,
    output logic [                    11:0] vertex_y_o,
    output logic [                     3:0] vertex_branches_o,
    output logic [                     7:0] vertex_pattern_o,
    output logic [                     6:0] vertex_strength_o,
    output logic                            end_valid_o,
    output logic [                     1:0] end_fault_o
);
  // The directions wait for the contour: 6 columns and some clocks. A frame's first pixel, which is
  // border, does not; the second is marked. Where the mark is not in its place, an upset has lost or made
  // up a direction: what waits is thrown away when the next frame begins.
  logic direction_in_valid, direction_in_first, direction_in_second_q;
  logic direction_valid, direction_marked, direction_here;
  logic pixel, first, second_q, out_of_step_q;
  logic [6:0] direction_in, direction;
  direction #(
      .FractionBits(FractionBits)
  ) i_direction (
      .clk_i,
      .rst_ni,
      .branch_floor_i,
      .valid_i(slope_valid_i),
      .first_i(slope_valid_i && slope_first_i),
      .data_i (slope_data_i),
      .valid_o(direction_in_valid),
      .first_o(direction_in_first),
      .data_o (direction_in)
  );
  stream_fifo #(
      .Width(8),
      .Depth(64)
  ) i_directions (
      .clk_i,
      .rst_ni(rst_ni && !(direction_in_first && out_of_step_q)),
      .push_i(direction_in_valid && !direction_in_first),
      .data_i({direction_in_second_q, direction_in}),
      .level_o(),
      .m_tvalid_o(direction_valid),
      .m_tready_i(pixel && !first && (second_q || !direction_marked)),
      .m_tdata_o({direction_marked, direction})
  );
  assign pixel = valid_i && in_row_i && (real_i || sof_i);
  assign first = sol_i && sof_i;
  assign direction_here = direction_valid && direction_marked == second_q;
  always_ff @(posedge clk_i) begin
    if (direction_in_valid) direction_in_second_q <= direction_in_first;
    if (!rst_ni) begin
      {second_q, out_of_step_q} <= '0;
    end else if (pixel) begin
      second_q <= first;
      if (!first && (second_q || !direction_here)) out_of_step_q <= !direction_here;
    end
  end

  logic [6:0] contour_direction_q;
  always_ff @(posedge clk_i) contour_direction_q <= contour_i ? direction : '0;

  logic value_valid, value_sol, value_sof, value_real;
  logic [1:0] value_fault;
  logic value;
  logic [1:0] above;
  vertex_value #(
      .MaxWidthPx(MaxWidthPx)
  ) i_value (
      .clk_i,
      .rst_ni,
      .min_turn_i,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .in_row_i,
      .data_i(contour_direction_q),
      .valid_o(value_valid),
      .sol_o(value_sol),
      .sof_o(value_sof),
      .real_o(value_real),
      .fault_o(value_fault),
      .value_o(value),
      .above_o(above)
  );

  vertex_peak #(
      .MaxWidthPx(MaxWidthPx)
  ) i_peak (
      .clk_i,
      .rst_ni,
      .valid_i(value_valid),
      .sol_i(value_sol),
      .sof_i(value_sof),
      .real_i(value_real),
      .fault_i(value_fault),
      .before_last_i,
      .value_i(value),
      .above_i(above),
      .vertex_valid_o,
      .vertex_x_o,
      .vertex_y_o,
      .vertex_branches_o,
      .vertex_pattern_o,
      .vertex_strength_o,
      .end_valid_o,
      .end_fault_o
  );

  // Every contour pixel finds its direction waiting.
  always_ff @(posedge clk_i) begin
    if (rst_ni && pixel) assert (first || direction_here);
  end
endmodule
