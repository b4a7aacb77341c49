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
    parameter int MaxWidthPx = 1920
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

  // Clocks 1-4: the branches, from one bit per pixel and its place on the ring. The sectors along
  // the radius of ring pixel k are centred at 16 + 4 k, for odd k at 16 + 4.7 and 16 + 11.3 and so
  // on; all are the same 12 or 13 sectors, moved on.
  function automatic logic along(input logic [4:0] sector, input int k);
    logic [4:0] moved;
    moved = sector - 5'(10 + 4 * k);
    along = k % 4 == 3 ? moved == 5'd31 || moved < 5'd12 : moved < (k % 4 == 1 ? 5'd13 : 5'd12);
  endfunction
  logic [4:0] on;
  logic [14:0] radial;
  for (genvar j = 0; j < 5; j++) begin : gen_rows
    assign {on[j], directions[7*j+:7]} = column[8*j+:8];
  end
  for (genvar i = 0; i < 5; i++) begin : gen_columns
    assign radial[i]    = on[0] && along(directions[4:0], 14 - i);
    assign radial[10+i] = on[4] && along(directions[32:28], 2 + i);
  end
  assign radial[9:5] = {on[3] && along(directions[25:21], 7), on[3] && along(directions[25:21], 1),
                        on[2] && along(directions[18:14], 0), on[1] && along(directions[11:7], 9),
                        on[1] && along(directions[11:7], 15)};

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

  // Clocks 1-3: the directions' window follows two clocks behind the bits.
  logic [34:0] directions_late;
  logic [174:0] window_q;
  logic column_late_valid;
  delay_line #(
      .Width (36),
      .Clocks(2)
  ) i_directions (
      .clk_i,
      .rst_ni,
      .data_i({column_valid, directions}),
      .data_o({column_late_valid, directions_late})
  );
  always_ff @(posedge clk_i) begin
    if (column_late_valid) window_q <= {directions_late, window_q[174:35]};
  end

  // Window pixel (5 column + row) of ring pixel k.
  function automatic int ring(input int k);
    case (k)
      0: ring = 22;
      1: ring = 23;
      2: ring = 24;
      3: ring = 19;
      4: ring = 14;
      5: ring = 9;
      6: ring = 4;
      7: ring = 3;
      8: ring = 2;
      9: ring = 1;
      10: ring = 0;
      11: ring = 5;
      12: ring = 10;
      13: ring = 15;
      14: ring = 20;
      default: ring = 21;
    endcase
  endfunction

  // Clocks 4, 5: {touches, direction} of the first, the second and the last branch, first within
  // each quarter.
  logic [31:0] lows_q, highs_q;
  logic [3:0] group4_q;
  logic [2:0] two4_q;
  logic [7:0] first_q, second_q, last_q;
  logic inner4_q;
  logic [127:0] places;
  function automatic logic [7:0] pick(input logic [31:0] quarter, input logic [1:0] k);
    case (k)
      2'd0: pick = quarter[7:0];
      2'd1: pick = quarter[15:8];
      2'd2: pick = quarter[23:16];
      default: pick = quarter[31:24];
    endcase
  endfunction
  for (genvar k = 0; k < 16; k++) begin : gen_places
    assign places[8*k+:8] = {touches[k], window_q[7*ring(k)+:7]};
  end
  always_ff @(posedge clk_i) begin
    group4_q <= group;
    two4_q   <= two;
    inner4_q <= inner;
    for (int g = 0; g < 4; g++) begin
      lows_q[8*g+:8]  <= pick(places[32*g+:32], low[2*g+:2]);
      highs_q[8*g+:8] <= pick(places[32*g+:32], high[2*g+:2]);
    end
    if (group4_q[0]) first_q <= lows_q[7:0];
    else if (group4_q[1]) first_q <= lows_q[15:8];
    else if (group4_q[2]) first_q <= lows_q[23:16];
    else first_q <= lows_q[31:24];
    if (group4_q[3]) last_q <= highs_q[31:24];
    else if (group4_q[2]) last_q <= highs_q[23:16];
    else if (group4_q[1]) last_q <= highs_q[15:8];
    else last_q <= highs_q[7:0];
    if (group4_q[0] && two4_q[0]) second_q <= highs_q[7:0];
    else if (group4_q[0] ? group4_q[1] : two4_q[1]) begin
      second_q <= group4_q[0] ? lows_q[15:8] : highs_q[15:8];
    end else if (group4_q[1:0] != '0 ? group4_q[2] : two4_q[2]) begin
      second_q <= group4_q[1:0] != '0 ? lows_q[23:16] : highs_q[23:16];
    end else begin
      second_q <= group4_q[2:0] != '0 ? lows_q[31:24] : highs_q[31:24];
    end
  end

  // Clocks 6-8: turns against their bounds. The weaker of two classes is 1 where one of them is.
  function automatic logic [6:0] weaker(input logic [7:0] a, input logic b_touches);
    weaker = {a[7] && b_touches ? a[6:5] : 2'd1, a[4:0]};
  endfunction
  logic two5_q, two8, in_frame4, turns_second, turns_last;
  vertex_turn i_second (
      .clk_i,
      .min_turn_i,
      .a_i(weaker(first_q, second_q[7])),
      .b_i(second_q[6:0]),
      .turns_o(turns_second)
  );
  vertex_turn i_last (
      .clk_i,
      .min_turn_i,
      .a_i(weaker(first_q, last_q[7])),
      .b_i(last_q[6:0]),
      .turns_o(turns_last)
  );
  assign value_o = two8 && (turns_second || turns_last);
  always_ff @(posedge clk_i) two5_q <= in_frame4 && inner4_q && branches > 4'd1;
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
