// SPDX-License-Identifier: Apache-2.0
//
// What a stream of row slots (see slot_tracker) is, as a monitor.
//
//   ok_o      the beat at the input keeps the rules below
//   width_o   width of the frame it belongs to; col_o its column (7 or more: 7)
//   width_i   width of a frame that begins
//
// The rules: a real row has as many beats as its frame's first. A frame begins with a row marked
// sof, and its rows follow each other. A void row may have another length, and the frame behind it
// another width, only when it and the Voids rows before it are void; a row of fewer than 3 beats
// needs one more (the rows of the next stage begin at the third beat, so that stage never sees it).
module slot_stream #(
    parameter int Voids = 4
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic [2:0] width_i,
    input  logic       valid_i,
    input  logic       sol_i,
    input  logic       sof_i,
    input  logic       real_i,
    output logic       ok_o,
    output logic [2:0] width_o,
    output logic [2:0] col_o
);
  localparam int VoidBits = $clog2(Voids + 3);
  localparam logic [VoidBits-1:0] Enough = VoidBits'(Voids + 1), Most = VoidBits'(Voids + 2);

  logic real_q;
  logic [2:0] col_q, width_q;      // columns so far: 7 is many
  logic [VoidBits-1:0] voids_q;    // void rows up to the current one
  logic free;
  assign col_o = sol_i ? 3'd0 : col_q;
  assign free = voids_q == Most || (voids_q == Enough && !(sol_i && col_q < 3'd3));
  assign width_o = valid_i && sol_i && free ? width_i : width_q;
  assign ok_o = !valid_i || (sol_i ? (col_q == width_q || free) && (!real_i || sof_i || real_q)
                                   : col_q < width_q || free);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {real_q, col_q} <= '0;
      voids_q <= Most;
    end else if (valid_i) begin
      width_q <= width_o;
      col_q   <= sol_i ? 3'd1 : col_q == 3'd7 ? 3'd7 : col_q + 3'd1;
      if (sol_i) begin
        real_q  <= real_i;
        voids_q <= real_i ? '0 : voids_q == Most ? Most : voids_q + VoidBits'(1);
      end
    end
  end
endmodule
