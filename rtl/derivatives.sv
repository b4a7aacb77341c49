// SPDX-License-Identifier: Apache-2.0
//
// The spline derivatives of a 5x5 window of pixels, from column sums and accumulators along the row.
//
//   H = smooth(y) (x) slope(x), V its transpose;  slope = [-1 -6 0 6 1], smooth = [1 4 6 4 1]
//   A = D - E of the two diagonal derivatives, B = D + E its transpose: A weighs the column right
//   of the centre by [1 4 10 4 1], the next by [1 3 6 3 1], those to the left by the negatives
//
// With the column sums s (smooth), m (rows -1 and +1), the centre row's pixel c, p and q (rows +1
// minus -1, +2 minus -2), and the columns -2 .. 2 of the window:
//   H = s[2] + 6 s[1] - 6 s[-1] - s[-2]
//   A = u[2] + t[1] - t[-1] - u[-2]                   u = s - m, t = s + 4 c
//   V = r[2] + 4 r[1] + 6 r[0] + 4 r[-1] + r[-2]      r = 6 p + q
//   B = w[2] + e[1] + 2 f[0] + e[-1] + w[-2]          w = p + q, e = 4 w - q, f = e + p
//
//   valid_i, column_i  newest column of the window, oldest row in the low byte
//   h_o, v_o           |.| <= 112 * 255;  a_o, b_o  |.| <= 34 * 255
//
// Latency 4 clocks (the centre is two columns behind), 1 beat per clock.
module derivatives (
    input  logic               clk_i,
    input  logic               valid_i,
    input  logic        [39:0] column_i,
    output logic signed [15:0] h_o,
    output logic signed [15:0] v_o,
    output logic signed [14:0] a_o,
    output logic signed [14:0] b_o
);
  // Clocks 1-3: column sums. What will be subtracted waits inverted (not_*): carry chains of small
  // FPGAs only add.
  logic [2:0] valid_q;
  logic [7:0] c1_q, c2_q;
  logic [8:0] outer_q, m1_q, not_m2_q;
  logic signed [8:0] p1_q, q1_q, p2_q;
  logic [11:0] s2_q, s_q, u_q;
  logic [12:0] t_q;
  logic [14:0] s6_q;
  logic signed [9:0] w2_q, w_q;
  logic signed [11:0] r2_q, e2_q, r_q, e_q, f_q;
  logic signed [14:0] r6_q;
  // 6 r has the sign of r. Below it 4 r + 2 r without sign bits: a carry cell whose operands are one net can
  // make nextpnr 0.4's router run for ever.
  logic [13:0] r6_low;
  assign r6_low = {1'b0, r2_q[10:0], 2'b0} + {1'b0, r2_q, 1'b0};
  always_ff @(posedge clk_i) begin
    valid_q <= {valid_q[1:0], valid_i};
    outer_q <= {1'b0, column_i[7:0]} + {1'b0, column_i[39:32]};
    m1_q    <= {1'b0, column_i[15:8]} + {1'b0, column_i[31:24]};
    c1_q    <= column_i[23:16];
    p1_q    <= $signed({1'b0, column_i[31:24]}) - $signed({1'b0, column_i[15:8]});
    q1_q    <= $signed({1'b0, column_i[39:32]}) - $signed({1'b0, column_i[7:0]});

    s2_q <= (12'(outer_q) + {1'b0, m1_q, 2'b0}) + (12'({c1_q, 2'b0}) + 12'({c1_q, 1'b0}));
    r2_q <= (12'($signed({p1_q, 2'b0})) + 12'($signed({p1_q, 1'b0}))) + 12'(q1_q);
    e2_q <= (12'($signed({p1_q, 2'b0})) + 12'($signed({q1_q, 1'b0}))) + 12'(q1_q);
    w2_q <= 10'(p1_q) + 10'(q1_q);
    not_m2_q <= ~m1_q;
    c2_q <= c1_q;
    p2_q <= p1_q;

    s6_q <= {1'b0, s2_q, 2'b0} + {2'b0, s2_q, 1'b0};
    u_q  <= s2_q - {3'b0, ~not_m2_q};
    t_q  <= 13'(s2_q) + {3'b0, c2_q, 2'b0};
    r6_q <= {r2_q[11], r6_low};
    f_q  <= e2_q + 12'(p2_q);
    {s_q, r_q, w_q, e_q} <= {s2_q, r2_q, w2_q, e2_q};
  end

  // Clock 4: along the row. *4_q .. *1_q hold what the last columns add to the windows that are
  // still 1 .. 4 columns short.
  logic [11:0] h4_q, a4_q;
  logic [14:0] h3_q, not_h2_q;
  logic [13:0] a3_q, not_a2_q;
  logic signed [15:0] h1_q, v2_q, v1_q;
  logic signed [14:0] a1_q, v3_q;
  logic signed [11:0] v4_q;
  logic signed [9:0] b4_q;
  logic signed [12:0] b3_q;
  logic signed [13:0] b2_q, b1_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[2]) begin
      h4_q <= s_q;
      h3_q <= 15'(h4_q) + s6_q;
      not_h2_q <= ~h3_q;
      h1_q <= $signed({1'b0, s6_q}) - $signed({1'b0, ~not_h2_q});
      a4_q <= u_q;
      a3_q <= 14'(a4_q) + 14'(t_q);
      not_a2_q <= ~a3_q;
      a1_q <= $signed({2'b0, t_q}) - $signed({1'b0, ~not_a2_q});
      v4_q <= r_q;
      v3_q <= 15'(v4_q) + 15'($signed({r_q, 2'b0}));
      v2_q <= 16'(v3_q) + 16'(r6_q);
      v1_q <= v2_q + 16'($signed({r_q, 2'b0}));
      b4_q <= w_q;
      b3_q <= 13'(b4_q) + 13'(e_q);
      b2_q <= 14'(b3_q) + 14'($signed({f_q, 1'b0}));
      b1_q <= b2_q + 14'(e_q);
    end
    h_o <= h1_q + $signed({4'b0, s_q});
    a_o <= a1_q + $signed({3'b0, u_q});
    v_o <= v1_q + 16'(r_q);
    b_o <= 15'(b1_q) + 15'(w_q);
  end
endmodule
