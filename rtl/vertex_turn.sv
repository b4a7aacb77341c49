// SPDX-License-Identifier: Apache-2.0
//
// Whether the direction turns enough from one branch to another, see vertex_value.
//
//   turns = turn >= min_turn + (5, 2, 0 for the weaker class 1, 2, 3);  turn = distance of the
//           sectors modulo a half turn, 0 .. 16
//
//   min_turn_i  threshold, 1/64 turn;  a_i, b_i  {class, sector}, see direction
//
// Latency 3 clocks, 1 pair per clock.
module vertex_turn (
    input  logic       clk_i,
    input  logic [4:0] min_turn_i,
    input  logic [6:0] a_i,
    input  logic [6:0] b_i,
    output logic       turns_o
);
  logic [4:0] difference_q, turn_q;
  logic [1:0] class_q;
  logic [5:0] bound_q;
  always_ff @(posedge clk_i) begin
    difference_q <= a_i[4:0] - b_i[4:0];
    class_q      <= a_i[6:5] < b_i[6:5] ? a_i[6:5] : b_i[6:5];

    turn_q  <= difference_q[4] ? -difference_q : difference_q;
    bound_q <= {1'b0, min_turn_i} + (class_q == 2'd1 ? 6'd5 : class_q == 2'd2 ? 6'd2 : 6'd0);

    turns_o <= {1'b0, turn_q} >= bound_q;
  end
endmodule
