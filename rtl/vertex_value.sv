// SPDX-License-Identifier: Apache-2.0
//
// Stage 4, first window: the vertex value of a pixel, whether its window looks like one around a
// vertex, from the directions around it.
//
// A branch pixel (direction not 0) of the window's ring of 16 counts when its contour runs along the
// radius: its direction is within 35 degrees of the perpendicular to its position. Runs of such
// pixels are branches, known by their first pixel from the right towards below. One that touches no
// inner branch pixel is of class 1.
//   value = from the first branch to the second or to the last the direction turns by at least
//           min_turn + (5, 2, 0 for the weaker class 1, 2, 3), modulo a half turn, and an inner
//           pixel is a branch pixel
//
//   min_turn_i        threshold, 1/64 turn
//   slot in           see slot_tracker; in_row_i the column belongs to its row; data_i direction, 0 for
//                     no branch pixel, one clock behind it
//   slot out          of the centre; value_o; above_o: whether the pixels one (bit 1) and two above
//                     the centre are branch pixels
//
// Latency 2 rows + 2 columns + 9 clocks, 1 beat per clock. Border: value 0.
module vertex_value #(
    parameter int MaxWidthPx = 1920  // longest line, 5 .. 4080 px
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic [4:0] min_turn_i,
    input  logic       valid_i,
    input  logic       sol_i,
    input  logic       sof_i,
    input  logic       real_i,
    input  logic [1:0] fault_i,
    input  logic       in_row_i,
    input  logic [6:0] data_i,
    output logic       valid_o,
    output logic       sol_o,
    output logic       sof_o,
    output logic       real_o,
    output logic [1:0] fault_o,
    output logic       value_o,
    output logic [1:0] above_o
);
  localparam int Latency = 7;

  logic in_row_q;
  always_ff @(posedge clk_i) in_row_q <= in_row_i;
  // In the window each direction carries one more bit: whether it is a branch pixel.
  logic [39:0] column;
  logic [34:0] directions;
  logic column_valid, valid, sol, sof, is_real, in_frame;
  logic [1:0] fault;
  line_window #(
      .Width     (8),
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
      .data_i({|data_i[6:5], data_i}),
      .side_i(1'b0),
      .column_valid_o(column_valid),
      .column_o(column),
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
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  // Clocks 1-4: the branches, from one bit per pixel and its place on the ring.
  logic [4:0] on;
  logic [24:0] sectors;
  logic [14:0] radial;
  for (genvar j = 0; j < 5; j++) begin : gen_rows
    assign {on[j], directions[7*j+:7]} = column[8*j+:8];
    assign sectors[5*j+:5] = column[8*j+:5];
  end
  vertex_radial i_radial (
      .on_i(on),
      .sectors_i(sectors),
      .radial_o(radial)
  );

  logic [3:0] branches, group;
  logic [2:0] two;
  logic [7:0] low, high;
  logic [1:0] above;
  logic [15:0] touches;
  logic inner;
  vertex_ring #(
      .Touching(1'b0)
  ) i_ring (
      .clk_i,
      .valid_i(column_valid),
      .column_i(on[3:0]),
      .radial_i(radial),
      .above_o(above),
      .group_o(group),
      .two_o(two),
      .low_o(low),
      .high_o(high),
      .touches_o(touches),
      .inner_o(inner),
      .branches_o(branches),
      .pattern_o()
  );

  // Clocks 4, 5: {touches, direction} of three of them.
  logic [7:0] first, second, last;
  vertex_branches i_branches (
      .clk_i,
      .rst_ni,
      .valid_i(column_valid),
      .column_i(directions),
      .group_i(group),
      .two_i(two),
      .low_i(low),
      .high_i(high),
      .touches_i(touches),
      .first_o(first),
      .second_o(second),
      .last_o(last)
  );

  // Clocks 6-8: turns against their bounds. The weaker of two classes is 1 where one of them is.
  function automatic logic [6:0] weaker(input logic [7:0] a, input logic b_touches);
    weaker = {a[7] && b_touches ? a[6:5] : 2'd1, a[4:0]};
  endfunction
  logic inner4_q, two5_q, two8, in_frame4, turns_second, turns_last;
  vertex_turn i_second (
      .clk_i,
      .min_turn_i,
      .a_i(weaker(first, second[7])),
      .b_i(second[6:0]),
      .turns_o(turns_second)
  );
  vertex_turn i_last (
      .clk_i,
      .min_turn_i,
      .a_i(weaker(first, last[7])),
      .b_i(last[6:0]),
      .turns_o(turns_last)
  );
  assign value_o = two8 && (turns_second || turns_last);
  always_ff @(posedge clk_i) begin
    inner4_q <= inner;
    two5_q   <= in_frame4 && inner4_q && branches > 4'd1;
  end
  delay_line #(
      .Width (1),
      .Clocks(3)
  ) i_in_frame (
      .clk_i,
      .rst_ni,
      .data_i(in_frame),
      .data_o(in_frame4)
  );
  delay_line #(
      .Width (1),
      .Clocks(3)
  ) i_two (
      .clk_i,
      .rst_ni,
      .data_i(two5_q),
      .data_o(two8)
  );
  payload_delay #(
      .Width (2),
      .Clocks(Latency)
  ) i_above (
      .clk_i,
      .data_i(above),
      .data_o(above_o)
  );
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
endmodule
