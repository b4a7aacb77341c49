// SPDX-License-Identifier: Apache-2.0
//
// The directions of the first, the second and the last branch around a window's centre.
//
//   valid_i, column_i   newest column of the window: directions {class, sector} of rows 0 .. 4, row 0
//                       lowest; 3 clocks before the window's branches
//   group_i .. touches_i   branches of the window, see vertex_ring; low_i, high_i count within the
//                       quarter
//   first_o, second_o, last_o   2 clocks later: {touched by an inner branch pixel, direction} of the
//                       branch's pixel; of no meaning where there are fewer branches
//
// First within each quarter of the ring, then among the quarters. 1 window per clock.
module vertex_branches (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic        valid_i,
    input  logic [34:0] column_i,
    input  logic [ 3:0] group_i,
    input  logic [ 2:0] two_i,
    input  logic [ 7:0] low_i,
    input  logic [ 7:0] high_i,
    input  logic [15:0] touches_i,
    output logic [ 7:0] first_o,
    output logic [ 7:0] second_o,
    output logic [ 7:0] last_o
);
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

  logic valid_late;
  logic [34:0] column_late;
  logic [174:0] window_q;
  logic [127:0] places;
  delay_line #(
      .Width (36),
      .Clocks(2)
  ) i_column (
      .clk_i,
      .rst_ni,
      .data_i({valid_i, column_i}),
      .data_o({valid_late, column_late})
  );
  always_ff @(posedge clk_i) begin
    if (valid_late) window_q <= {column_late, window_q[174:35]};
  end
  for (genvar k = 0; k < 16; k++) begin : gen_places
    assign places[8*k+:8] = {touches_i[k], window_q[7*ring(k)+:7]};
  end

  // Clock 1: of each quarter the first branch and the last.
  logic [31:0] lows_q, highs_q;
  logic [3:0] group_q;
  logic [2:0] two_q;
  function automatic logic [7:0] pick(input logic [31:0] quarter, input logic [1:0] k);
    case (k)
      2'd0: pick = quarter[7:0];
      2'd1: pick = quarter[15:8];
      2'd2: pick = quarter[23:16];
      default: pick = quarter[31:24];
    endcase
  endfunction
  always_ff @(posedge clk_i) begin
    group_q <= group_i;
    two_q   <= two_i;
    for (int g = 0; g < 4; g++) begin
      lows_q[8*g+:8]  <= pick(places[32*g+:32], low_i[2*g+:2]);
      highs_q[8*g+:8] <= pick(places[32*g+:32], high_i[2*g+:2]);
    end
  end

  // Clock 2. The second branch is the last of the first quarter that has two, or the first of the
  // second quarter that has any; quarter 0 .. 2 know whether they have two, of the last it follows.
  always_ff @(posedge clk_i) begin
    if (group_q[0]) first_o <= lows_q[7:0];
    else if (group_q[1]) first_o <= lows_q[15:8];
    else if (group_q[2]) first_o <= lows_q[23:16];
    else first_o <= lows_q[31:24];
    if (group_q[3]) last_o <= highs_q[31:24];
    else if (group_q[2]) last_o <= highs_q[23:16];
    else if (group_q[1]) last_o <= highs_q[15:8];
    else last_o <= highs_q[7:0];
    if (group_q[0] && two_q[0]) second_o <= highs_q[7:0];
    else if (group_q[0] ? group_q[1] : two_q[1]) begin
      second_o <= group_q[0] ? lows_q[15:8] : highs_q[15:8];
    end else if (group_q[1:0] != '0 ? group_q[2] : two_q[2]) begin
      second_o <= group_q[1:0] != '0 ? lows_q[23:16] : highs_q[23:16];
    end else begin
      second_o <= group_q[2:0] != '0 ? lows_q[31:24] : highs_q[31:24];
    end
  end
endmodule
