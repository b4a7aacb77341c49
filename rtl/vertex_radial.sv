// SPDX-License-Identifier: Apache-2.0
//
// Which branch pixels of a column run along the radius of their places on the ring of 5x5 pixels: the
// direction is within 35 degrees of the perpendicular to the position. 1/64 turn is a sector of
// directions, 32 of them a half turn.
//
//   on_i, sectors_i   branch pixels of rows 0 .. 4, and the sectors of their directions, row 0 lowest
//   radial_o          as vertex_ring takes it: bits 0-4 row 0 in ring pixels 14, 13, 12, 11, 10;
//                     5, 6 row 1 in 15, 9; 7 row 2 in 0, 8; 8, 9 row 3 in 1, 7; 10-14 row 4 in
//                     2, 3, 4, 5, 6
//
// Combinational.
module vertex_radial (
    input  logic [ 4:0] on_i,
    input  logic [24:0] sectors_i,
    output logic [14:0] radial_o
);
  // The sectors along the radius of ring pixel k are centred at 16 + 4 k, for odd k at 16 + 4.7 and
  // 16 + 11.3 and so on; all are the same 12 or 13 sectors, moved on.
  function automatic logic along(input logic [4:0] sector, input int k);
    logic [4:0] moved;
    moved = sector - 5'(10 + 4 * k);
    along = k % 4 == 3 ? moved == 5'd31 || moved < 5'd12 : moved < (k % 4 == 1 ? 5'd13 : 5'd12);
  endfunction

  for (genvar i = 0; i < 5; i++) begin : gen_columns
    assign radial_o[i]    = on_i[0] && along(sectors_i[4:0], 14 - i);
    assign radial_o[10+i] = on_i[4] && along(sectors_i[24:20], 2 + i);
  end
  assign radial_o[9:5] = {on_i[3] && along(sectors_i[19:15], 7),
                          on_i[3] && along(sectors_i[19:15], 1),
                          on_i[2] && along(sectors_i[14:10], 0),
                          on_i[1] && along(sectors_i[9:5], 9),
                          on_i[1] && along(sectors_i[9:5], 15)};
endmodule
