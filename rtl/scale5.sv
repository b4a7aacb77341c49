// SPDX-License-Identifier: Apache-2.0
//
// product_o = value_i * factor_i + 32 * offset_i by shift and add, without DSP blocks.
//
// It must fit Width + 5 bits.
//
// Latency 3 clocks, 1 product per clock.
module scale5 #(
    parameter int Width = 9  // value, bits
) (
    input  logic             clk_i,
    input  logic [Width-1:0] value_i,
    input  logic [      4:0] factor_i,
    input  logic [Width-1:0] offset_i,
    output logic [Width+4:0] product_o
);
  if (Width < 1) begin : gen_illegal
    illegal_Width_must_be_at_least_1 stop ();
  end

  logic [Width+1:0] low_q, low_late_q, high_q;
  logic [Width:0] top_q;
  logic [Width+4:0] upper_q;

  always_ff @(posedge clk_i) begin
    low_q <= (factor_i[0] ? (Width + 2)'(value_i) : '0) +
             (factor_i[1] ? {1'b0, value_i, 1'b0} : '0);
    high_q <= (factor_i[2] ? (Width + 2)'(value_i) : '0) +
              (factor_i[3] ? {1'b0, value_i, 1'b0} : '0);
    top_q      <= (factor_i[4] ? (Width + 1)'(value_i) : '0) + {offset_i, 1'b0};
    low_late_q <= low_q;
    upper_q    <= {top_q, 4'b0} + {1'b0, high_q, 2'b0};
    product_o  <= upper_q + (Width + 5)'(low_late_q);
  end
endmodule
