// SPDX-License-Identifier: Apache-2.0
//
// One view on an iCE40 HX8K: view_pipeline with its settings on pins and the constant bits of its
// streams left out, so that the ports fit the package's 206 pins. The reset comes from a register, as
// behind a synchroniser, so that its paths count.
module hx8k_view #(
    parameter int MaxWidthPx = 512
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic [91:0] settings_i,
    input  logic        s_axis_tvalid,
    output logic        s_axis_tready,
    input  logic [ 7:0] s_axis_tdata,
    input  logic        s_axis_tuser,
    input  logic        s_axis_tlast,
    output logic        m_axis_contour_tvalid,
    input  logic        m_axis_contour_tready,
    output logic [32:0] m_axis_contour_tdata,
    output logic        m_axis_contour_tuser,
    output logic        m_axis_contour_tlast,
    output logic        m_axis_vertex_tvalid,
    input  logic        m_axis_vertex_tready,
    output logic [56:0] m_axis_vertex_tdata,
    output logic        m_axis_vertex_tlast,
    output logic        event_o
);
  logic [63:0] contour, vertex;
  logic [7:0] events;
  logic frame_done;
  logic [15:0] sent, lost;
  assign m_axis_contour_tdata = {contour[50:40], contour[34:24], contour[16:8], contour[1:0]};
  assign m_axis_vertex_tdata = {vertex[63:8], vertex[0]};
  logic reset_nq;
  always_ff @(posedge clk_i) begin
    reset_nq <= rst_ni;
    event_o  <= ^{events, frame_done, sent, lost};
  end

  view_pipeline #(
      .MaxWidthPx (MaxWidthPx),
      .MaxHeightPx(512)
  ) i_view (
      .clk_i,
      .rst_ni(reset_nq),
      .enable_i(settings_i[0]),
      .hold_i(settings_i[1]),
      .frame_height_i(settings_i[2+:12]),
      .flush_timeout_i(settings_i[14+:20]),
      .vertex_limit_i(settings_i[34+:16]),
      .noise_floor_i(settings_i[50+:9]),
      .mean_limit_i(settings_i[59+:5]),
      .support_i(settings_i[64+:14]),
      .branch_floor_i(settings_i[78+:9]),
      .min_turn_i(settings_i[87+:5]),
      .event_o(events),
      .frame_done_o(frame_done),
      .sent_o(sent),
      .lost_o(lost),
      .s_axis_tvalid,
      .s_axis_tready,
      .s_axis_tdata,
      .s_axis_tuser,
      .s_axis_tlast,
      .m_axis_contour_tvalid,
      .m_axis_contour_tready,
      .m_axis_contour_tdata(contour),
      .m_axis_contour_tuser,
      .m_axis_contour_tlast,
      .m_axis_vertex_tvalid,
      .m_axis_vertex_tready,
      .m_axis_vertex_tdata(vertex),
      .m_axis_vertex_tlast
  );
endmodule
