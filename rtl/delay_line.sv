// SPDX-License-Identifier: Apache-2.0
//
// data_o(t) = data_i(t - Clocks): keeps side data in step with a kernel's arithmetic.
//
//   data_i, data_o  payload; after reset data_o is 0 for Clocks clocks
module delay_line #(
    parameter int Width  = 1,  // payload, bits
    parameter int Clocks = 1   // 1 ..
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic [Width-1:0] data_i,
    output logic [Width-1:0] data_o
);
  if (Width < 1 || Clocks < 1) begin : gen_illegal
    illegal_Width_and_Clocks_must_be_at_least_1 stop ();
  end

  logic [Clocks*Width-1:0] pipe_q;

  assign data_o = pipe_q[Clocks*Width-1-:Width];

  if (Clocks == 1) begin : gen_one
    always_ff @(posedge clk_i) pipe_q <= rst_ni ? data_i : '0;
  end else begin : gen_more
    always_ff @(posedge clk_i) begin
      pipe_q <= rst_ni ? {pipe_q[(Clocks-1)*Width-1:0], data_i} : '0;
    end
  end
endmodule
