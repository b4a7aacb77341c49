// SPDX-License-Identifier: Apache-2.0
//
// data_o(t) = data_i(t - Clocks), without reset: what counts only with a valid bit that has one.
//
// A device with shift registers in LUTs takes one LUT per bit; one without needs no reset in them.
//
//   data_i, data_o  payload
module payload_delay #(
    parameter int Width  = 1,  // payload, bits
    parameter int Clocks = 1   // 1 ..
) (
    input  logic             clk_i,
    input  logic [Width-1:0] data_i,
    output logic [Width-1:0] data_o
);
  if (Width < 1 || Clocks < 1) begin : gen_illegal
    illegal_Width_and_Clocks_must_be_at_least_1 stop ();
  end

  logic [(Clocks+1)*Width-1:0] pipe;
  logic [Clocks*Width-1:0] pipe_q;
  assign pipe = {pipe_q, data_i};
  assign data_o = pipe[Clocks*Width+:Width];
  always_ff @(posedge clk_i) pipe_q <= pipe[Clocks*Width-1:0];
endmodule
