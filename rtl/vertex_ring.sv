// SPDX-License-Identifier: Apache-2.0
//
// The branches that leave a 5x5 window: runs on its ring of 16, see vertex_value.
//
//   valid_i, column_i  newest column of branch pixels, oldest row in bit 0
//   above_o            1 clock later: the centre (bit 2) and the pixels one and two above it
//   group_o, low_o, high_o   3 clocks later: per quarter of the ring (4 pixels from the right
//                      towards below) whether a branch begins there, the first and the last
//   branches_o, pattern_o    4 clocks later: branches 0 .. 8, {first, last} branch
//   junction_o         5 clocks later: strength if it is a junction, as the code 49 or 58 (exact)
//                      - (|X| + |Y|), see vertex_value
//
// 1 beat per clock; the centre is two columns behind.
module vertex_ring (
    input  logic       clk_i,
    input  logic       valid_i,
    input  logic [4:0] column_i,
    output logic [2:0] above_o,
    output logic [3:0] group_o,
    output logic [7:0] low_o,
    output logic [7:0] high_o,
    output logic [3:0] branches_o,
    output logic [7:0] pattern_o,
    output logic [5:0] junction_o
);
  // Clock 1: the window, pixel (column i, row j) at bit 5 i + j.
  logic [24:0] w_q;
  always_ff @(posedge clk_i) if (valid_i) w_q <= {column_i, w_q[24:5]};

  assign above_o = w_q[12:10];

  // Clock 2: where runs begin, of the inner pixels and of the outer ones that touch an inner one.
  // Both rings run from the right towards below.
  logic [15:0] outer, starts_q;
  logic [7:0] inner, inner_starts_q;
  assign inner = {w_q[16], w_q[11], w_q[6], w_q[7], w_q[8], w_q[13], w_q[18], w_q[17]};
  assign outer[0] = w_q[22] && (inner[7] || inner[0] || inner[1]);
  assign outer[1] = w_q[23] && (inner[0] || inner[1]);
  assign outer[2] = w_q[24] && inner[1];
  assign outer[3] = w_q[19] && (inner[1] || inner[2]);
  assign outer[4] = w_q[14] && (inner[1] || inner[2] || inner[3]);
  assign outer[5] = w_q[9] && (inner[2] || inner[3]);
  assign outer[6] = w_q[4] && inner[3];
  assign outer[7] = w_q[3] && (inner[3] || inner[4]);
  assign outer[8] = w_q[2] && (inner[3] || inner[4] || inner[5]);
  assign outer[9] = w_q[1] && (inner[4] || inner[5]);
  assign outer[10] = w_q[0] && inner[5];
  assign outer[11] = w_q[5] && (inner[5] || inner[6]);
  assign outer[12] = w_q[10] && (inner[5] || inner[6] || inner[7]);
  assign outer[13] = w_q[15] && (inner[6] || inner[7]);
  assign outer[14] = w_q[20] && inner[7];
  assign outer[15] = w_q[21] && (inner[7] || inner[0]);
  always_ff @(posedge clk_i) begin
    starts_q       <= outer & ~{outer[14:0], outer[15]};
    inner_starts_q <= inner & ~{inner[6:0], inner[7]};
  end

  // Clocks 3, 4: first and last begin, number of branches. Neighbours never both begin a run, so
  // a quarter holds at most two.
  logic [7:0] count_q;
  logic exact3_q, exact4_q;
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
    // Three or four of the eight: at most one of each neighbouring pair begins a run.
    exact3_q <= ((|inner_starts_q[1:0]) && (|inner_starts_q[3:2]) && (|inner_starts_q[7:4])) ||
                ((|inner_starts_q[3:0]) && (|inner_starts_q[5:4]) && (|inner_starts_q[7:6]));

    pattern_o  <= {first_group, low_o[2*first_group+:2], last_group, high_o[2*last_group+:2]};
    branches_o <= ({2'b0, count_q[1:0]} + {2'b0, count_q[3:2]}) +
                  ({2'b0, count_q[5:4]} + {2'b0, count_q[7:6]});
    exact4_q   <= exact3_q;
  end

  // Clocks 3-5: junction.
  logic signed [2:0] x_far_q, y_far_q, x_near_q, y_near_q;
  logic signed [4:0] x, y;
  logic [3:0] x_size_q, y_size_q;
  function automatic logic signed [2:0] balance(input logic [4:0] plus, input logic [4:0] minus);
    // At most three of five ring pixels in a row begin runs.
    balance = $signed({1'b0, 2'(plus[0] || plus[1]) + 2'(plus[2] || plus[3]) + 2'(plus[4])}) -
              $signed({1'b0, 2'(minus[0] || minus[1]) + 2'(minus[2] || minus[3]) + 2'(minus[4])});
  endfunction
  assign x = 5'($signed({x_far_q, 1'b0})) + 5'(x_near_q);
  assign y = 5'($signed({y_far_q, 1'b0})) + 5'(y_near_q);
  always_ff @(posedge clk_i) begin
    x_far_q  <= balance({starts_q[2:0], starts_q[15:14]}, starts_q[10:6]);
    y_far_q  <= balance(starts_q[6:2], starts_q[14:10]);
    x_near_q <= $signed({2'b0, starts_q[3]} + {2'b0, starts_q[13]}) -
                $signed({2'b0, starts_q[5]} + {2'b0, starts_q[11]});
    y_near_q <= $signed({2'b0, starts_q[1]} + {2'b0, starts_q[7]}) -
                $signed({2'b0, starts_q[9]} + {2'b0, starts_q[15]});
    x_size_q <= x[4] ? 4'(-x) : x[3:0];
    y_size_q <= y[4] ? 4'(-y) : y[3:0];
    junction_o <= (exact4_q ? 6'd58 : 6'd49) - (6'(x_size_q) + 6'(y_size_q));
  end
endmodule
