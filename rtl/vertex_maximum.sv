// SPDX-License-Identifier: Apache-2.0
//
// Whether a vertex score is at least 25 and the largest of 5x3 pixels.
//
// It must be above those before it in raster order and not below those after it. Per column of the
// three rows only their maximum is kept, one added where the centre must be above:
//
//   d = max(score above + 1, score below),  left = max(d, score + 1),  right = max(d, score)
//
//   valid_i, column_i   newest column: the vertex values of seven rows, newest in the high bits
//   within_i            5 clocks behind valid_i: whether the centre, four columns back, may be a
//                       vertex at all
//   score_o, peak_o     6 clocks behind valid_i: of the centre
//
// 1 column per clock.
module vertex_maximum (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic       valid_i,
    input  logic [6:0] column_i,
    input  logic       within_i,
    output logic [6:0] score_o,
    output logic       peak_o
);
  localparam logic [6:0] LeastScore = 7'd25;

  // Clock 2: scores of the rows above, at and below the centre.
  logic [6:0] above2, at2, below2;
  vertex_score i_above (
      .clk_i,
      .valid_i,
      .column_i(column_i[4:0]),
      .score_o (above2)
  );
  vertex_score i_at (
      .clk_i,
      .valid_i,
      .column_i(column_i[5:1]),
      .score_o (at2)
  );
  vertex_score i_below (
      .clk_i,
      .valid_i,
      .column_i(column_i[6:2]),
      .score_o (below2)
  );

  // Clocks 3-6: maxima of each column; of columns from two right of the centre (low bits) to two
  // left of it. The centre waits inverted: carry chains of small FPGAs only add.
  logic [6:0] above_plus1, at_plus1, d3_q, at3_q, d4_q, at4_q, left4_q, right4_q, not_centre_q;
  logic [13:0] right5_q, at5_q;
  logic [20:0] d5_q;
  logic [34:0] left5_q;
  logic valid4, candidate_q;
  logic [1:0] exceeds_q;
  assign above_plus1 = above2 + 7'd1;
  assign at_plus1 = at3_q + 7'd1;
  function automatic logic exceeds_centre(input logic [6:0] score);
    logic [6:0] unused_sum;
    {exceeds_centre, unused_sum} = {1'b0, score} + {1'b0, not_centre_q};
  endfunction
  delay_line #(
      .Width (1),
      .Clocks(4)
  ) i_valid (
      .clk_i,
      .rst_ni,
      .data_i(valid_i),
      .data_o(valid4)
  );
  always_ff @(posedge clk_i) begin
    d3_q  <= above_plus1 > below2 ? above_plus1 : below2;
    at3_q <= at2;

    left4_q  <= d3_q > at_plus1 ? d3_q : at_plus1;
    right4_q <= d3_q > at3_q ? d3_q : at3_q;
    d4_q     <= d3_q;
    at4_q    <= at3_q;

    if (valid4) begin
      right5_q <= {right5_q[6:0], right4_q};
      {not_centre_q, at5_q} <= {~at5_q[13:7], at5_q[6:0], at4_q};
      d5_q    <= {d5_q[13:0], d4_q};
      left5_q <= {left5_q[27:0], left4_q};
    end

    exceeds_q <= {exceeds_centre(right5_q[6:0]) || exceeds_centre(right5_q[13:7]) ||
                  exceeds_centre(d5_q[20:14]),
                  exceeds_centre(left5_q[27:21]) || exceeds_centre(left5_q[34:28])};
    candidate_q <= within_i && ~not_centre_q >= LeastScore;
    score_o     <= ~not_centre_q;
  end
  assign peak_o = candidate_q && exceeds_q == '0;
endmodule
