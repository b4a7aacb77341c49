// SPDX-License-Identifier: Apache-2.0
//
// A line_memory whose words a property can name: words_q, word k at bit Width k.
module line_memory #(
    parameter int Width = 8,
    parameter int Depth = 512
) (
    input  logic                     clk_i,
    input  logic                     wen_i,
    input  logic [$clog2(Depth)-1:0] waddr_i,
    input  logic [        Width-1:0] wdata_i,
    input  logic [$clog2(Depth)-1:0] raddr_i,
    output logic [        Width-1:0] rdata_o
);
  logic [Width*Depth-1:0] words_q;
  always_ff @(posedge clk_i) begin
    for (int k = 0; k < Depth; k++) begin
      if (wen_i && 32'(waddr_i) == k) words_q[Width*k+:Width] <= wdata_i;
    end
    rdata_o <= Width'(words_q >> (Width * 32'(raddr_i)));
  end
endmodule
