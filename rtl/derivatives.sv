// SPDX-License-Identifier: Apache-2.0
//
// The spline derivatives of a 5x5 window of pixels, built from column sums.
//
//   H = smooth(y) (x) slope(x), V its transpose;  slope = [-1 -2 0 2 1], smooth = [1 4 6 4 1]
//   A = D - E, B = D + E (its transpose) of the two diagonal derivatives: right of the centre
//   column A weighs [1 4 6 4 1] and, two columns away, [2 3 6 3 2] = smooth + [1 -1 0 -1 1]
//
// With the column sums S (smooth), T ([1 -1 0 -1 1]), p (rows +1 minus -1), q (rows +2 minus -2):
//   H = 2 s1 + s2, A = s1 + s2 + t2   where s1 = S[+1] - S[-1], s2 = S[+2] - S[-2], t2 likewise
//   V = smooth(2p + q), B = smooth(p + q) + [1 -1 0 -1 1] q   along the row
//
//   valid_i, column_i  newest column of the window, oldest row in the low byte
//   h_o, v_o           |.| <= 48 * 255;  a_o, b_o  |.| <= 32 * 255
//
// Latency 8 clocks (the centre is two columns behind), 1 beat per clock.
module derivatives (
    input  logic               clk_i,
    input  logic               valid_i,
    input  logic        [39:0] column_i,
    output logic signed [14:0] h_o,
    output logic signed [14:0] v_o,
    output logic signed [13:0] a_o,
    output logic signed [13:0] b_o
);
  // Clocks 1-3: column sums.
  logic [2:0] valid_q;
  logic [8:0] outer_q, inner_q;
  logic [7:0] centre_q;
  logic signed [8:0] p_q, q1_q, q2_q, q3_q;
  logic [11:0] outer_inner_q, s3_q;
  logic [10:0] centre6_q;
  logic signed [9:0] t2_q, t3_q, w2_q, w3_q;
  logic signed [10:0] r2_q, r3_q;

  always_ff @(posedge clk_i) begin
    valid_q       <= {valid_q[1:0], valid_i};
    outer_q       <= {1'b0, column_i[7:0]} + {1'b0, column_i[39:32]};
    inner_q       <= {1'b0, column_i[15:8]} + {1'b0, column_i[31:24]};
    centre_q      <= column_i[23:16];
    p_q           <= $signed({1'b0, column_i[31:24]}) - $signed({1'b0, column_i[15:8]});
    q1_q          <= $signed({1'b0, column_i[39:32]}) - $signed({1'b0, column_i[7:0]});
    outer_inner_q <= 12'(outer_q) + {1'b0, inner_q, 2'b0};
    centre6_q     <= {1'b0, centre_q, 2'b0} + {2'b0, centre_q, 1'b0};
    t2_q          <= $signed({1'b0, outer_q}) - $signed({1'b0, inner_q});
    r2_q          <= 11'($signed({p_q, 1'b0})) + 11'(q1_q);
    w2_q          <= 10'(p_q) + 10'(q1_q);
    q2_q          <= q1_q;
    s3_q          <= outer_inner_q + 12'(centre6_q);
    t3_q          <= t2_q;
    r3_q          <= r2_q;
    w3_q          <= w2_q;
    q3_q          <= q2_q;
  end

  // Clock 4: the last five columns' sums, newest in the low bits.
  logic [5*12-1:0] s_q;
  logic [5*10-1:0] t_q, w_q;
  logic [5*11-1:0] r_q;
  logic [5*9-1:0] q_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[2]) begin
      s_q <= {s_q[4*12-1:0], s3_q};
      t_q <= {t_q[4*10-1:0], t3_q};
      r_q <= {r_q[4*11-1:0], r3_q};
      w_q <= {w_q[4*10-1:0], w3_q};
      q_q <= {q_q[4*9-1:0], q3_q};
    end
  end

  // Clocks 5-8: along the row.
  logic signed [12:0] s1_q, s2_q;
  logic signed [10:0] t5_q, t6_q, ends_t_q, t7_q;
  logic signed [14:0] h6_q, h7_q;
  logic signed [13:0] a6_q, a7_q, r6_q, r_sum_q, w_sum_q, w_sum7_q;
  logic signed [11:0] r04_q, r13_q;
  logic signed [10:0] w04_q, w13_q;
  logic signed [12:0] r_mid_q, w_rest_q;
  logic signed [11:0] w_mid_q;
  logic signed [9:0] q04_q, q13_q;
  logic signed [14:0] v7_q;

  always_ff @(posedge clk_i) begin
    s1_q    <= $signed({1'b0, s_q[12+:12]}) - $signed({1'b0, s_q[36+:12]});
    s2_q    <= $signed({1'b0, s_q[0+:12]}) - $signed({1'b0, s_q[48+:12]});
    t5_q    <= 11'($signed(t_q[0+:10])) - 11'($signed(t_q[40+:10]));
    r04_q   <= 12'($signed(r_q[0+:11])) + 12'($signed(r_q[44+:11]));
    r13_q   <= 12'($signed(r_q[11+:11])) + 12'($signed(r_q[33+:11]));
    r_mid_q <= 13'($signed({r_q[22+:11], 1'b0})) + 13'($signed(r_q[22+:11]));
    w04_q   <= 11'($signed(w_q[0+:10])) + 11'($signed(w_q[40+:10]));
    w13_q   <= 11'($signed(w_q[10+:10])) + 11'($signed(w_q[30+:10]));
    w_mid_q <= 12'($signed({w_q[20+:10], 1'b0})) + 12'($signed(w_q[20+:10]));
    q04_q   <= 10'($signed(q_q[0+:9])) + 10'($signed(q_q[36+:9]));
    q13_q   <= 10'($signed(q_q[9+:9])) + 10'($signed(q_q[27+:9]));

    h6_q     <= 15'($signed({s1_q, 1'b0})) + 15'(s2_q);
    a6_q     <= 14'(s1_q) + 14'(s2_q);
    t6_q     <= t5_q;
    r_sum_q  <= 14'(r04_q) + 14'($signed({r13_q, 2'b0}));
    r6_q     <= 14'($signed({r_mid_q, 1'b0}));
    w_sum_q  <= 14'(w04_q) + 14'($signed({w13_q, 2'b0}));
    w_rest_q <= 13'($signed({w_mid_q, 1'b0}));
    ends_t_q <= 11'(q04_q) - 11'(q13_q);

    h7_q     <= h6_q;
    a7_q     <= a6_q + 14'(t6_q);
    v7_q     <= 15'(r_sum_q) + 15'(r6_q);
    w_sum7_q <= w_sum_q + 14'(w_rest_q);
    t7_q     <= ends_t_q;

    h_o <= h7_q;
    v_o <= v7_q;
    a_o <= a7_q;
    b_o <= w_sum7_q + 14'(t7_q);
  end
endmodule
