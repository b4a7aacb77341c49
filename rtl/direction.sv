// SPDX-License-Identifier: Apache-2.0
//
// What stage 4 keeps of a pixel: class of its magnitude and sector of its gradient's direction.
//
//   class   0 below floor, 1 below 3/2 of it, 2 below 5/2, 3 above
//   sector  modulo a half turn, 0 .. 31, 1/64 turn each, from the direction of x towards that of y;
//           within an octant the thresholds t of 6 13 19 27 34 43 53, 64 tan(k 5.625 deg), that
//           64 min(|gx|, |gy|) >= t max(|gx|, |gy|) reaches
//
//   branch_floor_i  threshold, 1 ..
//   valid_i, data_i {magnitude, gy, gx}, first_i one that is valid and a frame's first
//   valid_o, data_o {class, sector}, 0 for class 0; first_o
//
// Latency 6 clocks, 1 pixel per clock.
module direction #(
    parameter int FractionBits = 3  // of the gradient, 0 .. 6
) (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic [   FractionBits+5:0] branch_floor_i,
    input  logic                       valid_i,
    input  logic                       first_i,
    input  logic [3*FractionBits+21:0] data_i,
    output logic                       valid_o,
    output logic                       first_o,
    output logic [                6:0] data_o
);
  if (FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6 stop ();
  end
  localparam int M = 6 + FractionBits;
  localparam int S = 8 + FractionBits;
  localparam int A = S - 1;  // |gx|, |gy| < 96 scale
  localparam int T = A + 6;  // 53 |gx|

  logic signed [S-1:0] gx, gy;
  logic [M-1:0] magnitude;
  assign {magnitude, gy, gx} = data_i;

  // Clock 1: quadrants start on the axes x, y, -x, -y and each holds its own axis; those of y are
  // odd, and opposite ones are one.
  logic [A-1:0] ax_q, ay_q;
  logic odd_q, x_pos, x_neg, y_pos, y_neg;
  assign x_neg = gx[S-1];
  assign y_neg = gy[S-1];
  assign x_pos = !x_neg && gx != '0;
  assign y_pos = !y_neg && gy != '0;
  always_ff @(posedge clk_i) begin
    ax_q  <= x_neg ? A'(-gx) : gx[A-1:0];
    ay_q  <= y_neg ? A'(-gy) : gy[A-1:0];
    odd_q <= y_pos ? !x_pos : y_neg && !x_neg;
  end

  // Clock 2: smaller and larger component; lower: in the octant at the quadrant's own axis.
  logic [A-1:0] minor2_q, major2_q, minor3_q, major3_q, not_minor4_q;
  logic lower2_q, x_larger, y_larger;
  logic [A:0] x_minus_y, x_minus_y_less1;
  assign x_minus_y       = {1'b0, ax_q} - {1'b0, ay_q};
  assign x_minus_y_less1 = {1'b0, ax_q} + {1'b0, ~ay_q};
  assign y_larger        = x_minus_y[A];
  assign x_larger        = x_minus_y_less1[A];
  always_ff @(posedge clk_i) begin
    minor2_q <= y_larger ? ax_q : ay_q;
    major2_q <= y_larger ? ay_q : ax_q;
    lower2_q <= odd_q ? !x_larger : !y_larger;
  end

  // Clocks 3-5: thresholds times the larger component, comparisons.
  logic [A+1:0] three_q;
  logic [A+2:0] five_q;
  logic [T-1:0] thirteen_q, nineteen_q, twentyseven_q, thirtyfour_q, fortythree_q, fiftythree_q;
  logic [6:0] missed_q;
  logic missed_six_q;
  // product > 64 minor, by the carry of a sum; of the product's last six bits it only matters whether one
  // is set.
  function automatic logic exceeds(input logic [T-1:0] product, input logic [A-1:0] not_minor);
    logic [A+1:0] sum;
    sum = {1'b0, product[T-1:6], |product[5:0]} + {1'b0, not_minor, 1'b1};
    exceeds = sum[A+1];
  endfunction
  always_ff @(posedge clk_i) begin
    three_q  <= (A + 2)'(major2_q) + {1'b0, major2_q, 1'b0};
    five_q   <= (A + 3)'(major2_q) + {1'b0, major2_q, 2'b0};
    minor3_q <= minor2_q;
    major3_q <= major2_q;

    thirteen_q    <= (T'(major3_q) << 3) + T'(five_q);
    nineteen_q    <= (T'(major3_q) << 4) + T'(three_q);
    twentyseven_q <= (T'(three_q) << 3) + T'(three_q);
    thirtyfour_q  <= (T'(major3_q) << 5) + (T'(major3_q) << 1);
    fortythree_q  <= (T'(five_q) << 3) + T'(three_q);
    fiftythree_q  <= (T'(three_q) << 4) + T'(five_q);
    not_minor4_q  <= ~minor3_q;

    missed_six_q <= exceeds(T'(three_q) << 1, ~minor3_q);
    missed_q     <= {exceeds(fiftythree_q, not_minor4_q), exceeds(fortythree_q, not_minor4_q),
                     exceeds(thirtyfour_q, not_minor4_q), exceeds(twentyseven_q, not_minor4_q),
                     exceeds(nineteen_q, not_minor4_q), exceeds(thirteen_q, not_minor4_q),
                     missed_six_q};
  end

  // Clocks 1, 2: class.
  logic [M+2:0] not_floor3_q, not_floor5_q;  // of a setting, which holds for a frame
  logic above1_q, above3_q, above5_q;
  logic [1:0] class_q, class_late;
  logic [M+1:0] margin1;
  logic [M+3:0] margin3, margin5;
  assign margin1 = {1'b0, magnitude, 1'b1} + {1'b0, ~branch_floor_i, 1'b1};
  assign margin3 = {3'b0, magnitude, 1'b1} + {1'b0, not_floor3_q};
  assign margin5 = {3'b0, magnitude, 1'b1} + {1'b0, not_floor5_q};
  always_ff @(posedge clk_i) begin
    not_floor3_q <= ~((M + 3)'(branch_floor_i) + {2'b0, branch_floor_i, 1'b0});
    not_floor5_q <= ~((M + 3)'(branch_floor_i) + {1'b0, branch_floor_i, 2'b0});
    above1_q     <= margin1[M+1];
    above3_q     <= margin3[M+3];
    above5_q     <= margin5[M+3];
    class_q  <= {above1_q && above3_q, above1_q && (!above3_q || above5_q)};
  end

  // Clock 6: thresholds reached are the lowest of the seven; upper octants count backwards.
  logic odd_late, lower_late;
  logic [2:0] step;
  always_comb begin
    step = 3'd0;
    for (int k = 0; k < 7; k++) if (!missed_q[k]) step = 3'(k + 1);
  end
  always_ff @(posedge clk_i) begin
    data_o <= class_late == 2'd0 ? 7'd0
        : {class_late, odd_late, !lower_late, lower_late ? step : ~step};
  end

  payload_delay #(
      .Clocks(4)
  ) i_odd (
      .clk_i,
      .data_i(odd_q),
      .data_o(odd_late)
  );
  payload_delay #(
      .Width (3),
      .Clocks(3)
  ) i_octant (
      .clk_i,
      .data_i({class_q, lower2_q}),
      .data_o({class_late, lower_late})
  );
  delay_line #(
      .Width (2),
      .Clocks(6)
  ) i_valid (
      .clk_i,
      .rst_ni,
      .data_i({first_i, valid_i}),
      .data_o({first_o, valid_o})
  );
endmodule
