// SPDX-License-Identifier: Apache-2.0
//
// The netlist of hx8k_view (hx8k_netlist) beside its RTL: frames of changing width with corners and noise,
// pauses and back-pressure; every output must be the same in every clock. hx8k.sh runs it in Icarus.
module netlist_tb;
  localparam int Frames = 2;
  localparam int Drain = 900;  // clocks after the last pixel

  logic clk = 1'b0, rst_n = 1'b0;
  always #1 clk = !clk;

  // The registers' reset values, a time-out of 200 clocks, enable.
  logic [91:0] settings;
  assign settings = {5'd6, 9'd20, 14'd144, 5'd21, 9'd12, 16'hffff, 20'd200, 12'd0, 1'b0, 1'b1};

  // Pixel (x, y) of a frame: a bright block on dark ground.
  integer frame = 0, x = 0, y = 0, seed = 1, drain = 0, beats = 0, vertices = 0;
  integer width, height;
  logic [7:0] pixel, noise = 8'd0;
  always_comb begin
    width  = 24 + 8 * frame;
    height = 16 + 2 * frame;
    pixel  = 8'd40;
    if (x > 6 && x < width - 7 && y > 4 && y < height - 5) pixel = 8'd180;
    pixel = pixel + noise;
  end

  logic offers = 1'b0, contour_tready = 1'b0, vertex_tready = 1'b0, tuser, tlast, tvalid;
  assign tvalid = offers && frame < Frames;
  assign tuser  = x == 0 && y == 0;
  assign tlast  = x == width - 1;

  // {ready, contour valid, vertex valid, event}, contour and vertex with user and last.
  logic [3:0] control, netlist_control;
  logic [34:0] contour, netlist_contour;
  logic [57:0] vertex, netlist_vertex;
  hx8k_view i_view (
      .clk_i(clk), .rst_ni(rst_n), .settings_i(settings),
      .s_axis_tvalid(tvalid), .s_axis_tready(control[3]), .s_axis_tdata(pixel), .s_axis_tuser(tuser),
      .s_axis_tlast(tlast),
      .m_axis_contour_tvalid(control[2]), .m_axis_contour_tready(contour_tready),
      .m_axis_contour_tdata(contour[32:0]), .m_axis_contour_tuser(contour[33]), .m_axis_contour_tlast(contour[34]),
      .m_axis_vertex_tvalid(control[1]), .m_axis_vertex_tready(vertex_tready),
      .m_axis_vertex_tdata(vertex[56:0]), .m_axis_vertex_tlast(vertex[57]), .event_o(control[0])
  );
  hx8k_netlist i_netlist (
      .clk_i(clk), .rst_ni(rst_n), .settings_i(settings),
      .s_axis_tvalid(tvalid), .s_axis_tready(netlist_control[3]), .s_axis_tdata(pixel), .s_axis_tuser(tuser),
      .s_axis_tlast(tlast),
      .m_axis_contour_tvalid(netlist_control[2]), .m_axis_contour_tready(contour_tready),
      .m_axis_contour_tdata(netlist_contour[32:0]), .m_axis_contour_tuser(netlist_contour[33]),
      .m_axis_contour_tlast(netlist_contour[34]),
      .m_axis_vertex_tvalid(netlist_control[1]), .m_axis_vertex_tready(vertex_tready),
      .m_axis_vertex_tdata(netlist_vertex[56:0]), .m_axis_vertex_tlast(netlist_vertex[57]),
      .event_o(netlist_control[0])
  );

  integer clocks = 0;
  always @(posedge clk) begin
    clocks <= clocks + 1;
    rst_n  <= clocks >= 4;
    if (!offers || control[3]) begin
      offers <= rst_n && $random(seed) % 4 != 0;
      noise  <= 8'($random(seed)) & 8'd3;
    end
    contour_tready <= $random(seed) % 8 != 0;
    vertex_tready  <= $random(seed) % 2 != 0;
    if (tvalid && control[3]) begin
      x <= tlast ? 0 : x + 1;
      if (tlast) y <= y == height - 1 ? 0 : y + 1;
      if (tlast && y == height - 1) frame <= frame + 1;
    end
    if (frame == Frames) drain <= drain + 1;

    // Data count while they are valid; what the RTL does not know (memories at the start) is anything.
    if (clocks > 8) begin
      if (|(control ^ netlist_control) === 1'b1 || (control[2] && |(contour ^ netlist_contour) === 1'b1) ||
          (control[1] && |(vertex ^ netlist_vertex) === 1'b1) || ^netlist_control === 1'bx) begin
        $display("netlist differs from the RTL in clock %0d, after %0d contour beats: %b %h %h, not %b %h %h", clocks,
                 beats, netlist_control, netlist_contour, netlist_vertex, control, contour, vertex);
        $finish;
      end
      if (control[2] && contour_tready) beats = beats + 1;
      if (control[1] && vertex_tready) vertices = vertices + 1;
      if (drain == Drain) begin
        if (beats == 0 || vertices <= Frames) $display("netlist_tb: nothing came out");
        else $display("netlist equal to the RTL: %0d contour beats, %0d vertex-stream records", beats, vertices);
        $finish;
      end
    end
  end
endmodule
