// SPDX-License-Identifier: Apache-2.0
//
// stream_fifo against a queue, its writer watching the level: nothing lost, nothing twice, in order; m_ stream rules.
module stream_fifo_properties (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       push,
    input logic [1:0] s_tdata,
    input logic       m_tready
);
  logic m_tvalid;
  logic [2:0] level;
  logic push_late_q;
  logic [1:0] m_tdata;
  stream_fifo #(
      .Width(2),
      .Depth(4)
  ) dut (
      .clk_i,
      .rst_ni,
      .push_i(push),
      .data_i(s_tdata),
      .level_o(level),
      .m_tvalid_o(m_tvalid),
      .m_tready_i(m_tready),
      .m_tdata_o (m_tdata)
  );
  // The level is one clock late: the writer counts its own last entry in.
  always_ff @(posedge clk_i) begin
    push_late_q <= push && rst_ni;
    assume (!push || (level + 3'(push_late_q) < 3'd4 && rst_ni));
  end

  // One more entry than the memory holds.
  queue_properties #(
      .Width(2),
      .Depth(5)
  ) queue (
      .clk_i,
      .rst_ni,
      .push_i(push),
      .data_i(s_tdata),
      .valid_i(m_tvalid),
      .ready_i(m_tready),
      .data_out_i(m_tdata)
  );
endmodule
