// SPDX-License-Identifier: Apache-2.0
//
// idle_timer: both times to the clock, for any time-out.
module idle_timer_properties (
    input logic        clk_i,
    input logic        restart,
    input logic [19:0] timeout
);
  logic idle, timed_out;
  idle_timer dut (
      .clk_i,
      .restart_i(restart),
      .timeout_i(timeout),
      .idle_o(idle),
      .timed_out_o(timed_out)
  );

  // Clocks since the last restart, and the time-out that it sampled.
  logic started_q = 1'b0;
  logic [19:0] timeout_q;
  logic [20:0] clocks_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (restart);
    if (restart) timeout_q <= timeout;
    if (restart) clocks_q <= '0;
    else if (clocks_q != '1) clocks_q <= clocks_q + 21'd1;
    if (started_q) begin
      assert (idle == (clocks_q >= 21'd16));
      assert (timed_out == (clocks_q >= {1'b0, timeout_q} + 21'd2));
    end
  end

  // What holds inside, so that a proof needs less search: the count is what is left.
  (* hierconn *) wire [4:0] \dut.idle_clocks_q ;
  (* hierconn *) wire [10:0] \dut.left_low_q , \dut.left_high_q ;
  wire [20:0] left = {1'b0, timeout_q} - clocks_q;
  always_ff @(posedge clk_i) begin
    if (started_q) begin
      assert (\dut.idle_clocks_q == (clocks_q < 21'd16 ? clocks_q[4:0] : 5'd16));
      // The lower half below 0 is lent by the upper half a clock later.
      if (!timed_out) begin
        assert (\dut.left_high_q [9:0] == left[19:10] + 10'(\dut.left_low_q [10]));
        assert (\dut.left_low_q [9:0] == left[9:0]);
        assert (!\dut.left_low_q [10] || left[9:0] == '1);
      end
    end
  end
endmodule
