// SPDX-License-Identifier: Apache-2.0
//
// One camera's pipeline: pixels in, contour stream and vertex records out.
//
//   row_source -> contours -> vertices -> vertex_packer
//                         \-> contour_packer
//
// Beats flow through the stages without ever stalling: a pixel enters only when both packers
// have room for everything that is under way.
//
//   s_axis_*           8-bit grey video: tuser start of frame, tlast end of line
//   m_axis_contour_*   one beat per pixel, see contour_packer
//   m_axis_vertex_*    records, see vertex_packer
//   enable_i, flush_timeout_i   see frame_guard
//   frame_height_i .. min_turn_i   settings of a frame: sampled when its first pixel leaves the
//                      input register; with hold_i 1 it keeps those of the frame before
//   event_o, frame_done_o, sent_o, lost_o       for counters
//
// Latency to the contour stream: 1 + 8 rows and 43 clocks; throughput 1 pixel per clock. Border and bad
// streams: see line_window, frame_guard.
module view_pipeline #(
    parameter int View         = 0,     // tag in its records, 0 .. 15
    parameter int MaxWidthPx   = 1920,  // longest line, 5 .. 4080 px
    parameter int MaxHeightPx  = 1200,  // most lines, 5 .. 4095
    parameter int FractionBits = 3      // of the gradient, 0 .. 6
) (
    input  logic                    clk_i,
    input  logic                    rst_ni,
    input  logic                    enable_i,
    input  logic                    hold_i,
    input  logic [            11:0] frame_height_i,
    input  logic [            19:0] flush_timeout_i,
    input  logic [            15:0] vertex_limit_i,
    input  logic [FractionBits+5:0] noise_floor_i,
    input  logic [             4:0] mean_limit_i,
    input  logic [FractionBits+10:0] support_i,
    input  logic [FractionBits+5:0] branch_floor_i,
    input  logic [             4:0] min_turn_i,
    output logic [             7:0] event_o,
    output logic                    frame_done_o,
    output logic [            15:0] sent_o,
    output logic [            15:0] lost_o,
    input  logic                    s_axis_tvalid,
    output logic                    s_axis_tready,
    input  logic [             7:0] s_axis_tdata,
    input  logic                    s_axis_tuser,
    input  logic                    s_axis_tlast,
    output logic                    m_axis_contour_tvalid,
    input  logic                    m_axis_contour_tready,
    output logic [            63:0] m_axis_contour_tdata,
    output logic                    m_axis_contour_tuser,
    output logic                    m_axis_contour_tlast,
    output logic                    m_axis_vertex_tvalid,
    input  logic                    m_axis_vertex_tready,
    output logic [            63:0] m_axis_vertex_tdata,
    output logic                    m_axis_vertex_tlast
);
  if (View < 0 || View > 15 || MaxWidthPx < 5 || MaxWidthPx > 4080 || MaxHeightPx < 5 ||
      MaxHeightPx > 4095 || FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_View_0_to_15_MaxWidthPx_5_to_4080_MaxHeightPx_5_to_4095_FractionBits_0_to_6 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);
  localparam int MagnitudeBits = FractionBits + 6;
  localparam int SettingsBits = 16 + MagnitudeBits + 5 + (MagnitudeBits + 5) + MagnitudeBits + 5;

  // Settings of the frames in flight.
  logic [15:0] limit;
  logic [MagnitudeBits-1:0] noise_floor, branch_floor;
  logic [4:0] mean_limit, min_turn;
  logic [MagnitudeBits+4:0] support;

  logic contour_ready, vertex_ready, go_q;
  always_ff @(posedge clk_i) go_q <= rst_ni && contour_ready && vertex_ready;

  logic slot_valid, slot_sol, slot_sof, slot_real, slot_in_row;
  logic [1:0] slot_fault;
  logic [7:0] slot_data;
  logic [2*ColBits-1:0] before_last;
  row_source #(
      .MaxWidthPx  (MaxWidthPx),
      .MaxHeightPx (MaxHeightPx),
      .SettingsBits(SettingsBits)
  ) i_source (
      .clk_i,
      .rst_ni,
      .s_axis_tvalid_i(s_axis_tvalid),
      .s_axis_tready_o(s_axis_tready),
      .s_axis_tdata_i(s_axis_tdata),
      .s_axis_tuser_i(s_axis_tuser),
      .s_axis_tlast_i(s_axis_tlast),
      .enable_i,
      .hold_i,
      .frame_height_i,
      .flush_timeout_i,
      .settings_i({
        vertex_limit_i, noise_floor_i, mean_limit_i, support_i, branch_floor_i, min_turn_i
      }),
      .settings_o({limit, noise_floor, mean_limit, support, branch_floor, min_turn}),
      .event_o,
      .go_i(go_q),
      .valid_o(slot_valid),
      .sol_o(slot_sol),
      .sof_o(slot_sof),
      .real_o(slot_real),
      .fault_o(slot_fault),
      .in_row_o(slot_in_row),
      .before_last_o(before_last),
      .data_o(slot_data)
  );

  logic slope_valid, slope_first, slope_begins;
  logic second_valid, second_sol, second_eol, second_sof, second_real, second_in_row;
  logic [3*FractionBits+21:0] slope_data;
  logic [1:0] second_fault, second_data;
  contours #(
      .MaxWidthPx  (MaxWidthPx),
      .FractionBits(FractionBits)
  ) i_contours (
      .clk_i,
      .rst_ni,
      .noise_floor_i(noise_floor),
      .mean_limit_i(mean_limit),
      .support_i(support),
      .valid_i(slot_valid),
      .sol_i(slot_sol),
      .sof_i(slot_sof),
      .real_i(slot_real),
      .fault_i(slot_fault),
      .in_row_i(slot_in_row),
      .before_last_i(before_last),
      .data_i(slot_data),
      .slope_valid_o(slope_valid),
      .slope_first_o(slope_first),
      .slope_begins_o(slope_begins),
      .slope_data_o(slope_data),
      .valid_o(second_valid),
      .sol_o(second_sol),
      .eol_o(second_eol),
      .sof_o(second_sof),
      .real_o(second_real),
      .fault_o(second_fault),
      .in_row_o(second_in_row),
      .data_o(second_data)
  );

  contour_packer #(
      .FractionBits(FractionBits)
  ) i_contour_packer (
      .clk_i,
      .rst_ni,
      .slope_valid_i(slope_valid),
      .slope_first_i(slope_first),
      .slope_begins_i(slope_begins),
      .slope_data_i(slope_data),
      .flags_valid_i(second_valid && second_in_row && (second_real || second_sof)),
      .flags_sol_i(second_sol),
      .flags_eol_i(second_eol),
      .flags_sof_i(second_sof),
      .flags_data_i(second_data),
      .ready_o(contour_ready),
      .m_axis_tvalid_o(m_axis_contour_tvalid),
      .m_axis_tready_i(m_axis_contour_tready),
      .m_axis_tdata_o(m_axis_contour_tdata),
      .m_axis_tuser_o(m_axis_contour_tuser),
      .m_axis_tlast_o(m_axis_contour_tlast)
  );

  logic vertex_valid, end_valid;
  logic [11:0] vertex_x, vertex_y;
  logic [3:0] vertex_branches;
  logic [7:0] vertex_pattern;
  logic [6:0] vertex_strength;
  logic [1:0] end_fault;
  vertices #(
      .MaxWidthPx  (MaxWidthPx),
      .FractionBits(FractionBits)
  ) i_vertices (
      .clk_i,
      .rst_ni,
      .branch_floor_i(branch_floor),
      .min_turn_i(min_turn),
      .slope_valid_i(slope_valid),
      .slope_first_i(slope_first),
      .slope_data_i(slope_data),
      .valid_i(second_valid),
      .sol_i(second_sol),
      .sof_i(second_sof),
      .real_i(second_real),
      .fault_i(second_fault),
      .in_row_i(second_in_row),
      .before_last_i(before_last),
      .contour_i(second_data[0]),
      .vertex_valid_o(vertex_valid),
      .vertex_x_o(vertex_x),
      .vertex_y_o(vertex_y),
      .vertex_branches_o(vertex_branches),
      .vertex_pattern_o(vertex_pattern),
      .vertex_strength_o(vertex_strength),
      .end_valid_o(end_valid),
      .end_fault_o(end_fault)
  );

  vertex_packer #(
      .View        (View),
      .StrengthBits(7)
  ) i_vertex_packer (
      .clk_i,
      .rst_ni,
      .vertex_valid_i(vertex_valid),
      .vertex_x_i(vertex_x),
      .vertex_y_i(vertex_y),
      .vertex_branches_i(vertex_branches),
      .vertex_pattern_i(vertex_pattern),
      .vertex_strength_i(vertex_strength),
      .end_valid_i(end_valid),
      .end_fault_i(end_fault),
      .limit_i(limit),
      .ready_o(vertex_ready),
      .frame_done_o,
      .sent_o,
      .lost_o,
      .m_axis_tvalid_o(m_axis_vertex_tvalid),
      .m_axis_tready_i(m_axis_vertex_tready),
      .m_axis_tdata_o(m_axis_vertex_tdata),
      .m_axis_tlast_o(m_axis_vertex_tlast)
  );
endmodule
