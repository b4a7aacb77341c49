// SPDX-License-Identifier: Apache-2.0
//
// One row of vertex scores: the vertex values of 5x5 pixels, weighted.
//
//   score = (sum_i sum_j w(i) w(j) value(i, j)) / 4, rounded down, 0 .. 64;  w = 1 4 6 4 1
//
//   valid_i, column_i  newest column of the row's five values
//   score_o            2 clocks later: of two columns back
//
// 1 column per clock.
module vertex_score (
    input  logic       clk_i,
    input  logic       valid_i,
    input  logic [4:0] column_i,
    output logic [6:0] score_o
);
  // Clock 1: the column's own sum, at most 16. Clock 2: along the row; four sums wait for the columns to
  // come.
  logic valid_q;
  logic [4:0] column_q;
  logic [4:0] sum1_q;
  logic [6:0] sum2_q;
  logic [7:0] sum3_q, sum4_q;
  logic [8:0] sum;
  assign sum = 9'(sum4_q) + 9'(column_q);
  always_ff @(posedge clk_i) begin
    valid_q  <= valid_i;
    column_q <= 5'(column_i[0]) + 5'(column_i[4]) + {2'b0, column_i[1], 2'b0} +
                {2'b0, column_i[3], 2'b0} + {2'b0, column_i[2], column_i[2], 1'b0};
    if (valid_q) begin
      sum1_q  <= column_q;
      sum2_q  <= 7'(sum1_q) + {column_q, 2'b0};
      sum3_q  <= 8'(sum2_q) + {1'b0, column_q, 2'b0} + {2'b0, column_q, 1'b0};
      sum4_q  <= sum3_q + {1'b0, column_q, 2'b0};
      score_o <= 7'(sum >> 2);
    end
  end
endmodule
