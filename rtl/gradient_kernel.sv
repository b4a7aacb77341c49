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
//   inside_i           7 clocks later: 0 makes this window's magnitude 0
//   gx_o, gy_o         6 clocks later, |.| < 96 grey levels per px
//   magnitude_o        8 clocks later
//
// 1 beat per clock; the centre is two columns behind.
module gradient_kernel #(
    parameter int FractionBits = 3  // of the gradient, 0 .. 6
) (
    input  logic                           clk_i,
    input  logic                           valid_i,
    input  logic        [            39:0] column_i,
    input  logic                           inside_i,
    output logic signed [FractionBits+7:0] gx_o,
    output logic signed [FractionBits+7:0] gy_o,
    output logic        [FractionBits+5:0] magnitude_o
);
  if (FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6 stop ();
  end
  localparam int M = 6 + FractionBits;
  localparam int Shift = 10 - FractionBits;

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
    logic signed [17:0] raised;
    // One half, or less by the smallest bit if negative.
    raised  = sum + $signed(18'({!sum[17], {(Shift - 1) {sum[17]}}}));
    rounded = (FractionBits + 8)'(raised >>> Shift);
  endfunction
  always_ff @(posedge clk_i) begin
    x_q  <= 18'(h) + 18'($signed({a, 3'b0}));
    y_q  <= 18'(v) + 18'($signed({b, 3'b0}));
    gx_o <= rounded(x_q);
    gy_o <= rounded(y_q);
  end

  // Clocks 5-8: the magnitude. A negative value's bits are inverted, which leaves its absolute
  // value 1 too small; those ones join the sum at the end.
  logic [14:0] h5_q, v5_q;
  logic [14:0] not_a5_q, b5_q, diagonal6_q;  // lowest bit: 1 too small
  logic [14:0] unused_difference;
  logic b_larger;
  assign {b_larger, unused_difference} = {1'b0, b5_q} + {1'b0, not_a5_q};
  logic h_negative5_q, v_negative5_q, h_negative6_q, v_negative6_q;
  logic [1:0] missing7_q;
  logic [15:0] straight6_q;
  logic [16:0] sum7_q;
  logic [16-Shift:0] units;
  assign units = (17 - Shift)'((sum7_q + 17'((1 << (Shift - 1)) + 32'(missing7_q))) >> Shift);
  always_ff @(posedge clk_i) begin
    h5_q <= h[14:0] ^ {15{h[15]}};
    v5_q <= v[14:0] ^ {15{v[15]}};
    not_a5_q <= ~{a[13:0] ^ {14{a[14]}}, a[14]};
    b5_q <= {b[13:0] ^ {14{b[14]}}, b[14]};
    {h_negative5_q, v_negative5_q} <= {h[15], v[15]};

    straight6_q <= 16'(h5_q) + 16'(v5_q);
    diagonal6_q <= b_larger ? b5_q : ~not_a5_q;
    {h_negative6_q, v_negative6_q} <= {h_negative5_q, v_negative5_q};

    sum7_q     <= 17'(straight6_q) + {1'b0, diagonal6_q, diagonal6_q[0]};
    missing7_q <= 2'(h_negative6_q) + 2'(v_negative6_q) + 2'(diagonal6_q[0]);

    magnitude_o <= !inside_i ? '0 : |units[16-Shift:M] ? '1 : units[M-1:0];
  end
endmodule
