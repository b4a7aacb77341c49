// SPDX-License-Identifier: Apache-2.0
//
// A stream that must behave like a queue of at most Depth entries: what goes in comes out once,
// in order, and an offered entry stays until it is taken. The design starts with a reset.
module queue_properties #(
    parameter int Width = 2,
    parameter int Depth = 2
) (
    input logic             clk_i,
    input logic             rst_ni,
    input logic             push_i,
    input logic [Width-1:0] data_i,
    input logic             valid_i,
    input logic             ready_i,
    input logic [Width-1:0] data_out_i
);
  logic started_q = 1'b0;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
  end

  // Oldest entry in the low bits.
  localparam int CountBits = $clog2(Depth + 1);
  logic [CountBits-1:0] count_q, count_popped;
  logic [Depth*Width-1:0] entries_q, entries_popped;
  logic pop, held_q;
  logic [Width-1:0] held_data_q;
  assign pop = valid_i && ready_i;
  assign count_popped = count_q - CountBits'(pop);
  assign entries_popped = pop ? entries_q >> Width : entries_q;

  always_ff @(posedge clk_i) begin
    held_q <= rst_ni && valid_i && !ready_i;
    held_data_q <= data_out_i;
    for (int i = 0; i < Depth; i++) begin
      entries_q[i*Width+:Width] <= push_i && count_popped == CountBits'(i)
                                       ? data_i : entries_popped[i*Width+:Width];
    end
    count_q <= rst_ni ? count_popped + CountBits'(push_i) : '0;
    if (started_q && rst_ni) begin
      assert (!valid_i || (count_q != '0 && data_out_i == entries_q[Width-1:0]));
      assert (!push_i || count_q != CountBits'(Depth));
      assert (!held_q || (valid_i && data_out_i == held_data_q));
    end
  end
endmodule
