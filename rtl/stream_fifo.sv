// SPDX-License-Identifier: Apache-2.0
//
// FIFO in block RAM whose writer watches the level instead of a ready.
//
//   push_i, data_i  one entry in; the writer keeps level_o below Depth
//   level_o         entries held, one clock late
//   m_*             stream out (AXI4-Stream handshake)
//
// Latency 2 clocks, throughput 1 entry per clock. The pointers run modulo 2 Depth; the memory is
// always read at the address that is next to be offered, so its output register is m_tdata_o.
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

  logic [AddressBits:0] write_q, read_q, read_d, level;
  logic pop;

  assign pop = m_tvalid_o && m_tready_i;
  assign read_d = read_q + (AddressBits + 1)'(pop);
  assign level = write_q - read_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q    <= '0;
      read_q     <= '0;
      level_o    <= '0;
      m_tvalid_o <= 1'b0;
    end else begin
      write_q    <= write_q + (AddressBits + 1)'(push_i);
      read_q     <= read_d;
      level_o    <= level;
      m_tvalid_o <= |level[AddressBits:1] || (level[0] && !pop);
    end
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
      .rdata_o(m_tdata_o)
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
