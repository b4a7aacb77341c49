// SPDX-License-Identifier: Apache-2.0
//
// Counts a view's vertices, limits them per frame and packs them into records.
//
//   vertex_valid_i, vertex_*_i  one vertex
//   end_valid_i, end_fault_i    the frame is complete (never together with a vertex); how it
//                               ended: see frame_guard
//   limit_i                     most vertices sent per frame; the others are counted as lost
//   ready_o                     room for everything that is still in the pipeline: of about 80
//                               beats under way each third can be a vertex, each fifth an end
//   frame_done_o, sent_o, lost_o   one clock per frame: its counts
//   m_axis_*   vertex record: [1:0] 0, [5:2] view, [15:8] frame tag, [27:16] x, [39:28] y,
//              [43:40] branches, [51:44] pattern, [63:52] strength; end-of-frame record:
//              [1:0] 1, view, tag, [31:16] sent, [47:32] lost, [63:48] status: bit 0 cut by a bad
//              line, 1 bad height, 2 smaller than 5 rows, 3 vertices lost; tlast on it
//
// Latency 3 clocks, throughput 1 record per clock. The frame tag counts frames modulo 256.
module vertex_packer #(
    parameter int View         = 0,
    parameter int PatternBits  = 8,
    parameter int StrengthBits = 8,
    parameter int Depth        = 64,  // records that wait for the consumer, a power of two
    parameter int Reserve      = 40   // records that may come after ready_o has fallen
) (
    input  logic                    clk_i,
    input  logic                    rst_ni,
    input  logic                    vertex_valid_i,
    input  logic [            11:0] vertex_x_i,
    input  logic [            11:0] vertex_y_i,
    input  logic [             3:0] vertex_branches_i,
    input  logic [ PatternBits-1:0] vertex_pattern_i,
    input  logic [StrengthBits-1:0] vertex_strength_i,
    input  logic                    end_valid_i,
    input  logic [             1:0] end_fault_i,
    input  logic [            15:0] limit_i,
    output logic                    ready_o,
    output logic                    frame_done_o,
    output logic [            15:0] sent_o,
    output logic [            15:0] lost_o,
    output logic                    m_axis_tvalid_o,
    input  logic                    m_axis_tready_i,
    output logic [            63:0] m_axis_tdata_o,
    output logic                    m_axis_tlast_o
);
  if (View < 0 || View > 15 || PatternBits < 1 || PatternBits > 8 || StrengthBits < 1 ||
      StrengthBits > 12 || Reserve < 1 || Depth <= Reserve) begin : gen_illegal
    illegal_View_0_to_15_PatternBits_1_to_8_StrengthBits_1_to_12_Depth_above_Reserve stop ();
  end
  localparam int LevelBits = $clog2(Depth) + 1;
  localparam int VertexBits = 28 + PatternBits + StrengthBits;
  localparam int Width = VertexBits > 36 ? VertexBits : 36;

  logic [15:0] sent_q, lost_q;
  logic below_limit, push_q, push_end_q;
  logic [Width-1:0] record_q;
  logic [LevelBits-1:0] level;

  assign below_limit = sent_q < limit_i;
  assign frame_done_o = push_end_q;

  always_ff @(posedge clk_i) begin
    record_q <= end_valid_i ? Width'({lost_q != '0, end_fault_i == 2'd3, end_fault_i == 2'd2,
                                      end_fault_i == 2'd1, lost_q, sent_q})
        : Width'({vertex_strength_i, vertex_pattern_i, vertex_branches_i, vertex_y_i, vertex_x_i});
    sent_o <= sent_q;
    lost_o <= lost_q;
    if (!rst_ni) begin
      {sent_q, lost_q} <= '0;
      {push_q, push_end_q} <= '0;
    end else begin
      push_q     <= end_valid_i || (vertex_valid_i && below_limit);
      push_end_q <= end_valid_i;
      if (end_valid_i) begin
        {sent_q, lost_q} <= '0;
      end else if (vertex_valid_i && below_limit) begin
        sent_q <= sent_q + 16'd1;
      end else if (vertex_valid_i && lost_q != '1) begin
        lost_q <= lost_q + 16'd1;
      end
    end
    ready_o <= rst_ni && level < LevelBits'(Depth - Reserve);
  end

  logic out_end;
  logic [Width-1:0] out;
  stream_fifo #(
      .Width(Width + 1),
      .Depth(Depth)
  ) i_records (
      .clk_i,
      .rst_ni,
      .push_i(push_q),
      .data_i({push_end_q, record_q}),
      .level_o(level),
      .m_tvalid_o(m_axis_tvalid_o),
      .m_tready_i(m_axis_tready_i),
      .m_tdata_o({out_end, out})
  );

  logic [7:0] tag_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) tag_q <= '0;
    else tag_q <= tag_q + 8'(m_axis_tvalid_o && m_axis_tready_i && out_end);
  end

  logic [47:0] vertex, frame_end;
  assign vertex = {12'(out[VertexBits-1-:StrengthBits]), 8'(out[28+:PatternBits]), out[27:0]};
  assign frame_end = {12'b0, out[35:0]};
  assign m_axis_tdata_o = {out_end ? frame_end : vertex, tag_q, 2'b0, 4'(View), 1'b0, out_end};
  assign m_axis_tlast_o = out_end;

  // Handshake; a vertex and a frame's end never come together.
  logic held_q;
  logic [63:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_axis_tvalid_o && !m_axis_tready_i;
    held_data_q <= m_axis_tdata_o;
    if (rst_ni) begin
      assert (!held_q || (m_axis_tvalid_o && m_axis_tdata_o == held_data_q));
      assert (!(vertex_valid_i && end_valid_i));
    end
  end
endmodule
