// SPDX-License-Identifier: Apache-2.0
//
// FIFO in block RAM whose writer watches the level instead of a ready.
//
//   push_i, data_i  one entry in; the writer keeps level_o below Depth
//   level_o         entries in the memory, one clock late; one more may be on offer
//   m_*             stream out (AXI4-Stream handshake), from registers: a block RAM's output comes late
//
// Latency 3 clocks, throughput 1 entry per clock. Positions run modulo 2 Depth; the memory is always
// read at the one whose entry is offered next.
module stream_fifo #(
    parameter int Width = 36,  // payload, bits
    parameter int Depth = 256  // entries, a power of two
) (
    input  logic                   clk_i,
    input  logic                   rst_ni,
    input  logic                   push_i,
    input  logic [      Width-1:0] data_i,
    output logic [$clog2(Depth):0] level_o,
    output logic                   m_tvalid_o,
    input  logic                   m_tready_i,
    output logic [      Width-1:0] m_tdata_o
);
  if (Width < 1 || Depth < 4 || Depth != (1 << $clog2(Depth))) begin : gen_illegal
    illegal_Width_must_be_at_least_1_and_Depth_a_power_of_two_from_4 stop ();
  end
  localparam int AddressBits = $clog2(Depth);

  // There: the entry at read_q is at the memory's output; fetch: it is offered from the next clock on.
  logic [AddressBits:0] write_q, read_q, read_d, after_q, level;  // after: read_q + 1
  logic [Width-1:0] entry;
  logic there_q, free, fetch;

  assign free = !m_tvalid_o || m_tready_i;
  assign fetch = there_q && free;
  assign read_d = fetch ? after_q : read_q;
  assign level = write_q - read_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q    <= '0;
      read_q     <= '0;
      after_q    <= (AddressBits + 1)'(1);
      level_o    <= '0;
      there_q    <= 1'b0;
      m_tvalid_o <= 1'b0;
    end else begin
      write_q    <= write_q + (AddressBits + 1)'(push_i);
      read_q     <= read_d;
      after_q    <= after_q + (AddressBits + 1)'(fetch);
      level_o    <= level;
      there_q    <= |level[AddressBits:1] || (level[0] && !fetch);
      m_tvalid_o <= there_q || !free;
    end
    if (free) m_tdata_o <= entry;
  end

  line_memory #(
      .Width(Width),
      .Depth(Depth)
  ) i_entries (
      .clk_i,
      .wen_i  (push_i),
      .waddr_i(write_q[AddressBits-1:0]),
      .wdata_i(data_i),
      .raddr_i(read_d[AddressBits-1:0]),
      .rdata_o(entry)
  );

  // Handshake: an offered entry stays, unchanged, until it is taken; the writer never overruns.
  logic             held_q;
  logic [Width-1:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_tvalid_o && !m_tready_i;
    held_data_q <= m_tdata_o;
    if (rst_ni) begin
      assert (!held_q || (m_tvalid_o && m_tdata_o == held_data_q));
      assert (!push_i || (AddressBits + 1)'(write_q - read_q) != (AddressBits + 1)'(Depth));
    end
  end
endmodule
