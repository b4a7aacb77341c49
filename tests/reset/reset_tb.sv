// SPDX-License-Identifier: Apache-2.0
//
// What leaves the ports after a reset of two clocks depends on what entered since, on nothing else.
// Registers and memories begin as the simulator has them: unknown in Icarus, random in Verilator.
// Frames of several sizes, broken ones, stalls on all streams, a second reset inside a frame.
// After each reset no control output and no offered payload is ever unknown; a checksum of all that
// was taken is printed.
module reset_tb;
  localparam int Views = 2;
  localparam int Reset = 2, Second = 2500, Clocks = 6000;  // clocks of reset, the second, the end

  logic clk = 1'b0;
  always #5 clk = !clk;

  // Numbers that are the same in every simulator.
  logic [31:0] random_q = 32'h1d872b41;
  function automatic logic [31:0] after(input logic [31:0] x);
    after = x ^ (x << 13);
    after = after ^ (after >> 17);
    after = after ^ (after << 5);
  endfunction

  int clock_q = 0;
  logic rst_n;
  assign rst_n = clock_q >= Reset && !(clock_q >= Second && clock_q < Second + Reset);

  // Frames of 24 x 18, 9 x 7, 5 x 5 px, one with a short line; a bright square on a ramp.
  logic [Views-1:0] tvalid_q = '0, tready, tuser, tlast;
  logic [8*Views-1:0] tdata;
  for (genvar v = 0; v < Views; v++) begin : gen_input
    logic [7:0] x_q = '0, y_q = '0, frame_q = '0, width, height;
    assign width = frame_q % 3 == 0 ? 8'd24 : frame_q % 3 == 1 ? 8'd9 : 8'd5;
    assign height = frame_q % 3 == 0 ? 8'd18 : frame_q % 3 == 1 ? 8'd7 : 8'd5;
    assign tuser[v] = x_q == 0 && y_q == 0;
    assign tlast[v] = x_q == width - 1 || (frame_q % 7 == 4 && y_q == 3 && x_q == 6);
    assign tdata[8*v+:8] = x_q > 6 && x_q < 16 && y_q > 4 && y_q < 13
                               ? 8'd190 : 8'd40 + 2 * x_q + 3 * (y_q ^ 8'(v));
    always @(posedge clk) begin
      if (!rst_n) begin
        x_q         <= 8'd1;  // not at a start of frame
        y_q         <= 8'd1;
        tvalid_q[v] <= 1'b0;
      end else if (!tvalid_q[v] || tready[v]) begin
        tvalid_q[v] <= random_q[4*v+:2] != 2'd0;
        if (tvalid_q[v]) begin
          x_q <= tlast[v] ? 8'd0 : x_q + 8'd1;
          if (tlast[v]) y_q <= y_q == height - 1 ? 8'd0 : y_q + 8'd1;
          if (tlast[v] && y_q == height - 1) frame_q <= frame_q + 8'd1;
        end
      end
    end
  end

  logic [Views-1:0] contour_tvalid, contour_tuser, contour_tlast, contour_tready_q = '0;
  logic [64*Views-1:0] contour_tdata;
  logic vertex_tvalid, vertex_tlast, vertex_tready_q = 1'b0;
  logic [63:0] vertex_tdata;

  // One register access after the other: reads of all words, sometimes a write before.
  logic write_q = 1'b0, read_q = 1'b0, awready, wready, bvalid, arready, rvalid;
  logic [11:0] address_q = '0;
  logic [31:0] rdata;
  logic [1:0] bresp, rresp;

  trihedron_top #(
      .Views      (Views),
      .MaxWidthPx (24),
      .MaxHeightPx(18)
  ) dut (
      .clk_i                (clk),
      .rst_ni               (rst_n),
      .s_axis_tvalid        (tvalid_q),
      .s_axis_tready        (tready),
      .s_axis_tdata         (tdata),
      .s_axis_tuser         (tuser),
      .s_axis_tlast         (tlast),
      .m_axis_contour_tvalid(contour_tvalid),
      .m_axis_contour_tready(contour_tready_q),
      .m_axis_contour_tdata (contour_tdata),
      .m_axis_contour_tuser (contour_tuser),
      .m_axis_contour_tlast (contour_tlast),
      .m_axis_vertex_tvalid (vertex_tvalid),
      .m_axis_vertex_tready (vertex_tready_q),
      .m_axis_vertex_tdata  (vertex_tdata),
      .m_axis_vertex_tlast  (vertex_tlast),
      .s_axil_awvalid       (write_q),
      .s_axil_awready       (awready),
      .s_axil_awaddr        (12'h018),
      .s_axil_wvalid        (write_q),
      .s_axil_wready        (wready),
      .s_axil_wdata         (32'd40),
      .s_axil_wstrb         (4'hf),
      .s_axil_bvalid        (bvalid),
      .s_axil_bready        (1'b1),
      .s_axil_bresp         (bresp),
      .s_axil_arvalid       (read_q),
      .s_axil_arready       (arready),
      .s_axil_araddr        (address_q),
      .s_axil_rvalid        (rvalid),
      .s_axil_rready        (1'b1),
      .s_axil_rdata         (rdata),
      .s_axil_rresp         (rresp)
  );

  int beats = 0, records = 0, reads = 0;
  logic [31:0] sum = '0;
  function automatic logic [31:0] mixed(input logic [31:0] a, input logic [63:0] b);
    mixed = ({a[26:0], a[31:27]} ^ b[31:0]) + {b[47:32], b[63:48]};
  endfunction

  task automatic known(input logic unknown, input string port);
    if (unknown) begin
      $display("reset: %s is unknown in clock %0d", port, clock_q);
      $fatal(1);
    end
  endtask

  always @(negedge clk) begin
    if (rst_n) begin
      known(^{tready, contour_tvalid, vertex_tvalid, awready, wready, bvalid, arready, rvalid} === 1'bx,
            "a handshake output");
      for (int v = 0; v < Views; v++) begin
        if (contour_tvalid[v]) begin
          known(^{contour_tdata[64*v+:64], contour_tuser[v], contour_tlast[v]} === 1'bx,
                "a contour beat");
          if (contour_tready_q[v]) begin
            beats = beats + 1;
            sum = mixed(sum, contour_tdata[64*v+:64] ^ {62'b0, contour_tuser[v], contour_tlast[v]});
          end
        end
      end
      if (vertex_tvalid) begin
        known(^{vertex_tdata, vertex_tlast} === 1'bx, "a record");
        if (vertex_tready_q) begin
          records = records + 1;
          sum = mixed(sum, vertex_tdata);
        end
      end
      if (rvalid) begin
        known(^{rdata, rresp} === 1'bx, "a register");
        reads = reads + 1;
        sum = mixed(sum, {32'b0, rdata});
      end
      if (bvalid) known(^bresp === 1'bx, "bresp");
    end
  end

  always @(posedge clk) begin
    random_q <= after(random_q);
    clock_q  <= clock_q + 1;
    for (int v = 0; v < Views; v++) begin
      contour_tready_q[v] <= random_q[10+2*v+:2] != 2'd0;
    end
    vertex_tready_q <= random_q[21:20] != 2'd0;
    if (!rst_n) begin
      {read_q, write_q} <= '0;
    end else begin
      if (read_q && arready) read_q <= 1'b0;
      else if (random_q[24:22] == 3'd0) read_q <= 1'b1;
      if (rvalid) address_q <= address_q + 12'd4;
      if (write_q && awready) write_q <= 1'b0;
      else if (random_q[31:25] == 7'd0) write_q <= 1'b1;
    end
    if (clock_q == Clocks) begin
      if (beats < 1000 || records < 10 || reads < 100) $fatal(1, "reset: too little came out");
      $display("reset: %0d beats, %0d records, %0d reads, checksum %08x", beats, records, reads, sum);
      $finish;
    end
  end
endmodule
