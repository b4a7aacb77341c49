// SPDX-License-Identifier: Apache-2.0
//
// The packers' room: a writer that may push only Clocks clocks after it was told to go on, and is
// told so while the level is below Depth - Reserve, never overruns stream_fifo (its own assertion)
// when Reserve >= Clocks + 2. The rule of contour_packer and vertex_packer, at a small size.
module credit_properties (
    input logic clk_i,
    input logic rst_ni,
    input logic push,
    input logic data,
    input logic m_tready
);
  localparam int Depth = 16;
  localparam int Reserve = 8;
  localparam int Clocks = Reserve - 2;

  logic started_q = 1'b0;
  logic m_tvalid, m_tdata, ready_q;
  logic [$clog2(Depth):0] level;
  logic [Clocks-1:0] may_q;  // told so, in the last clocks
  stream_fifo #(
      .Width(1),
      .Depth(Depth)
  ) dut (
      .clk_i,
      .rst_ni,
      .push_i(push),
      .data_i(data),
      .level_o(level),
      .m_tvalid_o(m_tvalid),
      .m_tready_i(m_tready),
      .m_tdata_o(m_tdata)
  );

  (* hierconn *) wire [$clog2(Depth):0] \dut.write_q ;
  (* hierconn *) wire [$clog2(Depth):0] \dut.read_q ;
  logic [$clog2(Depth):0] held, under_way;
  assign held = \dut.write_q - \dut.read_q ;
  always_comb begin
    under_way = '0;
    for (int i = 0; i < Clocks; i++) under_way = under_way + 5'(may_q[i]);
  end
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
    assume (!push || (rst_ni && may_q[Clocks-1]));
    ready_q  <= rst_ni && level < 5'(Depth - Reserve);
    may_q    <= rst_ni ? {may_q[Clocks-2:0], ready_q} : '0;
    if (started_q && rst_ni) begin
      // What is held and what may still come find room.
      assert (held <= 5'(Depth) && held + under_way + 5'(ready_q) <= 5'(Depth));
    end
  end
endmodule
