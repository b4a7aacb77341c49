// SPDX-License-Identifier: Apache-2.0
//
// gx = (H + 4 A) / 512, gy = (V + 4 B) / 512 in units of 2^-FractionBits grey level per px, rounded to
// nearest, halves away from zero: mirrored images have mirrored slopes.
//
//   h_i, v_i, a_i, b_i  see derivatives;  gx_o, gy_o  |.| < 88 grey levels per px
//
// Latency 2 clocks, 1 pixel per clock.
module slope_rounding #(
    parameter int FractionBits = 3
) (
    input  logic                           clk_i,
    input  logic signed [            14:0] h_i,
    input  logic signed [            14:0] v_i,
    input  logic signed [            13:0] a_i,
    input  logic signed [            13:0] b_i,
    output logic signed [FractionBits+7:0] gx_o,
    output logic signed [FractionBits+7:0] gy_o
);
  if (FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6 stop ();
  end
  localparam int Shift = 9 - FractionBits;
  localparam logic signed [16:0] Half = 17'(1 << (Shift - 1));

  logic signed [16:0] x_q, y_q;

  function automatic logic [FractionBits+7:0] rounded(input logic signed [16:0] sum);
    rounded = (FractionBits + 8)'((sum + Half - (sum < 0 ? 17'sd1 : 17'sd0)) >>> Shift);
  endfunction

  always_ff @(posedge clk_i) begin
    x_q  <= 17'(h_i) + 17'($signed({a_i, 2'b0}));
    y_q  <= 17'(v_i) + 17'($signed({b_i, 2'b0}));
    gx_o <= rounded(x_q);
    gy_o <= rounded(y_q);
  end
endmodule
