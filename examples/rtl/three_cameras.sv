// SPDX-License-Identifier: Apache-2.0
//
// How to instantiate trihedron_top: three cameras of up to 1280 x 1024 px in one clock domain,
// each contour stream and the vertex stream to a DMA of its own, registers on AXI4-Lite.
//
// A design without a processor ties s_axil_*valid to 0 and the readies to 1: every register then
// keeps its reset value and all views run.
module three_cameras (
    input  logic         clk_i,
    input  logic         rst_ni,
    input  logic [  2:0] camera_tvalid,
    output logic [  2:0] camera_tready,
    input  logic [ 23:0] camera_tdata,   // view 0 (top) in [7:0], 1 (side), 2 (front)
    input  logic [  2:0] camera_tuser,   // first pixel of a frame
    input  logic [  2:0] camera_tlast,   // last pixel of a line
    output logic [  2:0] contour_tvalid,
    input  logic [  2:0] contour_tready,
    output logic [191:0] contour_tdata,
    output logic [  2:0] contour_tuser,
    output logic [  2:0] contour_tlast,
    output logic         vertex_tvalid,
    input  logic         vertex_tready,
    output logic [ 63:0] vertex_tdata,
    output logic         vertex_tlast,
    input  logic         axil_awvalid,
    output logic         axil_awready,
    input  logic [ 11:0] axil_awaddr,
    input  logic         axil_wvalid,
    output logic         axil_wready,
    input  logic [ 31:0] axil_wdata,
    input  logic [  3:0] axil_wstrb,
    output logic         axil_bvalid,
    input  logic         axil_bready,
    output logic [  1:0] axil_bresp,
    input  logic         axil_arvalid,
    output logic         axil_arready,
    input  logic [ 11:0] axil_araddr,
    output logic         axil_rvalid,
    input  logic         axil_rready,
    output logic [ 31:0] axil_rdata,
    output logic [  1:0] axil_rresp
);
  // A reset that is asynchronous to the clock is synchronised here, once.
  logic [1:0] reset_n_q;
  always_ff @(posedge clk_i) reset_n_q <= {reset_n_q[0], rst_ni};

  trihedron_top #(
      .Views       (3),
      .MaxWidthPx  (1280),
      .MaxHeightPx (1024),
      .FractionBits(3)
  ) i_trihedron (
      .clk_i,
      .rst_ni(reset_n_q[1]),
      .s_axis_tvalid(camera_tvalid),
      .s_axis_tready(camera_tready),
      .s_axis_tdata(camera_tdata),
      .s_axis_tuser(camera_tuser),
      .s_axis_tlast(camera_tlast),
      .m_axis_contour_tvalid(contour_tvalid),
      .m_axis_contour_tready(contour_tready),
      .m_axis_contour_tdata(contour_tdata),
      .m_axis_contour_tuser(contour_tuser),
      .m_axis_contour_tlast(contour_tlast),
      .m_axis_vertex_tvalid(vertex_tvalid),
      .m_axis_vertex_tready(vertex_tready),
      .m_axis_vertex_tdata(vertex_tdata),
      .m_axis_vertex_tlast(vertex_tlast),
      .s_axil_awvalid(axil_awvalid),
      .s_axil_awready(axil_awready),
      .s_axil_awaddr(axil_awaddr),
      .s_axil_wvalid(axil_wvalid),
      .s_axil_wready(axil_wready),
      .s_axil_wdata(axil_wdata),
      .s_axil_wstrb(axil_wstrb),
      .s_axil_bvalid(axil_bvalid),
      .s_axil_bready(axil_bready),
      .s_axil_bresp(axil_bresp),
      .s_axil_arvalid(axil_arvalid),
      .s_axil_arready(axil_arready),
      .s_axil_araddr(axil_araddr),
      .s_axil_rvalid(axil_rvalid),
      .s_axil_rready(axil_rready),
      .s_axil_rdata(axil_rdata),
      .s_axil_rresp(axil_rresp)
  );
endmodule
