// SPDX-License-Identifier: Apache-2.0
//
// What a stream of row slots (see slot_tracker) is, as a monitor.
//
//   width_i   the two widths, the first in the low bits
//   ok_o      the beat at the input keeps the rules below
//   kind_o    of its row: 0 void, 1 of the first width, 2 of the second;  col_o its column (7 or more: 7)
//   age_o     slots since the last row of each width, its own being 0 (most: Voids + 2), the first in the low bits
//   may_change_o   the widths that may change with this clock
//
// The rules: a frame begins with a row marked first, and its rows follow each other. A slot has at least as
// many beats as its row, and as each of the Voids rows before it; not more than MaxWidthPx (6 here). A width
// may change, and a void slot be shorter or longer, only when no row of it, of any, is among the Voids before;
// a slot of fewer than 3 beats needs one more (the slots of the next stage begin at the third beat, so that
// stage never sees it).
module slot_stream #(
    parameter int Voids = 4
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic [5:0] width_i,
    input  logic       valid_i,
    input  logic       sol_i,
    input  logic       sof_i,
    input  logic       real_i,
    output logic       ok_o,
    output logic [1:0] kind_o,
    output logic [2:0] col_o,
    output logic [7:0] age_o,
    output logic [1:0] may_change_o
);
  localparam logic [3:0] Enough = 4'(Voids + 1), Most = 4'(Voids + 2);

  logic [1:0] kind_q;
  logic [2:0] col_q;  // columns so far: 7 is many
  logic [7:0] age_q;
  logic [1:0] free, follows;
  assign col_o = sol_i ? 3'd0 : col_q;
  always_comb begin
    kind_o = kind_q;
    if (valid_i && sol_i) kind_o = sof_i ? {!real_i, real_i} : real_i ? kind_q : 2'd0;
    age_o = age_q;
    for (int t = 0; t < 2; t++) begin
      free[t] = age_q[4*t+:4] == Most || (age_q[4*t+:4] == Enough && !(sol_i && col_q < 3'd3));
      if (valid_i && sol_i) begin
        age_o[4*t+:4] = kind_o[t] ? 4'd0 : age_q[4*t+:4] == Most ? Most : age_q[4*t+:4] + 4'd1;
      end
      follows[t] = free[t] || col_q >= width_i[3*t+:3];
      may_change_o[t] = age_q[4*t+:4] == Most && age_o[4*t+:4] != 4'd0;
    end
  end
  assign ok_o = !valid_i || (sol_i ? &follows && (sof_i || !real_i || kind_q != 2'd0)
                                   : col_q < 3'd6 || &free);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {kind_q, col_q} <= '0;
      age_q <= {2{Most}};
    end else if (valid_i) begin
      kind_q <= kind_o;
      age_q  <= age_o;
      col_q  <= sol_i ? 3'd1 : col_q == 3'd7 ? 3'd7 : col_q + 3'd1;
    end
  end
endmodule
