// SPDX-License-Identifier: Apache-2.0
//
// The same device and frame in an event-driven simulator: pixels.hex goes to all three views, every
// contour beat is held against beats.hex and every vertex record against records.hex. Prints the
// clocks simulated and "equal", or what differed.
module simulation_speed_icarus #(
    parameter int Width   = 120,
    parameter int Height  = 80,
    parameter int Records = 1     // of one view, the end of frame included
);
  localparam int Pixels = Width * Height;
  localparam int Patience = 30000;  // clocks without the last beat or record

  logic clk = 1'b0, rst_n = 1'b0;
  always #5 clk = !clk;

  logic [7:0] pixels[0:Pixels-1];
  logic [63:0] beats[0:Pixels-1];
  logic [63:0] records[0:Records-1];
  initial begin
    $readmemh("pixels.hex", pixels);
    $readmemh("beats.hex", beats);
    $readmemh("records.hex", records);
  end

  logic [2:0] tready, contour_valid, contour_user, contour_last;
  logic [191:0] contour_data;
  logic vertex_valid, vertex_last, awready, wready, bvalid, arready, rvalid;
  logic [63:0] vertex_data;
  logic [1:0] bresp, rresp;
  logic [31:0] rdata;
  logic write = 1'b0, running = 1'b0;

  integer pixel = 0, column = 0;
  logic valid;
  logic [7:0] grey;
  assign valid = running && pixel < Pixels;
  assign grey = pixels[pixel%Pixels];
  trihedron_top dut (
      .clk_i(clk),
      .rst_ni(rst_n),
      .s_axis_tdata({3{grey}}),
      .s_axis_tvalid({3{valid}}),
      .s_axis_tready(tready),
      .s_axis_tuser({3{pixel == 0}}),
      .s_axis_tlast({3{column == Width - 1}}),
      .m_axis_contour_tdata(contour_data),
      .m_axis_contour_tvalid(contour_valid),
      .m_axis_contour_tready(3'b111),
      .m_axis_contour_tuser(contour_user),
      .m_axis_contour_tlast(contour_last),
      .m_axis_vertex_tdata(vertex_data),
      .m_axis_vertex_tvalid(vertex_valid),
      .m_axis_vertex_tready(1'b1),
      .m_axis_vertex_tlast(vertex_last),
      .s_axil_awvalid(write),
      .s_axil_awready(awready),
      .s_axil_awaddr(12'h014),  // FRAME_HEIGHT
      .s_axil_wvalid(write),
      .s_axil_wready(wready),
      .s_axil_wdata(32'(Height)),
      .s_axil_wstrb(4'hf),
      .s_axil_bvalid(bvalid),
      .s_axil_bready(1'b1),
      .s_axil_bresp(bresp),
      .s_axil_arvalid(1'b0),
      .s_axil_arready(arready),
      .s_axil_araddr(12'h000),
      .s_axil_rvalid(rvalid),
      .s_axil_rready(1'b1),
      .s_axil_rdata(rdata),
      .s_axil_rresp(rresp)
  );

  integer clocks = 0, wrong = 0, beat = 0, record = 0, view;
  integer of_view[0:2];
  initial begin
    for (view = 0; view < 3; view = view + 1) of_view[view] = 0;
    repeat (8) @(negedge clk);
    rst_n = 1'b1;
    write = 1'b1;
    while (!(awready && wready)) @(negedge clk);
    @(negedge clk) write = 1'b0;
    repeat (8) @(negedge clk);
    running = 1'b1;
  end

  // All views take and give in step: they are alike and never stalled.
  always @(posedge clk) begin
    clocks <= clocks + 1;
    if (valid && &tready) begin
      pixel  <= pixel + 1;
      column <= column == Width - 1 ? 0 : column + 1;
    end
    if (|contour_valid) begin
      if (contour_valid !== 3'b111 || contour_data !== {3{beats[beat]}}) wrong = wrong + 1;
      if (contour_last !== {3{beat % Width == Width - 1}} || contour_user !== {3{beat == 0}})
        wrong = wrong + 1;
      beat = beat + 1;
    end
    if (vertex_valid) begin
      view = vertex_data[5:2];
      // The records hold view 0's number.
      if ((vertex_data & ~64'h3c) !== records[of_view[view]]) wrong = wrong + 1;
      of_view[view] = of_view[view] + 1;
      record = record + 1;
    end
    if ((beat == Pixels && record == 3 * Records) || clocks == 2 * Pixels + Patience) begin
      $display("%0d clocks, %0d beats, %0d records, %0s", clocks, 3 * beat, record,
               wrong == 0 && beat == Pixels && record == 3 * Records ? "equal" : "DIFFERENT");
      $finish;
    end
  end
endmodule
