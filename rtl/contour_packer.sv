// SPDX-License-Identifier: Apache-2.0
//
// Joins gradient vectors and contour flags of the same pixel into the contour stream.
//
//   slope_*       {magnitude, gy, gx} of each pixel, raster order, slope_first_i at a frame's
//                 first, slope_begins_i two clocks before; some clocks ahead of
//   flags_*       {first, contour} of each real pixel, with sol, eol, sof of its row
//   ready_o       room for everything that is still in the pipeline: a beat may enter it
//   m_axis_*      beat: [0] contour, [1] first contour, [23:8] magnitude, [39:24] gx,
//                 [55:40] gy; tuser first pixel of a frame, tlast last pixel of a line
//
// Both halves of a frame's first pixel are marked. Where only one is, an upset has lost or made up a beat
// or a mark: flags without a mark are dropped until theirs comes; a gradient without one says that nothing
// fits, and all is dropped. What waits is thrown away when the next frame's gradients begin.
//
// Latency 3 clocks, throughput 1 pixel per clock. The pipeline behind ready_o may still deliver
// Reserve pixels after ready_o has fallen.
module contour_packer #(
    parameter int FractionBits = 3,   // of the gradient, 0 .. 6
    parameter int Depth        = 64,  // pixels that wait for the consumer, a power of two
    parameter int Reserve      = 32   // pixels that may come after ready_o has fallen
) (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    input  logic                       slope_valid_i,
    input  logic                       slope_first_i,
    input  logic                       slope_begins_i,
    input  logic [3*FractionBits+21:0] slope_data_i,
    input  logic                       flags_valid_i,
    input  logic                       flags_sol_i,
    input  logic                       flags_eol_i,
    input  logic                       flags_sof_i,
    input  logic [                1:0] flags_data_i,
    output logic                       ready_o,
    output logic                       m_axis_tvalid_o,
    input  logic                       m_axis_tready_i,
    output logic [               63:0] m_axis_tdata_o,
    output logic                       m_axis_tuser_o,
    output logic                       m_axis_tlast_o
);
  localparam int MagnitudeBits = 6 + FractionBits;
  localparam int SlopeBits = 8 + FractionBits;
  localparam int LevelBits = $clog2(Depth) + 1;
  if (FractionBits < 0 || FractionBits > 6 || Reserve < 1 || Depth <= Reserve) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6_and_Depth_greater_than_Reserve stop ();
  end

  logic [LevelBits-1:0] slope_level;
  logic slope_valid, flags_valid, slope_marked, in_step, flush_q;
  logic lost_q, late_q;  // all is dropped; flags are dropped until their mark
  logic signed [SlopeBits-1:0] gx, gy;
  logic [MagnitudeBits-1:0] magnitude;
  logic first, contour;

  stream_fifo #(
      .Width(1 + 2 * SlopeBits + MagnitudeBits),
      .Depth(Depth)
  ) i_slope (
      .clk_i,
      .rst_ni(rst_ni && !flush_q),
      .push_i(slope_valid_i),
      .data_i({slope_first_i, slope_data_i}),
      .level_o(slope_level),
      .m_tvalid_o(slope_valid),
      .m_tready_i(lost_q || (flags_valid && in_step && m_axis_tready_i)),
      .m_tdata_o({slope_marked, magnitude, gy, gx})
  );

  stream_fifo #(
      .Width(4),
      .Depth(Depth)
  ) i_flags (
      .clk_i,
      .rst_ni(rst_ni && !flush_q),
      .push_i(flags_valid_i),
      .data_i({flags_data_i, flags_sof_i && flags_sol_i, flags_eol_i}),
      .level_o(),
      .m_tvalid_o(flags_valid),
      .m_tready_i(lost_q || (slope_valid && (in_step ? m_axis_tready_i : slope_marked))),
      .m_tdata_o({first, contour, m_axis_tuser_o, m_axis_tlast_o})
  );

  assign in_step = !lost_q && slope_marked == m_axis_tuser_o;
  always_ff @(posedge clk_i) begin
    flush_q <= rst_ni && slope_begins_i && (lost_q || late_q) && !m_axis_tvalid_o;
    if (!rst_ni) begin
      {lost_q, late_q} <= '0;
    end else if (flush_q) begin
      {lost_q, late_q} <= 2'b01;
    end else if (slope_valid && flags_valid && !lost_q) begin
      late_q <= !in_step && slope_marked;
      lost_q <= !in_step && !slope_marked;
    end
  end
  assign m_axis_tvalid_o = flags_valid && slope_valid && in_step && !flush_q;
  assign m_axis_tdata_o = {8'b0, 16'(gy), 16'(gx), 16'(magnitude), 6'b0, first, contour};

  always_ff @(posedge clk_i) begin
    // Where no flags wait the pipeline goes on, whatever the level says.
    ready_o <= rst_ni && (slope_level < LevelBits'(Depth - Reserve) || !flags_valid);
  end

  // Handshake; the flags of a pixel never come before its gradient.
  logic held_q;
  logic [63:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_axis_tvalid_o && !m_axis_tready_i;
    held_data_q <= m_axis_tdata_o;
    if (rst_ni) begin
      assert (!held_q || (m_axis_tvalid_o && m_axis_tdata_o == held_data_q));
      assert (!flags_valid || (slope_valid && in_step));
    end
  end
endmodule
