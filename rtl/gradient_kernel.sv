// SPDX-License-Identifier: Apache-2.0
//
// Gradient vector and magnitude of a 5x5 window of pixels.
//
//   gx = (H + 8 A) / 1024, gy = (V + 8 B) / 1024                  see derivatives
//   magnitude = min((|H| + |V| + 4 |D| + 4 |E|) / 1024, 64 - 1/scale), |D| + |E| = max(|A|, |B|)
//
// in units of 1/scale grey level per px, scale = 2^FractionBits, each rounded to nearest, halves
// away from zero: mirrored images have mirrored gradients.
//
//   valid_i, column_i  newest column of the window, oldest row in the low byte
//   gx_o, gy_o         6 clocks later, |.| < 96 grey levels per px
//   magnitude_o        8 clocks later
//
// 1 beat per clock; the centre is two columns behind.
module gradient_kernel #(
    parameter int FractionBits = 3
) (
    input  logic                           clk_i,
    input  logic                           valid_i,
    input  logic        [            39:0] column_i,
    output logic signed [FractionBits+7:0] gx_o,
    output logic signed [FractionBits+7:0] gy_o,
    output logic        [FractionBits+5:0] magnitude_o
);
  if (FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6 stop ();
  end
  localparam int M = 6 + FractionBits;
  localparam int Shift = 10 - FractionBits;
  localparam logic signed [17:0] Half = 18'(1 << (Shift - 1));

  logic signed [15:0] h, v;
  logic signed [14:0] a, b;
  derivatives i_derivatives (
      .clk_i,
      .valid_i,
      .column_i,
      .h_o(h),
      .v_o(v),
      .a_o(a),
      .b_o(b)
  );

  // Clocks 5, 6: the vector.
  logic signed [17:0] x_q, y_q;
  function automatic logic [FractionBits+7:0] rounded(input logic signed [17:0] sum);
    rounded = (FractionBits + 8)'((sum + Half - (sum < 0 ? 18'sd1 : 18'sd0)) >>> Shift);
  endfunction
  always_ff @(posedge clk_i) begin
    x_q  <= 18'(h) + 18'($signed({a, 3'b0}));
    y_q  <= 18'(v) + 18'($signed({b, 3'b0}));
    gx_o <= rounded(x_q);
    gy_o <= rounded(y_q);
  end

  // Clocks 5-8: the magnitude.
  logic [14:0] abs_h_q, abs_v_q;
  logic [13:0] abs_a_q, abs_b_q, diagonal_q;
  logic [15:0] straight_q;
  logic [16:0] sum_q;
  logic [16-Shift:0] units;
  assign units = (17 - Shift)'((sum_q + 17'(1 << (Shift - 1))) >> Shift);
  function automatic logic [14:0] absolute(input logic signed [15:0] value);
    absolute = value[15] ? 15'(-value) : value[14:0];
  endfunction
  always_ff @(posedge clk_i) begin
    abs_h_q     <= absolute(h);
    abs_v_q     <= absolute(v);
    abs_a_q     <= 14'(absolute(16'(a)));
    abs_b_q     <= 14'(absolute(16'(b)));
    straight_q  <= 16'(abs_h_q) + 16'(abs_v_q);
    diagonal_q  <= abs_a_q > abs_b_q ? abs_a_q : abs_b_q;
    sum_q       <= 17'(straight_q) + {1'b0, diagonal_q, 2'b0};
    magnitude_o <= |units[16-Shift:M] ? '1 : units[M-1:0];
  end
endmodule
