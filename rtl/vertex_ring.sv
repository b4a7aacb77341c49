// SPDX-License-Identifier: Apache-2.0
//
// The branches that leave a 5x5 window: runs on its ring of 16 pixels, which are numbered from the
// right towards below.
//
//   valid_i, column_i  branch pixels of the newest column's rows 0 .. 3, oldest row in bit 0
//   radial_i           whether its pixels count on the ring; a pixel's place on the ring changes as
//                      the window moves on: bits 0-4 row 0 in ring pixels 14, 13, 12, 11, 10,
//                      5, 6 row 1 in 15, 9; 7 row 2 in 0, 8; 8, 9 row 3 in 1, 7; 10-14 row 4
//                      in 2, 3, 4, 5, 6
//   above_o            1 clock later: the pixels one (bit 1) and two above the centre
//   group_o, two_o, low_o, high_o   3 clocks later: per quarter of the ring (4 pixels) whether a
//                      branch begins there, whether two do (not told of the last quarter), the first and
//                      the last
//   touches_o, inner_o       3 clocks later: of each place on the ring whether an inner branch pixel
//                      touches it; whether there is one at all
//   branches_o, pattern_o    4 clocks later: branches 0 .. 8, {first, last} branch, 0 for none
//
// With Touching a ring pixel counts only where an inner branch pixel touches it. 1 beat per clock;
// the centre is two columns behind.
module vertex_ring #(
    parameter bit Touching = 1'b1  // 1: only pixels that touch an inner branch pixel
) (
    input  logic        clk_i,
    input  logic        valid_i,
    input  logic [ 3:0] column_i,
    input  logic [14:0] radial_i,
    output logic [ 1:0] above_o,
    output logic [ 3:0] group_o,
    output logic [ 2:0] two_o,
    output logic [ 7:0] low_o,
    output logic [ 7:0] high_o,
    output logic [15:0] touches_o,
    output logic        inner_o,
    output logic [ 3:0] branches_o,
    output logic [ 7:0] pattern_o
);
  // Clock 1: inner pixels of four columns, newest in the high bits, and two rows above the centre;
  // the ring's pixels as they move along their rows.
  logic [11:0] inner_q;
  logic [2:0] top_q;
  logic [15:0] ring_q;
  logic right13_q, right3_q;
  logic [1:0] right12_q, right4_q;
  logic [2:0] right11_q, right5_q;
  logic [3:0] right10_q, right9_q, right8_q, right7_q, right6_q;
  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      inner_q <= {column_i[3:1], inner_q[11:3]};
      top_q   <= {column_i[0], top_q[2:1]};
      {ring_q[14], ring_q[15], ring_q[0], ring_q[1], ring_q[2]} <=
          {radial_i[0], radial_i[5], radial_i[7], radial_i[8], radial_i[10]};
      {right13_q, ring_q[13]} <= {radial_i[1], right13_q};
      {right12_q, ring_q[12]} <= {radial_i[2], right12_q};
      {right11_q, ring_q[11]} <= {radial_i[3], right11_q};
      {right10_q, ring_q[10]} <= {radial_i[4], right10_q};
      {right9_q, ring_q[9]}   <= {radial_i[6], right9_q};
      {right8_q, ring_q[8]}   <= {radial_i[7], right8_q};
      {right7_q, ring_q[7]}   <= {radial_i[9], right7_q};
      {right3_q, ring_q[3]}   <= {radial_i[11], right3_q};
      {right4_q, ring_q[4]}   <= {radial_i[12], right4_q};
      {right5_q, ring_q[5]}   <= {radial_i[13], right5_q};
      {right6_q, ring_q[6]}   <= {radial_i[14], right6_q};
    end
  end

  // Clock 2: where runs begin of the ring's pixels that count. Columns 1 .. 3 of the window are the
  // older three.
  function automatic logic touched(input logic [7:0] pixels, input int k);
    // Corners of the ring touch one inner pixel, middles of its sides three, the others two.
    case (k % 4)
      0: touched = pixels[(k/2+7)%8] || pixels[k/2] || pixels[k/2+1];
      2: touched = pixels[k/2];
      default: touched = pixels[k/2] || pixels[(k/2+1)%8];
    endcase
  endfunction
  logic [15:0] outer, starts_q;
  logic [7:0] inner, inner2_q;
  assign inner = {inner_q[6], inner_q[3], inner_q[0], inner_q[1], inner_q[2], inner_q[5],
                  inner_q[8], inner_q[7]};
  assign above_o = {inner_q[3], top_q[0]};
  for (genvar k = 0; k < 16; k++) begin : gen_ring
    assign outer[k] = ring_q[k] && (!Touching || touched(inner, k));
  end
  always_ff @(posedge clk_i) begin
    starts_q <= outer & ~{outer[14:0], outer[15]};
    inner2_q <= inner;
  end

  // Clocks 3, 4: first and last begin, number of branches. Neighbours never both begin a run, so
  // a quarter holds at most two.
  logic [7:0] count_q;
  logic [1:0] first_group, last_group;
  assign first_group = group_o[0] ? 2'd0 : group_o[1] ? 2'd1 : group_o[2] ? 2'd2 : 2'd3;
  assign last_group  = group_o[3] ? 2'd3 : group_o[2] ? 2'd2 : group_o[1] ? 2'd1 : 2'd0;
  always_ff @(posedge clk_i) begin
    for (int g = 0; g < 4; g++) begin
      group_o[g] <= starts_q[4*g+:4] != '0;
      low_o[2*g+:2] <= starts_q[4*g] ? 2'd0 : starts_q[4*g+1] ? 2'd1 : starts_q[4*g+2] ? 2'd2 : 2'd3;
      high_o[2*g+:2] <= starts_q[4*g+3] ? 2'd3 : starts_q[4*g+2] ? 2'd2 : starts_q[4*g+1] ? 2'd1
                                                                                          : 2'd0;
      count_q[2*g+:2] <= {1'b0, starts_q[4*g] || starts_q[4*g+1]} +
                         {1'b0, starts_q[4*g+2] || starts_q[4*g+3]};
    end
    for (int k = 0; k < 16; k++) touches_o[k] <= touched(inner2_q, k);
    inner_o <= inner2_q != '0;
    for (int g = 0; g < 3; g++) begin
      two_o[g] <= (starts_q[4*g] || starts_q[4*g+1]) && (starts_q[4*g+2] || starts_q[4*g+3]);
    end
    pattern_o <= group_o == '0 ? '0
        : {first_group, low_o[2*first_group+:2], last_group, high_o[2*last_group+:2]};
    branches_o <= ({2'b0, count_q[1:0]} + {2'b0, count_q[3:2]}) +
                  ({2'b0, count_q[5:4]} + {2'b0, count_q[7:6]});
  end
endmodule
