// SPDX-License-Identifier: Apache-2.0
//
// Moves some modules as the timing drawings of docs/waves show them: scripts/draw_waves.py runs this in Icarus and draws
// what its waveform holds. Inputs change behind the rising edge; each list gives one value per clock.
module waves_tb;
  localparam int Clocks = 24;
  logic clk = 1'b0, rst_n = 1'b0;
  integer at = -2;
  always #5 clk = !clk;

  // The value of clock `at` in a list that is written first clock first.
  function automatic logic bit_of(input logic [Clocks-1:0] list, input integer clock);
    bit_of = clock >= 0 && clock < Clocks && list[Clocks-1-clock];
  endfunction

  // skid_buffer: letters A, B, C; the consumer stops for two clocks.
  logic skid_tvalid, skid_tready, skid_m_tvalid, skid_m_tready;
  logic [7:0] skid_tdata, skid_m_tdata;
  skid_buffer #(.Width(8)) i_skid (
      .clk_i(clk), .rst_ni(rst_n),
      .s_tvalid_i(skid_tvalid), .s_tready_o(skid_tready), .s_tdata_i(skid_tdata),
      .m_tvalid_o(skid_m_tvalid), .m_tready_i(skid_m_tready), .m_tdata_o(skid_m_tdata)
  );
  assign skid_tvalid = bit_of(24'b111111_000000_000000_000000, at);
  assign skid_m_tready = bit_of(24'b110011_111111_000000_000000, at);

  // stream_fifo: one entry into an empty FIFO, then two.
  logic fifo_push, fifo_m_tvalid, fifo_m_tready;
  logic [2:0] fifo_level;
  logic [7:0] fifo_m_tdata;
  stream_fifo #(.Width(8), .Depth(4)) i_fifo (
      .clk_i(clk), .rst_ni(rst_n),
      .push_i(fifo_push), .data_i(8'(8'ha0 + at)), .level_o(fifo_level),
      .m_tvalid_o(fifo_m_tvalid), .m_tready_i(fifo_m_tready), .m_tdata_o(fifo_m_tdata)
  );
  assign fifo_push = bit_of(24'b100011_000000_000000_000000, at);
  assign fifo_m_tready = bit_of(24'b111111_001111_000000_000000, at);

  // stream_merge: three inputs, input 2 with two records.
  logic [2:0] merge_tvalid, merge_tready;
  logic merge_m_tvalid;
  logic [7:0] merge_m_tdata;
  stream_merge #(.Inputs(3), .Width(8)) i_merge (
      .clk_i(clk), .rst_ni(rst_n),
      .s_tvalid_i(merge_tvalid), .s_tready_o(merge_tready), .s_tdata_i(24'hc0b0a0),
      .m_tvalid_o(merge_m_tvalid), .m_tready_i(1'b1), .m_tdata_o(merge_m_tdata)
  );

  // axil_slave: a write of 0x20, then a read of it.
  logic axil_awvalid, axil_awready, axil_bvalid, axil_arvalid, axil_arready, axil_rvalid, axil_write;
  logic axil_wready;
  logic [1:0] axil_bresp, axil_rresp;
  logic [31:0] axil_rdata, axil_write_data, axil_word;
  logic [3:0] axil_strobe;
  logic [9:0] axil_write_address, axil_read_address;
  axil_slave i_axil (
      .clk_i(clk), .rst_ni(rst_n),
      .s_axil_awvalid_i(axil_awvalid), .s_axil_awready_o(axil_awready), .s_axil_awaddr_i(12'h020),
      .s_axil_wvalid_i(axil_awvalid), .s_axil_wready_o(axil_wready), .s_axil_wdata_i(32'h18),
      .s_axil_wstrb_i(4'hf), .s_axil_bvalid_o(axil_bvalid), .s_axil_bready_i(1'b1),
      .s_axil_bresp_o(axil_bresp),
      .s_axil_arvalid_i(axil_arvalid), .s_axil_arready_o(axil_arready), .s_axil_araddr_i(12'h020),
      .s_axil_rvalid_o(axil_rvalid), .s_axil_rready_i(1'b1), .s_axil_rdata_o(axil_rdata),
      .s_axil_rresp_o(axil_rresp),
      .write_o(axil_write), .write_address_o(axil_write_address), .write_data_o(axil_write_data),
      .write_strobe_o(axil_strobe), .read_address_o(axil_read_address), .read_data_i(axil_word)
  );

  // frame_guard: two lines of 5 px, a line that ends early, a new frame.
  logic guard_tvalid, guard_tready, guard_tuser, guard_tlast, line_valid, line_whole, line_first,
        line_last, guard_switch, guard_load, guard_idle, pixel_valid, pixel_first, pixel_step, pixel_commit;
  logic [1:0] line_fault;
  logic [7:0] pixel_data, events;
  logic [5:0] before_last;
  logic line_tag;
  frame_guard #(.MaxWidthPx(8), .MaxHeightPx(8)) i_guard (
      .clk_i(clk), .rst_ni(rst_n),
      .s_axis_tvalid_i(guard_tvalid), .s_axis_tready_o(guard_tready), .s_axis_tdata_i(8'(at)),
      .s_axis_tuser_i(guard_tuser), .s_axis_tlast_i(guard_tlast),
      .enable_i(1'b1), .hold_i(1'b0), .frame_height_i(12'd0), .flush_timeout_i(20'd100),
      .pixel_valid_o(pixel_valid), .pixel_o(pixel_data), .pixel_first_o(pixel_first),
      .pixel_step_o(pixel_step), .pixel_commit_o(pixel_commit), .ring_ready_i(1'b1), .line_valid_o(line_valid), .line_ready_i(1'b1), .line_whole_o(line_whole),
      .line_first_o(line_first), .line_last_o(line_last), .line_fault_o(line_fault),
      .line_tag_o(line_tag), .before_last_o(before_last), .width_free_i(1'b1), .settings_changed_i(1'b0), .switch_o(guard_switch), .drained_i(1'b1),
      .load_settings_o(guard_load), .idle_o(guard_idle), .event_o(events)
  );
  integer pixel = 0;  // of the list below; it stays while the guard makes it wait
  assign guard_tvalid = at >= 0 && pixel < 18;
  assign guard_tuser = bit_of(24'b100000_000000_010000_000000, pixel);
  assign guard_tlast = bit_of(24'b000010_000100_100000_000000, pixel);

  always @(posedge clk) begin
    at <= at + 1;
    rst_n <= at >= -1;
    if (guard_tvalid && guard_tready) pixel <= pixel + 1;
    if (at < 0) skid_tdata <= 8'h0a;
    else if (skid_tvalid && skid_tready) skid_tdata <= skid_tdata + 8'd1;
    merge_tvalid <= at == -1 ? 3'b111 : at == 2 ? 3'b100 : merge_tvalid & ~merge_tready;
    axil_awvalid <= at == -1 || (axil_awvalid && !axil_awready);
    axil_arvalid <= at == 3 || (axil_arvalid && !axil_arready);
    if (axil_write) axil_word <= axil_write_data;
    if (at == Clocks) $finish;
  end

  initial begin
    {merge_tvalid, axil_awvalid, axil_arvalid} = '0;
    axil_word = '0;
    $dumpfile("waves.vcd");
    $dumpvars(1, waves_tb);
  end
endmodule
