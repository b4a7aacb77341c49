// SPDX-License-Identifier: Apache-2.0
//
// stream_merge against a queue: nothing lost, nothing twice, in order, m_ stream
// rules; one input at a time; a waiting input is served after at most two others.
module stream_merge_properties (
    input logic       clk_i,
    input logic       rst_ni,
    input logic [2:0] s_tvalid,
    input logic [5:0] s_tdata,
    input logic       m_tready
);
  logic [2:0] s_tready, taken;
  logic m_tvalid;
  logic [1:0] m_tdata, accepted;
  stream_merge #(
      .Inputs(3),
      .Width (2)
  ) dut (
      .clk_i,
      .rst_ni,
      .s_tvalid_i(s_tvalid),
      .s_tready_o(s_tready),
      .s_tdata_i (s_tdata),
      .m_tvalid_o(m_tvalid),
      .m_tready_i(m_tready),
      .m_tdata_o (m_tdata)
  );

  assign taken = s_tvalid & s_tready;
  assign accepted = taken[0] ? s_tdata[1:0] : taken[1] ? s_tdata[3:2] : s_tdata[5:4];
  queue_properties #(
      .Width(2),
      .Depth(2)
  ) queue (
      .clk_i,
      .rst_ni,
      .push_i(|taken),
      .data_i(accepted),
      .valid_i(m_tvalid),
      .ready_i(m_tready),
      .data_out_i(m_tdata)
  );

  // Others served while an input waits.
  logic started_q = 1'b0;
  logic [5:0] others_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    for (int i = 0; i < 3; i++) begin
      if (!rst_ni || !s_tvalid[i] || taken[i]) others_q[2*i+:2] <= '0;
      else if (|taken) others_q[2*i+:2] <= others_q[2*i+:2] + 2'd1;
      if (started_q && rst_ni) assert (others_q[2*i+:2] != 2'd3);
    end
    if (started_q && rst_ni) begin
      assert ((taken & (taken - 3'd1)) == '0);
      // It never waits without need: room and a record there, a record is taken.
      assert (!(|s_tvalid) || (m_tvalid && !m_tready) || |taken);
    end
  end
endmodule
