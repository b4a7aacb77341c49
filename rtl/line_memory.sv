// SPDX-License-Identifier: Apache-2.0
//
// One write port, one read port, one clock: rdata_o(t+1) = memory[raddr_i(t)].
//
// Every tool infers block RAM from it; an ASIC flow replaces it by an SRAM macro. What is
// read from an address in the clock in which it is written is undefined; no user looks at it.
//
//   wen_i, waddr_i, wdata_i  write port
//   raddr_i, rdata_o         read port, latency 1 clock
module line_memory #(
    parameter int Width = 8,   // bits per word
    parameter int Depth = 512  // words
) (
    input  logic                     clk_i,
    input  logic                     wen_i,
    input  logic [$clog2(Depth)-1:0] waddr_i,
    input  logic [        Width-1:0] wdata_i,
    input  logic [$clog2(Depth)-1:0] raddr_i,
    output logic [        Width-1:0] rdata_o
);
  if (Width < 1 || Depth < 2) begin : gen_illegal
    illegal_Width_must_be_at_least_1_and_Depth_at_least_2 stop ();
  end

  (* no_rw_check *) logic [Width-1:0] memory[Depth];

  always_ff @(posedge clk_i) begin
    if (wen_i) memory[waddr_i] <= wdata_i;
    rdata_o <= memory[raddr_i];
  end
endmodule
