// SPDX-License-Identifier: Apache-2.0
//
// Whether a pixel is above its window's mean: of the pixels that are not above it.
//
// With c the magnitude of the centre and n those of the 24 other pixels:
//
//   above = 32 sum{n <= c} n < mean_limit c count{n <= c}
//
// Each n is lifted by C = highest magnitude - c: n > c when n + C overflows, and what is left is kept:
// 32 sum{n + C} < (mean_limit c + 32 C) count.
//
//   mean_limit_i     threshold
//   window_i         pixel (column i, row j) at bit (5 i + j) MagnitudeBits
//   lift_i           C, the centre inverted
//   above_o          7 clocks later
//
// 1 window per clock.
module neighbour_mean #(
    parameter int MagnitudeBits = 9  // 6 .. 12
) (
    input  logic                        clk_i,
    input  logic [                 4:0] mean_limit_i,
    input  logic [25*MagnitudeBits-1:0] window_i,
    input  logic [   MagnitudeBits-1:0] lift_i,
    output logic                        above_o
);
  if (MagnitudeBits < 6 || MagnitudeBits > 12) begin : gen_illegal
    illegal_MagnitudeBits_must_be_6_to_12 stop ();
  end
  localparam int M = MagnitudeBits;
  logic [M-1:0] centre;
  assign centre = window_i[12*M+:M];

  // Clocks 1-6: sum (clock 6) and count (clock 3) of the neighbours that are not above the centre.
  logic [24*M-1:0] kept_q;
  logic [23:0] keeps_q;
  logic [12*(M+1)-1:0] sum12_q;
  logic [6*(M+2)-1:0] sum6_q;
  logic [3*(M+3)-1:0] sum3_q;
  logic [M+3:0] sum2_q;
  logic [M+2:0] sum1_q;
  logic [M+4:0] not_sum_q;
  logic [17:0] count6_q;
  logic [4:0] count_q;

  logic [24*(M+1)-1:0] lifted;
  for (genvar i = 0; i < 24; i++) begin : gen_lifted
    assign lifted[i*(M+1)+:M+1] = {1'b0, window_i[(i<12?i:i+1)*M+:M]} + {1'b0, lift_i};
  end

  always_ff @(posedge clk_i) begin
    for (int i = 0; i < 24; i++) begin
      keeps_q[i]     <= !lifted[i*(M+1)+M];
      kept_q[i*M+:M] <= lifted[i*(M+1)+M] ? '0 : lifted[i*(M+1)+:M];
    end
    for (int i = 0; i < 12; i++) begin
      sum12_q[i*(M+1)+:M+1] <= (M + 1)'(kept_q[2*i*M+:M]) + (M + 1)'(kept_q[(2*i+1)*M+:M]);
    end
    for (int i = 0; i < 6; i++) begin
      count6_q[3*i+:3] <= 3'(keeps_q[4*i]) + 3'(keeps_q[4*i+1]) + 3'(keeps_q[4*i+2]) +
                          3'(keeps_q[4*i+3]);
      sum6_q[i*(M+2)+:M+2] <= (M + 2)'(sum12_q[2*i*(M+1)+:M+1]) +
                              (M + 2)'(sum12_q[(2*i+1)*(M+1)+:M+1]);
    end
    for (int i = 0; i < 3; i++) begin
      sum3_q[i*(M+3)+:M+3] <= (M + 3)'(sum6_q[2*i*(M+2)+:M+2]) +
                              (M + 3)'(sum6_q[(2*i+1)*(M+2)+:M+2]);
    end
    sum2_q       <= (M + 4)'(sum3_q[0+:M+3]) + (M + 4)'(sum3_q[M+3+:M+3]);
    sum1_q       <= sum3_q[2*(M+3)+:M+3];
    not_sum_q    <= ~((M + 5)'(sum2_q) + (M + 5)'(sum1_q));
    count_q      <= ((5'(count6_q[0+:3]) + 5'(count6_q[3+:3])) +
                     (5'(count6_q[6+:3]) + 5'(count6_q[9+:3]))) +
                    (5'(count6_q[12+:3]) + 5'(count6_q[15+:3]));
  end

  // Clocks 1-6: (mean_limit c + 32 C) count.
  logic [M+4:0] limit;
  logic [M+9:0] bound;
  scale5 #(
      .Width(M)
  ) i_limit (
      .clk_i,
      .value_i  (centre),
      .factor_i (mean_limit_i),
      .offset_i (lift_i),
      .product_o(limit)
  );
  scale5 #(
      .Width(M + 5)
  ) i_bound (
      .clk_i,
      .value_i  (limit),
      .factor_i (count_q),
      .offset_i ({(M + 5) {1'b0}}),
      .product_o(bound)
  );

  // Clock 7: bound > 32 sum, by the carry of a sum.
  logic [M+10:0] margin;
  assign margin = {1'b0, bound} + {1'b0, not_sum_q, 5'b11111};
  always_ff @(posedge clk_i) above_o <= margin[M+10];
endmodule
