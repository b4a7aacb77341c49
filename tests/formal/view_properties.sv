// SPDX-License-Identifier: Apache-2.0
//
// Every port of trihedron_top and with it of view_pipeline against the AXI rules, whatever comes in and
// whatever the stages compute: an offered beat, record or answer stays, unchanged, until it is taken;
// nothing is offered after a reset; one answer per register access, none without; a patient
// master is answered within a bound.
//
// The stages (contours, vertices) are cut out: their outputs are free. stream_fifo keeps what it is
// proved to keep (stream_fifo, credit). Everything else is the netlist as it is.
module view_properties #(
    parameter int Views = 2
) (
    input logic               clk_i,
    input logic               rst_ni,
    input logic [  Views-1:0] tvalid,
    input logic [8*Views-1:0] tdata,
    input logic [  Views-1:0] tuser,
    input logic [  Views-1:0] tlast,
    input logic [  Views-1:0] contour_tready,
    input logic               vertex_tready,
    input logic               awvalid,
    input logic [       11:0] awaddr,
    input logic               wvalid,
    input logic [       31:0] wdata,
    input logic [        3:0] wstrb,
    input logic               bready,
    input logic               arvalid,
    input logic [       11:0] araddr,
    input logic               rready
);
  logic [Views-1:0] tready, contour_tvalid, contour_tuser, contour_tlast;
  logic [64*Views-1:0] contour_tdata;
  logic vertex_tvalid, vertex_tlast;
  logic [63:0] vertex_tdata;
  logic awready, wready, bvalid, arready, rvalid;
  logic [1:0] bresp, rresp;
  logic [31:0] rdata;
  trihedron_top #(
      .Views       (Views),
      .MaxWidthPx  (6),
      .MaxHeightPx (6),
      .FractionBits(0)
  ) dut (
      .clk_i,
      .rst_ni,
      .s_axis_tvalid        (tvalid),
      .s_axis_tready        (tready),
      .s_axis_tdata         (tdata),
      .s_axis_tuser         (tuser),
      .s_axis_tlast         (tlast),
      .m_axis_contour_tvalid(contour_tvalid),
      .m_axis_contour_tready(contour_tready),
      .m_axis_contour_tdata (contour_tdata),
      .m_axis_contour_tuser (contour_tuser),
      .m_axis_contour_tlast (contour_tlast),
      .m_axis_vertex_tvalid (vertex_tvalid),
      .m_axis_vertex_tready (vertex_tready),
      .m_axis_vertex_tdata  (vertex_tdata),
      .m_axis_vertex_tlast  (vertex_tlast),
      .s_axil_awvalid       (awvalid),
      .s_axil_awready       (awready),
      .s_axil_awaddr        (awaddr),
      .s_axil_wvalid        (wvalid),
      .s_axil_wready        (wready),
      .s_axil_wdata         (wdata),
      .s_axil_wstrb         (wstrb),
      .s_axil_bvalid        (bvalid),
      .s_axil_bready        (bready),
      .s_axil_bresp         (bresp),
      .s_axil_arvalid       (arvalid),
      .s_axil_arready       (arready),
      .s_axil_araddr        (araddr),
      .s_axil_rvalid        (rvalid),
      .s_axil_rready        (rready),
      .s_axil_rdata         (rdata),
      .s_axil_rresp         (rresp)
  );

  logic started_q = 1'b0;
  logic was_reset_q, vertex_held_q, b_held_q, r_held_q, write_open_q, read_open_q;
  logic aw_wait_q, w_wait_q, ar_wait_q;
  logic [Views-1:0] held_q;
  logic [66*Views-1:0] contour_q;
  logic [64:0] vertex_q;
  logic [31:0] rdata_q;
  logic [2:0] write_clocks_q, answer_clocks_q;
  always_ff @(posedge clk_i) begin
    started_q     <= 1'b1;
    was_reset_q   <= !rst_ni;
    held_q        <= rst_ni ? contour_tvalid & ~contour_tready : '0;
    vertex_held_q <= rst_ni && vertex_tvalid && !vertex_tready;
    b_held_q      <= rst_ni && bvalid && !bready;
    r_held_q      <= rst_ni && rvalid && !rready;
    contour_q     <= {contour_tuser, contour_tlast, contour_tdata};
    vertex_q      <= {vertex_tlast, vertex_tdata};
    rdata_q       <= rdata;
    write_open_q  <= rst_ni && ((awvalid && awready) || (write_open_q && !(bvalid && bready)));
    read_open_q   <= rst_ni && ((arvalid && arready) || (read_open_q && !(rvalid && rready)));
    write_clocks_q  <= rst_ni && awvalid && wvalid && bready && !awready ? write_clocks_q + 3'd1 : '0;
    answer_clocks_q <= rst_ni && read_open_q && !rvalid ? answer_clocks_q + 3'd1 : '0;

    // The master's part: valid stays until ready.
    aw_wait_q <= rst_ni && awvalid && !awready;
    w_wait_q  <= rst_ni && wvalid && !wready;
    ar_wait_q <= rst_ni && arvalid && !arready;
    if (!started_q) assume (!rst_ni);
    if (rst_ni) assume ((awvalid || !aw_wait_q) && (wvalid || !w_wait_q) && (arvalid || !ar_wait_q));

    if (started_q && rst_ni) begin
      assert (!was_reset_q || {contour_tvalid, vertex_tvalid, bvalid, rvalid} == '0);
      for (int v = 0; v < Views; v++) begin
        if (held_q[v]) begin
          assert (contour_tvalid[v] && contour_tdata[64*v+:64] == contour_q[64*v+:64]);
          assert ({contour_tuser[v], contour_tlast[v]} == {contour_q[65*Views+v], contour_q[64*Views+v]});
        end
      end
      assert (!vertex_held_q || (vertex_tvalid && {vertex_tlast, vertex_tdata} == vertex_q));
      assert (!b_held_q || bvalid);
      assert (!r_held_q || (rvalid && rdata == rdata_q));
      assert (bresp == 2'd0 && rresp == 2'd0 && awready == wready && (!awready || (awvalid && wvalid)));
      assert (bvalid == write_open_q && (!rvalid || read_open_q));
      assert (write_clocks_q < 3'd3 && answer_clocks_q < 3'd4);
    end
  end
endmodule
