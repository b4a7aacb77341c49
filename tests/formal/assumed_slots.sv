// SPDX-License-Identifier: Apache-2.0
//
// Assumes that the input is any stream of row slots (slot_stream) of 5 or 6 px lines, with any pauses
// and resets at any time; a stream begins with column 0, the run with a reset.
//
//   width_o, col_o   as those of slot_stream
//   started_o        past the first clock: what is asserted holds from here
module assumed_slots #(
    parameter int Voids = 4
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic [2:0] width_i,
    input  logic       valid_i,
    input  logic       sol_i,
    input  logic       sof_i,
    input  logic       real_i,
    output logic       started_o,
    output logic [2:0] width_o,
    output logic [2:0] col_o
);
  logic started_q = 1'b0;
  logic begun_q, ok;
  slot_stream #(
      .Voids(Voids)
  ) i_stream (
      .clk_i,
      .rst_ni,
      .width_i,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .ok_o(ok),
      .width_o,
      .col_o
  );
  assign started_o = started_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
    assume (ok && (width_i == 3'd5 || width_i == 3'd6));
    assume (!valid_i || (rst_ni && (begun_q || sol_i)));
    begun_q <= rst_ni && (begun_q || valid_i);
  end
endmodule
