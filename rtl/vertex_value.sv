// SPDX-License-Identifier: Apache-2.0
//
// Stage 4, first window: the vertex value of a pixel from the directions around it.
//
// The 16 outer pixels of the window, numbered from the right towards below, form branches: runs of
// branch pixels (direction not 0) that touch an inner one; a branch is known by its first pixel.
//   Two branches a < b: turn = angle of their directions, 0 .. 32; bend = 8 - distance of a and b
//   on the ring. strength = turn + bend if turn >= min_turn + (5, 2, 0 for the weaker class 1, 2, 3).
//   More: strength = 96 + 32 (three or more runs on the inner ring as well) - 2 (|X| + |Y|), with
//   (X, Y) the sum of the branches' positions, |X| + |Y| <= 8.
//
//   min_turn_i        threshold, 1/64 turn
//   slot in           see slot_tracker; data_i direction, 0 for no branch pixel
//   slot out          of the centre; above_o: whether the centre (bit 2) and the pixels one and two
//                     above it are branch pixels; strength_o as a code of the same order that takes
//                     two bits less: 0 no vertex, 1 .. 40 corners, 41 .. 49 and 50 .. 58 junctions
//
// Latency 2 rows + 2 columns + 10 clocks, 1 beat per clock. Border: strength 0.
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
    input  logic [7:0] data_i,
    output logic       valid_o,
    output logic       sol_o,
    output logic       sof_o,
    output logic       real_o,
    output logic [1:0] fault_o,
    output logic [5:0] strength_o,
    output logic [2:0] above_o
);
  localparam int Latency = 8;

  logic [39:0] column;
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
      .data_i,
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
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  // Clocks 1-5: the ring's branches, from one bit per pixel.
  logic [3:0] branches, group;
  logic [7:0] low, high, pattern;
  logic [5:0] junction;
  logic [2:0] above;
  vertex_ring i_ring (
      .clk_i,
      .valid_i(column_valid),
      .column_i({|column[39:38], |column[31:30], |column[23:22], |column[15:14], |column[7:6]}),
      .above_o(above),
      .group_o(group),
      .low_o(low),
      .high_o(high),
      .branches_o(branches),
      .pattern_o(pattern),
      .junction_o(junction)
  );

  // Clocks 1-3: the directions' window follows two clocks behind the bits.
  logic [39:0] column_late;
  logic [199:0] window_q;
  logic column_late_valid;
  delay_line #(
      .Width (41),
      .Clocks(2)
  ) i_column (
      .clk_i,
      .rst_ni,
      .data_i({column_valid, column}),
      .data_o({column_late_valid, column_late})
  );
  always_ff @(posedge clk_i) begin
    if (column_late_valid) window_q <= {column_late, window_q[199:40]};
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

  // Clocks 4, 5: directions of the first and the last branch, first within each quarter.
  logic [31:0] firsts_q, lasts_q;
  logic [3:0] group4_q;
  logic [7:0] first_q, last_q;
  always_ff @(posedge clk_i) begin
    group4_q <= group;
    for (int g = 0; g < 4; g++) begin
      case (low[2*g+:2])
        2'd0: firsts_q[8*g+:8] <= window_q[8*ring(4*g)+:8];
        2'd1: firsts_q[8*g+:8] <= window_q[8*ring(4*g+1)+:8];
        2'd2: firsts_q[8*g+:8] <= window_q[8*ring(4*g+2)+:8];
        default: firsts_q[8*g+:8] <= window_q[8*ring(4*g+3)+:8];
      endcase
      case (high[2*g+:2])
        2'd0: lasts_q[8*g+:8] <= window_q[8*ring(4*g)+:8];
        2'd1: lasts_q[8*g+:8] <= window_q[8*ring(4*g+1)+:8];
        2'd2: lasts_q[8*g+:8] <= window_q[8*ring(4*g+2)+:8];
        default: lasts_q[8*g+:8] <= window_q[8*ring(4*g+3)+:8];
      endcase
    end
    if (group4_q[0]) first_q <= firsts_q[7:0];
    else if (group4_q[1]) first_q <= firsts_q[15:8];
    else if (group4_q[2]) first_q <= firsts_q[23:16];
    else first_q <= firsts_q[31:24];
    if (group4_q[3]) last_q <= lasts_q[31:24];
    else if (group4_q[2]) last_q <= lasts_q[23:16];
    else if (group4_q[1]) last_q <= lasts_q[15:8];
    else last_q <= lasts_q[7:0];
  end

  // Clocks 5-8: corner.
  logic [5:0] difference_q, turn_q, bound_q, corner_q;
  logic [1:0] class_q;
  logic [3:0] apart, bend5_q, bend6_q, bend7_q;
  logic corner_valid_q;
  assign apart = pattern[3:0] - pattern[7:4];
  always_ff @(posedge clk_i) begin
    bend5_q <= apart[3] ? apart - 4'd8 : 4'd8 - apart;

    difference_q <= first_q[5:0] - last_q[5:0];
    class_q      <= first_q[7:6] < last_q[7:6] ? first_q[7:6] : last_q[7:6];
    bend6_q      <= bend5_q;

    turn_q  <= difference_q[5] ? -difference_q : difference_q;
    bound_q <= {1'b0, min_turn_i} + (class_q == 2'd1 ? 6'd5 : class_q == 2'd2 ? 6'd2 : 6'd0);
    bend7_q <= bend6_q;

    corner_valid_q <= turn_q >= bound_q;
    corner_q       <= turn_q + {2'b0, bend7_q};
  end

  // Clocks 5-8: corner or junction, if the centre is on and inside.
  logic [2:0] above4;
  logic in_frame4, two5_q, more5_q, two_late;
  logic [5:0] junction_late;
  always_ff @(posedge clk_i) begin
    two5_q  <= in_frame4 && above4[2] && branches == 4'd2;
    more5_q <= in_frame4 && above4[2] && branches > 4'd2;
    if (two_late) strength_o <= corner_valid_q ? corner_q : '0;
    else strength_o <= junction_late;
  end
  delay_line #(
      .Width (4),
      .Clocks(3)
  ) i_above4 (
      .clk_i,
      .rst_ni,
      .data_i({in_frame, above}),
      .data_o({in_frame4, above4})
  );
  delay_line #(
      .Width (3),
      .Clocks(Latency - 3)
  ) i_above (
      .clk_i,
      .rst_ni,
      .data_i(above4),
      .data_o(above_o)
  );
  delay_line #(
      .Width (7),
      .Clocks(3)
  ) i_junction (
      .clk_i,
      .rst_ni,
      .data_i({two5_q, more5_q ? junction : 6'd0}),
      .data_o({two_late, junction_late})
  );

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
