// SPDX-License-Identifier: Apache-2.0
//
// `Views` camera pipelines behind one register file and one merged vertex stream.
//
//   s_axis_*           8-bit grey video of each view, packed side by side, view 0 lowest
//   m_axis_contour_*   contour stream of each view (contour_packer)
//   m_axis_vertex_*    vertex and end-of-frame records of all views (vertex_packer); the records
//                      of one view keep their order, tlast marks a view's end-of-frame record
//   s_axil_*           registers, docs/registers.md
//
// Latency, throughput, border and bad streams: see view_pipeline. Both outputs must be drained:
// each one that waits holds up its view's input.
module trihedron_top #(
    parameter int Views        = 3,     // 1 .. 15
    parameter int MaxWidthPx   = 1920,  // 5 .. 4080
    parameter int MaxHeightPx  = 1200,  // 5 .. 4095
    parameter int FractionBits = 3      // of the gradient, 0 .. 6
) (
    input  logic                clk_i,
    input  logic                rst_ni,
    input  logic [   Views-1:0] s_axis_tvalid,
    output logic [   Views-1:0] s_axis_tready,
    input  logic [ 8*Views-1:0] s_axis_tdata,
    input  logic [   Views-1:0] s_axis_tuser,
    input  logic [   Views-1:0] s_axis_tlast,
    output logic [   Views-1:0] m_axis_contour_tvalid,
    input  logic [   Views-1:0] m_axis_contour_tready,
    output logic [64*Views-1:0] m_axis_contour_tdata,
    output logic [   Views-1:0] m_axis_contour_tuser,
    output logic [   Views-1:0] m_axis_contour_tlast,
    output logic                m_axis_vertex_tvalid,
    input  logic                m_axis_vertex_tready,
    output logic [        63:0] m_axis_vertex_tdata,
    output logic                m_axis_vertex_tlast,
    input  logic                s_axil_awvalid,
    output logic                s_axil_awready,
    input  logic [        11:0] s_axil_awaddr,
    input  logic                s_axil_wvalid,
    output logic                s_axil_wready,
    input  logic [        31:0] s_axil_wdata,
    input  logic [         3:0] s_axil_wstrb,
    output logic                s_axil_bvalid,
    input  logic                s_axil_bready,
    output logic [         1:0] s_axil_bresp,
    input  logic                s_axil_arvalid,
    output logic                s_axil_arready,
    input  logic [        11:0] s_axil_araddr,
    output logic                s_axil_rvalid,
    input  logic                s_axil_rready,
    output logic [        31:0] s_axil_rdata,
    output logic [         1:0] s_axil_rresp
);
  if (Views < 1 || Views > 15 || MaxWidthPx < 5 || MaxWidthPx > 4080 || MaxHeightPx < 5 ||
      MaxHeightPx > 4095 || FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_Views_1_to_15_MaxWidthPx_5_to_4080_MaxHeightPx_5_to_4095_FractionBits_0_to_6 stop ();
  end
  localparam int BlockBits = $clog2(trihedron_registers::GlobalWords);

  // Register accesses: {block, word}; block ViewBase / 64 + view is a view's.
  logic write;
  logic [9:0] write_address, read_address;
  logic [31:0] write_data, read_data;
  logic [3:0] write_strobe;
  axil_slave i_axil (
      .clk_i,
      .rst_ni,
      .s_axil_awvalid_i(s_axil_awvalid),
      .s_axil_awready_o(s_axil_awready),
      .s_axil_awaddr_i(s_axil_awaddr),
      .s_axil_wvalid_i(s_axil_wvalid),
      .s_axil_wready_o(s_axil_wready),
      .s_axil_wdata_i(s_axil_wdata),
      .s_axil_wstrb_i(s_axil_wstrb),
      .s_axil_bvalid_o(s_axil_bvalid),
      .s_axil_bready_i(s_axil_bready),
      .s_axil_bresp_o(s_axil_bresp),
      .s_axil_arvalid_i(s_axil_arvalid),
      .s_axil_arready_o(s_axil_arready),
      .s_axil_araddr_i(s_axil_araddr),
      .s_axil_rvalid_o(s_axil_rvalid),
      .s_axil_rready_i(s_axil_rready),
      .s_axil_rdata_o(s_axil_rdata),
      .s_axil_rresp_o(s_axil_rresp),
      .write_o(write),
      .write_address_o(write_address),
      .write_data_o(write_data),
      .write_strobe_o(write_strobe),
      .read_address_o(read_address),
      .read_data_i(read_data)
  );

  logic [31:0] cycles_q;
  always_ff @(posedge clk_i) cycles_q <= rst_ni ? cycles_q + 32'd1 : '0;

  localparam int GlobalBits = 32 * trihedron_registers::GlobalWords;
  logic [GlobalBits-1:0] status, settings;
  always_comb begin
    status = trihedron_registers::GlobalReset & ~trihedron_registers::GlobalWritable;
    status[trihedron_registers::LimitsMaxWidthBit+:12] = 12'(MaxWidthPx);
    status[trihedron_registers::LimitsMaxHeightBit+:12] = 12'(MaxHeightPx);
    status[trihedron_registers::LimitsViewsBit+:4] = 4'(Views);
    status[trihedron_registers::LimitsFractionBitsBit+:4] = 4'(FractionBits);
    status[trihedron_registers::CyclesCyclesBit+:32] = cycles_q;
  end

  logic [Views:0] selected_q;
  logic [32*(Views+1)-1:0] bank_data;
  register_bank #(
      .Words(trihedron_registers::GlobalWords),
      .Writable(trihedron_registers::GlobalWritable),
      .Sticky(trihedron_registers::GlobalSticky),
      .Reset(trihedron_registers::GlobalReset)
  ) i_global (
      .clk_i,
      .rst_ni,
      .write_i(write && write_address[9:BlockBits] == '0),
      .word_i(write_address[BlockBits-1:0]),
      .data_i(write_data),
      .strobe_i(write_strobe),
      .read_word_i(read_address[BlockBits-1:0]),
      .read_data_o(bank_data[32*Views+:32]),
      .status_i(status),
      .event_i({GlobalBits{1'b0}}),
      .value_o(settings)
  );
  always_ff @(posedge clk_i) selected_q[Views] <= read_address[9:BlockBits] == '0;

  always_comb begin
    read_data = '0;
    for (int i = 0; i <= Views; i++) begin
      if (selected_q[i]) read_data = read_data | bank_data[32*i+:32];
    end
  end

  logic [Views-1:0] vertex_tvalid, vertex_tready;
  logic [65*Views-1:0] vertex_tdata;
  for (genvar i = 0; i < Views; i++) begin : gen_view
    localparam logic [5:0] Block = 6'(trihedron_registers::ViewBase / 64 + i);
    logic [7:0] events;
    logic frame_done;
    logic [15:0] sent, lost;

    view_pipeline #(
        .View        (i),
        .MaxWidthPx  (MaxWidthPx),
        .MaxHeightPx (MaxHeightPx),
        .FractionBits(FractionBits)
    ) i_pipeline (
        .clk_i,
        .rst_ni,
        .enable_i(settings[trihedron_registers::ControlEnableBit+i]),
        .hold_i(settings[trihedron_registers::ControlHoldBit]),
        .frame_height_i(settings[trihedron_registers::FrameHeightLinesBit+:12]),
        .flush_timeout_i(settings[trihedron_registers::FlushTimeoutClocksBit+:20]),
        .vertex_limit_i(settings[trihedron_registers::VertexLimitVerticesBit+:16]),
        .noise_floor_i(settings[trihedron_registers::NoiseFloorMagnitudeBit+:FractionBits+6]),
        .mean_limit_i(settings[trihedron_registers::MeanLimitMeanBit+:5]),
        .support_i(settings[trihedron_registers::SupportSumBit+:FractionBits+11]),
        .branch_floor_i(settings[trihedron_registers::BranchFloorMagnitudeBit+:FractionBits+6]),
        .min_turn_i(settings[trihedron_registers::MinTurnTurnBit+:5]),
        .event_o(events),
        .frame_done_o(frame_done),
        .sent_o(sent),
        .lost_o(lost),
        .s_axis_tvalid(s_axis_tvalid[i]),
        .s_axis_tready(s_axis_tready[i]),
        .s_axis_tdata(s_axis_tdata[8*i+:8]),
        .s_axis_tuser(s_axis_tuser[i]),
        .s_axis_tlast(s_axis_tlast[i]),
        .m_axis_contour_tvalid(m_axis_contour_tvalid[i]),
        .m_axis_contour_tready(m_axis_contour_tready[i]),
        .m_axis_contour_tdata(m_axis_contour_tdata[64*i+:64]),
        .m_axis_contour_tuser(m_axis_contour_tuser[i]),
        .m_axis_contour_tlast(m_axis_contour_tlast[i]),
        .m_axis_vertex_tvalid(vertex_tvalid[i]),
        .m_axis_vertex_tready(vertex_tready[i]),
        .m_axis_vertex_tdata(vertex_tdata[65*i+:64]),
        .m_axis_vertex_tlast(vertex_tdata[65*i+64])
    );

    view_counters i_counters (
        .clk_i,
        .rst_ni,
        .event_i(events),
        .frame_done_i(frame_done),
        .sent_i(sent),
        .lost_i(lost),
        .write_i(write && write_address[9:BlockBits] == Block),
        .word_i(write_address[BlockBits-1:0]),
        .data_i(write_data),
        .strobe_i(write_strobe),
        .read_word_i(read_address[BlockBits-1:0]),
        .read_data_o(bank_data[32*i+:32])
    );
    always_ff @(posedge clk_i) selected_q[i] <= read_address[9:BlockBits] == Block;
  end

  stream_merge #(
      .Inputs(Views),
      .Width (65)
  ) i_merge (
      .clk_i,
      .rst_ni,
      .s_tvalid_i(vertex_tvalid),
      .s_tready_o(vertex_tready),
      .s_tdata_i (vertex_tdata),
      .m_tvalid_o(m_axis_vertex_tvalid),
      .m_tready_i(m_axis_vertex_tready),
      .m_tdata_o ({m_axis_vertex_tlast, m_axis_vertex_tdata})
  );
endmodule
