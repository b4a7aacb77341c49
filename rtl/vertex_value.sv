// SPDX-License-Identifier: Apache-2.0
//
// Stage 4, first window: the vertex value of a pixel from the directions around it.
//
// The 16 outer pixels of the window, numbered from the right towards below, form branches: runs of
// branch pixels (direction not 0) that touch an inner one; a branch is known by its first pixel.
//   Two branches a < b: turn = angle of their directions, 0 .. 32; bend = 8 - distance of a and b
//   on the ring. strength = turn + bend if turn >= min_turn + (5, 2, 0 for the weaker class 1, 2, 3).
//   More: strength = 96 + 32 (three or more runs on the inner ring as well) - 2 (|X| + |Y|), with
//   (X, Y) the sum of the branches' positions.
//
//   min_turn_i        threshold, 1/64 turn
//   slot in           see slot_tracker; data_i direction, 0 for no branch pixel
//   slot out          of the centre; strength_o (0: no vertex), branches_o 2 .. 8 modulo 8, pattern_o {a, b}
//
// Latency 2 rows + 2 columns + 12 clocks, 1 beat per clock. Border: strength 0.
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
    output logic [7:0] strength_o,
    output logic [2:0] branches_o,
    output logic [7:0] pattern_o
);
  localparam int Latency = 10;

  logic [39:0] column;
  logic valid, sol, sof, is_real, in_frame;
  logic [1:0] fault;
  line_window #(
      .Width     (8),
      .Columns   (1),
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
      .window_o(column),
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

  // Clocks 1-6: the ring's branches, from one bit per pixel.
  logic [3:0] branches, group_q;
  logic [7:0] low_q, high_q, pattern, junction;
  logic centre_on;
  vertex_ring i_ring (
      .clk_i,
      .valid_i(valid),
      .column_i({|column[39:38], |column[31:30], |column[23:22], |column[15:14], |column[7:6]}),
      .group_o(group_q),
      .low_o(low_q),
      .high_o(high_q),
      .branches_o(branches),
      .pattern_o(pattern),
      .junction_o(junction),
      .centre_o(centre_on)
  );

  // Clocks 1-4: the directions' window follows three clocks behind the bits.
  logic [39:0] column_late;
  logic [199:0] window_q;
  logic valid_late;
  delay_line #(
      .Width (41),
      .Clocks(3)
  ) i_column (
      .clk_i,
      .rst_ni,
      .data_i({valid, column}),
      .data_o({valid_late, column_late})
  );
  always_ff @(posedge clk_i) begin
    if (valid_late) window_q <= {column_late, window_q[199:40]};
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

  // Clocks 5, 6: directions of the first and the last branch, first within each quarter.
  logic [31:0] firsts_q, lasts_q;
  logic [3:0] group5_q;
  logic [7:0] first_q, last_q;
  always_ff @(posedge clk_i) begin
    group5_q <= group_q;
    for (int g = 0; g < 4; g++) begin
      case (low_q[2*g+:2])
        2'd0: firsts_q[8*g+:8] <= window_q[8*ring(4*g)+:8];
        2'd1: firsts_q[8*g+:8] <= window_q[8*ring(4*g+1)+:8];
        2'd2: firsts_q[8*g+:8] <= window_q[8*ring(4*g+2)+:8];
        default: firsts_q[8*g+:8] <= window_q[8*ring(4*g+3)+:8];
      endcase
      case (high_q[2*g+:2])
        2'd0: lasts_q[8*g+:8] <= window_q[8*ring(4*g)+:8];
        2'd1: lasts_q[8*g+:8] <= window_q[8*ring(4*g+1)+:8];
        2'd2: lasts_q[8*g+:8] <= window_q[8*ring(4*g+2)+:8];
        default: lasts_q[8*g+:8] <= window_q[8*ring(4*g+3)+:8];
      endcase
    end
    if (group5_q[0]) first_q <= firsts_q[7:0];
    else if (group5_q[1]) first_q <= firsts_q[15:8];
    else if (group5_q[2]) first_q <= firsts_q[23:16];
    else first_q <= firsts_q[31:24];
    if (group5_q[3]) last_q <= lasts_q[31:24];
    else if (group5_q[2]) last_q <= lasts_q[23:16];
    else if (group5_q[1]) last_q <= lasts_q[15:8];
    else last_q <= lasts_q[7:0];
  end

  // Clocks 7-9: corner.
  logic [5:0] difference_q, turn_q, bound_q;
  logic [1:0] class_q;
  logic [3:0] apart, bend7_q, bend8_q;
  logic [5:0] corner_q;
  logic corner_valid_q;
  assign apart = pattern[3:0] - pattern[7:4];
  always_ff @(posedge clk_i) begin
    difference_q <= first_q[5:0] - last_q[5:0];
    class_q <= first_q[7:6] < last_q[7:6] ? first_q[7:6] : last_q[7:6];
    bend7_q <= apart[3] ? apart - 4'd8 : 4'd8 - apart;

    turn_q <= difference_q[5] ? -difference_q : difference_q;
    bound_q <= {1'b0, min_turn_i} + (class_q == 2'd1 ? 6'd5 : class_q == 2'd2 ? 6'd2 : 6'd0);
    bend8_q <= bend7_q;

    corner_valid_q <= turn_q >= bound_q;
    corner_q <= turn_q + {2'b0, bend8_q};
  end

  // Clock 10: the value.
  logic [3:0] branches_late;
  logic [7:0] junction_late;
  logic centre_late, in_frame_late;
  delay_line #(
      .Width (1),
      .Clocks(6)
  ) i_in_frame (
      .clk_i,
      .rst_ni,
      .data_i(in_frame),
      .data_o(in_frame_late)
  );
  delay_line #(
      .Width (13),
      .Clocks(3)
  ) i_branches (
      .clk_i,
      .rst_ni,
      .data_i({branches, junction, centre_on && in_frame_late}),
      .data_o({branches_late, junction_late, centre_late})
  );
  delay_line #(
      .Width (8),
      .Clocks(4)
  ) i_pattern (
      .clk_i,
      .rst_ni,
      .data_i(pattern),
      .data_o(pattern_o)
  );
  always_ff @(posedge clk_i) begin
    branches_o <= branches_late[2:0];
    if (!centre_late || branches_late < 4'd2) strength_o <= '0;
    else if (branches_late != 4'd2) strength_o <= junction_late;
    else strength_o <= corner_valid_q ? {2'b0, corner_q} : '0;
  end

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
