// SPDX-License-Identifier: Apache-2.0
//
// Whether the columns of a slot belong to a row that may be shorter than the slot.
//
//   valid_i, sol_i, col_i  beat, its first, column
//   before_last_i, second_i   both widths - 2, the first in the low bits, and which one the row has;
//                          in time for column 2
//   within_o               in the same clock: col_i < width
module row_limit #(
    parameter int ColBits = 11  // of a column, 3 .. 12
) (
    input  logic                 clk_i,
    input  logic                 valid_i,
    input  logic                 sol_i,
    input  logic [  ColBits-1:0] col_i,
    input  logic [2*ColBits-1:0] before_last_i,
    input  logic                 second_i,
    output logic                 within_o
);
  if (ColBits < 3 || ColBits > 12) begin : gen_illegal
    illegal_ColBits_3_to_12 stop ();
  end

  logic last_q, beyond_q;  // the next beat is the row's last, lies beyond it
  logic [ColBits-1:0] limit_q;
  assign within_o = sol_i || !beyond_q;
  always_ff @(posedge clk_i) begin
    limit_q <= second_i ? before_last_i[ColBits+:ColBits] : before_last_i[ColBits-1:0];
    if (valid_i) begin
      last_q   <= !sol_i && col_i == limit_q;
      beyond_q <= !sol_i && (beyond_q || last_q);
    end
  end
endmodule
