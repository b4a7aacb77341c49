// SPDX-License-Identifier: Apache-2.0
//
// The spline derivatives of a 5x5 window of pixels, built from column sums.
//
//   H = smooth(y) (x) slope(x), V its transpose;  slope = [-1 -6 0 6 1], smooth = [1 4 6 4 1]
//   A = D - E of the two diagonal derivatives, B = D + E its transpose: A weighs the column right
//   of the centre by [1 4 10 4 1], the next by [1 3 6 3 1], those to the left by the negatives
//
// With the column sums S (smooth), m (rows -1 and +1), the centre row's pixel c, and p, q (rows
// +1 minus -1, +2 minus -2), where s1 = S[+1] - S[-1], s2 = S[+2] - S[-2], and so on:
//   H = 6 s1 + s2,         A = s1 + s2 + 4 c1 - m2
//   V = smooth(6 p + q),   B = smooth(p + q) + 4 p[0] - q[-1] - q[+1]   along the row
//
//   valid_i, column_i  newest column of the window, oldest row in the low byte
//   h_o, v_o           |.| <= 112 * 255;  a_o, b_o  |.| <= 34 * 255
//
// Latency 7 clocks (the centre is two columns behind), 1 beat per clock.
module derivatives (
    input  logic               clk_i,
    input  logic               valid_i,
    input  logic        [39:0] column_i,
    output logic signed [15:0] h_o,
    output logic signed [15:0] v_o,
    output logic signed [14:0] a_o,
    output logic signed [14:0] b_o
);
  // Clocks 1-3: column sums.
  logic [2:0] valid_q;
  logic [7:0] c1_q, c2_q, c3_q;
  logic [8:0] outer_q, m1_q, m2_q, m3_q;
  logic [10:0] c6_q;
  logic [11:0] s2_q, s3_q;
  logic signed [8:0] p1_q, p2_q, q1_q, q2_q;
  logic signed [9:0] w2_q;
  logic signed [11:0] p6_q, r3_q;

  always_ff @(posedge clk_i) begin
    valid_q <= {valid_q[1:0], valid_i};
    outer_q <= {1'b0, column_i[7:0]} + {1'b0, column_i[39:32]};
    m1_q    <= {1'b0, column_i[15:8]} + {1'b0, column_i[31:24]};
    c1_q    <= column_i[23:16];
    p1_q    <= $signed({1'b0, column_i[31:24]}) - $signed({1'b0, column_i[15:8]});
    q1_q    <= $signed({1'b0, column_i[39:32]}) - $signed({1'b0, column_i[7:0]});

    s2_q <= 12'(outer_q) + {1'b0, m1_q, 2'b0};
    c6_q <= {1'b0, c1_q, 2'b0} + {2'b0, c1_q, 1'b0};
    c2_q <= c1_q;
    m2_q <= m1_q;
    p6_q <= 12'($signed({p1_q, 2'b0})) + 12'($signed({p1_q, 1'b0}));
    w2_q <= 10'(p1_q) + 10'(q1_q);
    p2_q <= p1_q;
    q2_q <= q1_q;

    s3_q <= s2_q + 12'(c6_q);
    c3_q <= c2_q;
    m3_q <= m2_q;
    r3_q <= p6_q + 12'(q2_q);
  end

  // Clocks 3, 4: the last five columns' sums, newest in the low bits.
  logic [5*12-1:0] s_q, r_q;
  logic [5*9-1:0] m_q;
  logic [4*8-1:0] c_q;
  logic [5*10-1:0] w_q;
  logic [4*9-1:0] q_q;
  logic [3*9-1:0] p_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[1]) begin
      w_q <= {w_q[4*10-1:0], w2_q};
      q_q <= {q_q[3*9-1:0], q2_q};
      p_q <= {p_q[2*9-1:0], p2_q};
    end
    if (valid_q[2]) begin
      s_q <= {s_q[4*12-1:0], s3_q};
      m_q <= {m_q[4*9-1:0], m3_q};
      c_q <= {c_q[3*8-1:0], c3_q};
      r_q <= {r_q[4*12-1:0], r3_q};
    end
  end

  // Clocks 4-7: along the row.
  logic signed [12:0] s_near_q, s_far_q, s_far6_q;
  logic signed [8:0] c_near_q;
  logic signed [9:0] m_far_q, q_near_q;
  logic signed [15:0] s_near6_q, r_sum_q;
  logic signed [13:0] s_both_q, w_sum_q, w_all_q;
  logic signed [11:0] cm_q, w_mid_q, pq5_q, pq6_q;
  logic signed [12:0] r04_q, r13_q, w_mid6_q;
  logic signed [13:0] r_mid_q;
  logic signed [14:0] r_mid6_q;
  logic signed [10:0] w04_q, w13_q, p4_q;

  always_ff @(posedge clk_i) begin
    w04_q    <= 11'($signed(w_q[0+:10])) + 11'($signed(w_q[40+:10]));
    w13_q    <= 11'($signed(w_q[10+:10])) + 11'($signed(w_q[30+:10]));
    w_mid_q  <= 12'($signed({w_q[20+:10], 1'b0})) + 12'($signed(w_q[20+:10]));
    q_near_q <= 10'($signed(q_q[9+:9])) + 10'($signed(q_q[27+:9]));
    p4_q     <= $signed({p_q[18+:9], 2'b0});

    w_sum_q  <= 14'(w04_q) + 14'($signed({w13_q, 2'b0}));
    w_mid6_q <= $signed({w_mid_q, 1'b0});
    pq5_q    <= 12'(p4_q) - 12'(q_near_q);
    s_near_q <= $signed({1'b0, s_q[12+:12]}) - $signed({1'b0, s_q[36+:12]});
    s_far_q  <= $signed({1'b0, s_q[0+:12]}) - $signed({1'b0, s_q[48+:12]});
    c_near_q <= $signed({1'b0, c_q[8+:8]}) - $signed({1'b0, c_q[24+:8]});
    m_far_q  <= $signed({1'b0, m_q[0+:9]}) - $signed({1'b0, m_q[36+:9]});
    r04_q    <= 13'($signed(r_q[0+:12])) + 13'($signed(r_q[48+:12]));
    r13_q    <= 13'($signed(r_q[12+:12])) + 13'($signed(r_q[36+:12]));
    r_mid_q  <= 14'($signed({r_q[24+:12], 1'b0})) + 14'($signed(r_q[24+:12]));

    w_all_q   <= w_sum_q + 14'(w_mid6_q);
    pq6_q     <= pq5_q;
    s_near6_q <= 16'($signed({s_near_q, 2'b0})) + 16'($signed({s_near_q, 1'b0}));
    s_far6_q  <= s_far_q;
    s_both_q  <= 14'(s_near_q) + 14'(s_far_q);
    cm_q      <= 12'($signed({c_near_q, 2'b0})) - 12'(m_far_q);
    r_sum_q   <= 16'(r04_q) + 16'($signed({r13_q, 2'b0}));
    r_mid6_q  <= $signed({r_mid_q, 1'b0});

    h_o <= s_near6_q + 16'(s_far6_q);
    v_o <= r_sum_q + 16'(r_mid6_q);
    a_o <= 15'(s_both_q) + 15'(cm_q);
    b_o <= 15'(w_all_q) + 15'(pq6_q);
  end
endmodule
