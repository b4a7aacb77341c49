// SPDX-License-Identifier: Apache-2.0
//
// axil_slave against the AXI4-Lite rules: answers stay until taken; one answer per write and per
// read, never without one; a write reaches the bus once, as sent; a read returns the data of its
// address; every access of a patient master is answered within a bound.
module axil_slave_properties (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        awvalid,
    input logic [ 3:0] awaddr,
    input logic        wvalid,
    input logic [31:0] wdata,
    input logic [ 3:0] wstrb,
    input logic        bready,
    input logic        arvalid,
    input logic [ 3:0] araddr,
    input logic        rready
);
  logic awready, wready, bvalid, arready, rvalid, write;
  logic [1:0] bresp, rresp, write_address, read_address;
  logic [31:0] rdata, write_data;
  logic [3:0] write_strobe;

  // The register bus: word a holds a, one clock later.
  logic [1:0] read_data_q;
  always_ff @(posedge clk_i) read_data_q <= read_address;

  axil_slave #(
      .AddressBits(4)
  ) dut (
      .clk_i,
      .rst_ni,
      .s_axil_awvalid_i(awvalid),
      .s_axil_awready_o(awready),
      .s_axil_awaddr_i (awaddr),
      .s_axil_wvalid_i (wvalid),
      .s_axil_wready_o (wready),
      .s_axil_wdata_i  (wdata),
      .s_axil_wstrb_i  (wstrb),
      .s_axil_bvalid_o (bvalid),
      .s_axil_bready_i (bready),
      .s_axil_bresp_o  (bresp),
      .s_axil_arvalid_i(arvalid),
      .s_axil_arready_o(arready),
      .s_axil_araddr_i (araddr),
      .s_axil_rvalid_o (rvalid),
      .s_axil_rready_i (rready),
      .s_axil_rdata_o  (rdata),
      .s_axil_rresp_o  (rresp),
      .write_o         (write),
      .write_address_o (write_address),
      .write_data_o    (write_data),
      .write_strobe_o  (write_strobe),
      .read_address_o  (read_address),
      .read_data_i     ({30'b0, read_data_q})
  );

  logic aw, w, b, ar, r;
  assign aw = awvalid && awready;
  assign w  = wvalid && wready;
  assign b  = bvalid && bready;
  assign ar = arvalid && arready;
  assign r  = rvalid && rready;

  logic started_q = 1'b0;
  logic write_open_q, read_open_q;  // accepted, not answered
  logic b_held_q, r_held_q, was_reset_q;
  logic aw_wait_q, w_wait_q, ar_wait_q;
  logic [1:0] address_q, r_data_q;
  logic [2:0] write_clocks_q, answer_clocks_q, read_clocks_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    was_reset_q <= !rst_ni;
    b_held_q <= rst_ni && bvalid && !bready;
    r_held_q <= rst_ni && rvalid && !rready;
    r_data_q <= rdata[1:0];
    if (ar) address_q <= araddr[3:2];
    write_open_q <= rst_ni && (aw || (write_open_q && !b));
    read_open_q  <= rst_ni && (ar || (read_open_q && !r));

    // Clocks that a patient master has waited: both write channels and the way back are open; a
    // read is accepted at once if none is open, and answered.
    write_clocks_q  <= rst_ni && awvalid && wvalid && bready && !aw ? write_clocks_q + 3'd1 : '0;
    answer_clocks_q <= rst_ni && read_open_q && !rvalid ? answer_clocks_q + 3'd1 : '0;
    read_clocks_q   <= rst_ni && arvalid && rready && !ar ? read_clocks_q + 3'd1 : '0;

    if (!started_q) assume (!rst_ni);
    // The master's part: valid stays until ready.
    aw_wait_q <= rst_ni && awvalid && !awready;
    w_wait_q  <= rst_ni && wvalid && !wready;
    ar_wait_q <= rst_ni && arvalid && !arready;
    if (rst_ni) assume (!(aw_wait_q && !awvalid) && !(w_wait_q && !wvalid) &&
                        !(ar_wait_q && !arvalid));

    if (started_q && rst_ni) begin
      assert (!was_reset_q || (!bvalid && !rvalid));
      assert (!b_held_q || bvalid);
      assert (!r_held_q || (rvalid && rdata[1:0] == r_data_q));
      assert (bresp == 2'b00 && rresp == 2'b00);
      assert (aw == w && aw == write);
      assert (!write || (write_address == awaddr[3:2] && write_data == wdata &&
                         write_strobe == wstrb));
      assert (bvalid == write_open_q);
      assert (!aw || !write_open_q || b);
      assert (!rvalid || (read_open_q && rdata == {30'b0, address_q}));
      assert (!ar || !read_open_q || r);
      assert (write_clocks_q < 3'd3);
      assert (answer_clocks_q < 3'd4);
      assert (read_clocks_q < 3'd5);
    end
  end
endmodule
