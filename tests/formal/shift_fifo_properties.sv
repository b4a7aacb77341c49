// SPDX-License-Identifier: Apache-2.0
//
// shift_fifo against a queue: nothing lost, nothing twice, in order; m_ stream rules.
module shift_fifo_properties (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       s_tvalid,
    input logic [1:0] s_tdata,
    input logic       m_tready
);
  logic s_tready, m_tvalid;
  logic [1:0] m_tdata;
  shift_fifo #(
      .Width(2),
      .Depth(3)
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
  queue_properties #(
      .Width(2),
      .Depth(3)
  ) queue (
      .clk_i,
      .rst_ni,
      .push_i(s_tvalid && s_tready),
      .data_i(s_tdata),
      .valid_i(m_tvalid),
      .ready_i(m_tready),
      .data_out_i(m_tdata)
  );
endmodule
