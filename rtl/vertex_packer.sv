// SPDX-License-Identifier: Apache-2.0
//
// Counts a view's vertices, limits them per frame and packs them into records.
//
//   vertex_valid_i, vertex_*_i  one vertex
//   end_valid_i, end_fault_i    the frame is complete (never together with a vertex); how it
//                               ended: see frame_guard
//   limit_i                     most vertices sent per frame; the others are counted as lost
//   ready_o                     room for everything that is still in the pipeline: of about 70
//                               beats under way each third can be a vertex, each fifth an end
//   frame_done_o, sent_o, lost_o   one clock per frame: its counts
//   m_axis_*   vertex record: [1:0] 0, [5:2] view, [15:8] frame tag, [27:16] x, [39:28] y,
//              [43:40] branches, [51:44] pattern, [63:52] strength; end-of-frame record:
//              [1:0] 1, view, tag, [31:16] sent, [47:32] lost, [63:48] status: bit 0 cut by a bad
//              line, 1 bad height, 2 smaller than 5 rows, 3 vertices lost; tlast on it
//
// A record waits as three words of 16 bits, which fills a block RAM of any family better than one
// of 46. Latency 8 clocks, throughput 1 record per 3 clocks: vertices are never nearer than three
// columns, and an end that comes closer behind a vertex waits. The frame tag counts frames modulo
// 256.
module vertex_packer #(
    parameter int View         = 0,    // tag in its records, 0 .. 15
    parameter int PatternBits  = 8,    // 1 .. 8
    parameter int StrengthBits = 8,    // 1 .. 12
    parameter int Depth        = 128,  // words that wait for the consumer, a power of two
    parameter int Reserve      = 32    // records that may come after ready_o has fallen
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
      StrengthBits > 12 || Reserve < 1 || Depth <= 3 * Reserve) begin : gen_illegal
    illegal_View_0_to_15_PatternBits_1_to_8_StrengthBits_1_to_12_Depth_above_3_Reserve stop ();
  end
  localparam int LevelBits = $clog2(Depth) + 1;
  localparam int VertexBits = 28 + PatternBits + StrengthBits;

  // The record that is being sent, low word first, and the end that waits for it.
  logic [15:0] sent_q, lost_q;
  logic below_limit_q, lost_full_q, take_vertex, take_end, end_waits_q;
  logic [1:0] waiting_fault_q, fault;
  logic [2:0] words_q;  // words left, one bit each
  logic [47:0] record_q;
  logic [LevelBits-1:0] level;

  assign take_vertex = vertex_valid_i && below_limit_q;
  assign take_end = (end_valid_i || end_waits_q) && !words_q[1];
  assign fault = end_waits_q ? waiting_fault_q : end_fault_i;
  assign {lost_o, sent_o} = record_q[31:0];

  always_ff @(posedge clk_i) begin
    if (take_vertex) begin
      record_q <= 48'({vertex_strength_i, vertex_pattern_i, vertex_branches_i, vertex_y_i,
                       vertex_x_i});
    end else if (take_end) begin
      record_q <= {1'b1, 11'b0, lost_q != '0, fault == 2'd3, fault == 2'd2, fault == 2'd1,
                   lost_q, sent_q};
    end else begin
      record_q <= {16'b0, record_q[47:16]};
    end
    // A clock late: two vertices never come in a row. The limit holds for a frame.
    below_limit_q <= sent_q != limit_i;
    lost_full_q   <= lost_q == '1;
    if (end_valid_i) waiting_fault_q <= end_fault_i;
    if (!rst_ni) begin
      {sent_q, lost_q} <= '0;
      {words_q, end_waits_q, frame_done_o} <= '0;
    end else begin
      words_q      <= take_vertex || take_end ? 3'b111 : words_q >> 1;
      end_waits_q  <= (end_valid_i || end_waits_q) && !take_end;
      frame_done_o <= take_end;
      if (take_end) begin
        {sent_q, lost_q} <= '0;
      end else if (take_vertex) begin
        sent_q <= sent_q + 16'd1;
      end else if (vertex_valid_i && !lost_full_q) begin
        lost_q <= lost_q + 16'd1;
      end
    end
    ready_o <= rst_ni && level < LevelBits'(Depth - 3 * Reserve);
  end

  logic word_valid, word_ready;
  logic [15:0] word;
  stream_fifo #(
      .Width(16),
      .Depth(Depth)
  ) i_records (
      .clk_i,
      .rst_ni,
      .push_i(words_q[0]),
      .data_i(record_q[15:0]),
      .level_o(level),
      .m_tvalid_o(word_valid),
      .m_tready_i(word_ready),
      .m_tdata_o(word)
  );

  // The first two words wait for the third. Where no word is left or on its way a record begins, so
  // that a word lost or made up by an upset spoils no further frame.
  logic [1:0] idle_q;  // no word was left one and two clocks ago
  logic [1:0] have_q;
  logic [31:0] words_low_q;
  logic [47:0] out;
  logic out_end;
  assign out = {word, words_low_q};
  assign out_end = out[47];
  assign m_axis_tvalid_o = word_valid && have_q == 2'd2;
  assign word_ready = m_axis_tready_i || have_q != 2'd2;
  always_ff @(posedge clk_i) begin
    if (word_valid && have_q != 2'd2) words_low_q <= {word, words_low_q[31:16]};
    idle_q <= {idle_q[0], words_q == '0};
    if (!rst_ni || (idle_q == '1 && words_q == '0 && !word_valid)) have_q <= '0;
    else if (word_valid && word_ready) have_q <= have_q == 2'd2 ? 2'd0 : have_q + 2'd1;
  end

  logic [7:0] tag_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) tag_q <= '0;
    else tag_q <= tag_q + 8'(m_axis_tvalid_o && m_axis_tready_i && out_end);
  end

  logic [47:0] vertex, frame_end;
  assign vertex = {12'(out[VertexBits-1-:StrengthBits]), 8'(out[28+:PatternBits]), out[27:0]};
  assign frame_end = {1'b0, out[46:0]};
  assign m_axis_tdata_o = {out_end ? frame_end : vertex, tag_q, 2'b0, 4'(View), 1'b0, out_end};
  assign m_axis_tlast_o = out_end;

  // Handshake; a vertex and a frame's end never come together, and neither finds the last record
  // unsent.
  logic held_q;
  logic [63:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_axis_tvalid_o && !m_axis_tready_i;
    held_data_q <= m_axis_tdata_o;
    if (rst_ni) begin
      assert (!held_q || (m_axis_tvalid_o && m_axis_tdata_o == held_data_q));
      assert (!(vertex_valid_i && (end_valid_i || end_waits_q || words_q[1])));
      assert (!(end_valid_i && end_waits_q));
      assert (!(idle_q == '1 && words_q == '0 && !word_valid) || have_q == '0);
    end
  end
endmodule
