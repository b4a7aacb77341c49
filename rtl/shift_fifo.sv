// SPDX-License-Identifier: Apache-2.0
//
// Short FIFO in registers: first in, first out, oldest entry always at the bottom.
//
//   s_*, m_*  stream in and out (AXI4-Stream handshake)
//   room_o    for two more entries;  behind_o: or of all entries behind the oldest
//
// Entries move down wherever the bottom is empty, so that one which an upset makes up or takes away
// blocks nothing.
//
// Latency 1 clock, throughput 1 entry per clock; s_tready_o and m_tvalid_o come from registers.
module shift_fifo #(
    parameter int Width = 5,  // payload, bits
    parameter int Depth = 4   // entries
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             s_tvalid_i,
    output logic             s_tready_o,
    input  logic [Width-1:0] s_tdata_i,
    output logic             m_tvalid_o,
    input  logic             m_tready_i,
    output logic [Width-1:0] m_tdata_o,
    output logic             room_o,
    output logic [Width-1:0] behind_o
);
  if (Width < 1 || Depth < 2 || Depth > 16) begin : gen_illegal
    illegal_Width_must_be_at_least_1_and_Depth_2_to_16 stop ();
  end

  logic [Depth-1:0] used_q, used_after_pop;  // no gaps
  logic [Depth*Width-1:0] entries_q, entries_after_pop;
  logic push, pop;

  assign s_tready_o = !used_q[Depth-1];
  assign m_tvalid_o = used_q[0];
  assign room_o = !used_q[Depth-2];
  assign m_tdata_o = entries_q[Width-1:0];
  assign push = s_tvalid_i && s_tready_o;
  assign pop = !m_tvalid_o || m_tready_i;
  assign used_after_pop = pop ? used_q >> 1 : used_q;
  assign entries_after_pop = pop ? entries_q >> Width : entries_q;

  always_comb begin
    behind_o = '0;
    for (int i = 1; i < Depth; i++) begin
      if (used_q[i]) behind_o = behind_o | entries_q[i*Width+:Width];
    end
  end

  always_ff @(posedge clk_i) begin
    for (int i = 0; i < Depth; i++) begin
      entries_q[i*Width+:Width] <= used_after_pop[i] ? entries_after_pop[i*Width+:Width]
                                                     : s_tdata_i;
    end
    if (!rst_ni) used_q <= '0;
    else used_q <= push ? {used_after_pop[Depth-2:0], 1'b1} : used_after_pop;
  end

  // Handshake: an offered entry stays, unchanged, until it is taken.
  logic             held_q;
  logic [Width-1:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_tvalid_o && !m_tready_i;
    held_data_q <= m_tdata_o;
    if (rst_ni && held_q) begin
      assert (m_tvalid_o && m_tdata_o == held_data_q);
    end
  end
endmodule
