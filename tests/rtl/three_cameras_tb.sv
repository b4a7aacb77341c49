// SPDX-License-Identifier: Apache-2.0
//
// Smoke test of the instantiation example in an event-driven simulator: one frame of a bright
// square through each view; every pixel must come out, with contours, four or more vertices per
// view and an end-of-frame record. The full comparison with the golden model is in sim/.
module three_cameras_tb;
  localparam int Width = 32;
  localparam int Height = 24;

  logic clk = 1'b0, rst_n = 1'b0;
  always #5 clk = !clk;

  logic [2:0] tready, contour_tvalid, contour_tuser, contour_tlast;
  logic [191:0] contour_tdata;
  logic vertex_tvalid, vertex_tlast;
  logic [63:0] vertex_tdata;
  logic awready, wready, bvalid, arready, rvalid;
  logic [1:0] bresp, rresp;
  logic [31:0] rdata;
  logic wvalid = 1'b0;

  // Stimulus: the same pixel for all views, taken when all are ready.
  integer pixel = 0;
  logic running = 1'b0;
  logic tvalid, in_square;
  integer x, y;
  assign x = pixel % Width;
  assign y = pixel / Width;
  assign in_square = x >= 9 && x < 23 && y >= 7 && y < 17;
  assign tvalid = running && pixel < Width * Height && (&tready);

  three_cameras dut (
      .clk_i(clk),
      .rst_ni(rst_n),
      .camera_tvalid({3{tvalid}}),
      .camera_tready(tready),
      .camera_tdata({3{in_square ? 8'd180 : 8'd60}}),
      .camera_tuser({3{pixel == 0}}),
      .camera_tlast({3{x == Width - 1}}),
      .contour_tvalid(contour_tvalid),
      .contour_tready(3'b111),
      .contour_tdata(contour_tdata),
      .contour_tuser(contour_tuser),
      .contour_tlast(contour_tlast),
      .vertex_tvalid(vertex_tvalid),
      .vertex_tready(1'b1),
      .vertex_tdata(vertex_tdata),
      .vertex_tlast(vertex_tlast),
      .axil_awvalid(wvalid),
      .axil_awready(awready),
      .axil_awaddr(12'h014),
      .axil_wvalid(wvalid),
      .axil_wready(wready),
      .axil_wdata(32'(Height)),
      .axil_wstrb(4'hf),
      .axil_bvalid(bvalid),
      .axil_bready(1'b1),
      .axil_bresp(bresp),
      .axil_arvalid(1'b0),
      .axil_arready(arready),
      .axil_araddr(12'h000),
      .axil_rvalid(rvalid),
      .axil_rready(1'b1),
      .axil_rdata(rdata),
      .axil_rresp(rresp)
  );

  integer clocks = 0;
  integer beats = 0, contours = 0, vertices = 0, ends = 0;
  always @(posedge clk) begin
    clocks = clocks + 1;
    if (bvalid) begin
      wvalid  <= 1'b0;
      running <= 1'b1;
    end
    if (awready) wvalid <= 1'b0;
    if (tvalid) pixel <= pixel + 1;
    for (int v = 0; v < 3; v++) begin
      if (contour_tvalid[v]) begin
        beats    = beats + 1;
        contours = contours + 32'(contour_tdata[64*v]);
      end
    end
    if (vertex_tvalid) begin
      if (vertex_tlast) ends = ends + 1;
      else vertices = vertices + 1;
    end
  end

  initial begin
    repeat (5) @(posedge clk);
    rst_n <= 1'b1;
    repeat (5) @(posedge clk);
    wvalid <= 1'b1;
    wait (ends == 3 || clocks == 4 * Width * Height);
    repeat (20) @(posedge clk);
    $display("three_cameras: %0d beats, %0d contour pixels, %0d vertices, %0d frames ended", beats,
             contours, vertices, ends);
    if (beats != 3 * Width * Height || contours == 0 || vertices < 12 || ends != 3) begin
      $fatal(1, "expected %0d beats, contours, at least 12 vertices, 3 frames", 3 * Width * Height);
    end
    $finish;
  end
endmodule
