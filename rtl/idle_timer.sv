// SPDX-License-Identifier: Apache-2.0
//
// How long nothing has arrived: 16 clocks, and a time-out of choice.
//
//   restart_i     something arrives; timeout_i is sampled
//   timeout_i     clocks
//   idle_o        16 clocks have passed since
//   timed_out_o   the time-out has passed; stays until the next restart
//
// The count down ends below 0, its upper half a clock behind the lower: timed_out_o rises when nothing
// has arrived for timeout_i + 2 clocks.
module idle_timer (
    input  logic        clk_i,
    input  logic        restart_i,
    input  logic [19:0] timeout_i,
    output logic        idle_o,
    output logic        timed_out_o
);
  logic [4:0] idle_clocks_q;
  logic [10:0] left_low_q, left_high_q;
  assign {idle_o, timed_out_o} = {idle_clocks_q[4], left_high_q[10]};
  always_ff @(posedge clk_i) begin
    if (restart_i) begin
      idle_clocks_q <= '0;
      {left_high_q, left_low_q} <= {1'b0, timeout_i[19:10], 1'b0, timeout_i[9:0]};
    end else begin
      if (!idle_o) idle_clocks_q <= idle_clocks_q + 5'd1;
      if (!timed_out_o) begin
        left_low_q <= {1'b0, left_low_q[9:0]} - 11'd1;
        if (left_low_q[10]) left_high_q <= left_high_q - 11'd1;
      end
    end
  end
endmodule
