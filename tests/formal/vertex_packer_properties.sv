// SPDX-License-Identifier: Apache-2.0
//
// vertex_packer behind any pipeline that keeps to ready_o: each vertex below the limit and each end of a
// frame comes out once, in order, as one record: what came in, the frame's counts and tag; an offered record
// stays; nothing overruns.
//
// Vertices and ends may come only when ready_o said so two clocks ago, a vertex three clocks behind the
// last one, both five behind an end. An arbitrary record is watched through the memory (open_memory.sv).
module vertex_packer_properties (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        vertex_valid,
    input logic        end_valid,
    input logic [11:0] x,
    input logic [11:0] y,
    input logic [ 3:0] branches,
    input logic [ 7:0] pattern,
    input logic [ 6:0] strength,
    input logic [ 1:0] fault,
    input logic [15:0] new_limit,
    input logic        watch,
    input logic        tready
);
  localparam int Depth = 16;

  logic started_q = 1'b0;
  logic ready, done, tvalid, tlast;
  logic [15:0] limit_q, done_sent, done_lost;
  logic [63:0] tdata;
  vertex_packer #(
      .View        (5),
      .PatternBits (8),
      .StrengthBits(7),
      .Depth       (Depth),
      .Reserve     (5)
  ) dut (
      .clk_i,
      .rst_ni,
      .vertex_valid_i(vertex_valid),
      .vertex_x_i(x),
      .vertex_y_i(y),
      .vertex_branches_i(branches),
      .vertex_pattern_i(pattern),
      .vertex_strength_i(strength),
      .end_valid_i(end_valid),
      .end_fault_i(fault),
      .limit_i(limit_q),
      .ready_o(ready),
      .frame_done_o(done),
      .sent_o(done_sent),
      .lost_o(done_lost),
      .m_axis_tvalid_o(tvalid),
      .m_axis_tready_i(tready),
      .m_axis_tdata_o(tdata),
      .m_axis_tlast_o(tlast)
  );

  // What came in, newest in the low bits: vertices, those that are sent, ends.
  logic [1:0] may_q;
  logic [6:0] vertex_q, sent_vertex_q, end_q;
  logic [15:0] sent_q, lost_q;
  logic [7:0] frame_q;
  logic sent, record, taken;
  logic [63:0] vertex_record, end_record;
  assign sent = vertex_valid && sent_q != limit_q;
  assign record = sent || end_valid;
  assign taken = tvalid && tready;
  assign vertex_record = {5'b0, strength, pattern, branches, y, x, frame_q, 2'b0, 4'd5, 2'd0};
  assign end_record = {12'b0, lost_q != '0, fault == 2'd3, fault == 2'd2, fault == 2'd1, lost_q,
                       sent_q, frame_q, 2'b0, 4'd5, 2'd1};

  // Records under way, which of them are ends, oldest in the low bits; the watched one's place.
  logic [2:0] count_q, left, ahead_q;
  logic [5:0] ends_q, ends_left;
  logic watching_q, watched_q, held_q, was_reset_q;
  logic [63:0] watched_record_q, held_data_q;
  assign left = count_q - 3'(taken);
  assign ends_left = taken ? ends_q >> 1 : ends_q;
  always_ff @(posedge clk_i) begin
    started_q   <= 1'b1;
    was_reset_q <= !rst_ni;
    may_q <= rst_ni ? {may_q[0], ready} : '0;
    if (!started_q) assume (!rst_ni);
    assume (!(vertex_valid && end_valid));
    assume (!(vertex_valid || end_valid) || (rst_ni && may_q[1] && end_q[3:0] == '0));
    assume (!vertex_valid || vertex_q[1:0] == '0);
    if (!rst_ni) begin
      {vertex_q, sent_vertex_q, end_q} <= '0;
      {sent_q, lost_q, frame_q, count_q, ends_q, watching_q, watched_q} <= '0;
      limit_q <= new_limit;  // a setting: it changes while nothing is under way
    end else begin
      vertex_q      <= {vertex_q[5:0], vertex_valid};
      sent_vertex_q <= {sent_vertex_q[5:0], sent};
      end_q         <= {end_q[5:0], end_valid};
      if (end_valid) begin
        {sent_q, lost_q} <= '0;
        frame_q <= frame_q + 8'd1;
      end else if (vertex_valid) begin
        sent_q <= sent_q + 16'(sent);
        lost_q <= lost_q + 16'(!sent && lost_q != '1);
      end
      count_q <= left + 3'(record);
      for (int i = 0; i < 6; i++) ends_q[i] <= left == 3'(i) ? end_valid : ends_left[i];
      if (record && watch && !watched_q) begin
        {watching_q, watched_q} <= '1;
        ahead_q <= left;
      end else if (taken && watching_q) begin
        ahead_q <= ahead_q - 3'd1;
        watching_q <= ahead_q != '0;
      end
    end
    if (record && watch && !watched_q) watched_record_q <= end_valid ? end_record : vertex_record;
    held_q      <= rst_ni && tvalid && !tready;
    held_data_q <= tdata;
    if (started_q && rst_ni) begin
      assert (!was_reset_q || !tvalid);
      assert (!held_q || (tvalid && tdata == held_data_q));
      if (tvalid) begin
        assert (count_q != '0 && tlast == tdata[0]);
        if (watching_q && ahead_q == '0) assert (tdata == watched_record_q);
      end
    end
  end

  // What holds inside, so that a proof needs less search. Words under way: in the output register, in the
  // memory, in the record that is sent, in the end that waits.
  (* hierconn *) wire [15:0] \dut.sent_q , \dut.lost_q ;
  (* hierconn *) wire \dut.below_limit_q , \dut.lost_full_q , \dut.end_waits_q ;
  (* hierconn *) wire [1:0] \dut.waiting_fault_q , \dut.have_q , \dut.idle_q ;
  (* hierconn *) wire [2:0] \dut.words_q ;
  (* hierconn *) wire [47:0] \dut.record_q ;
  (* hierconn *) wire [31:0] \dut.words_low_q ;
  (* hierconn *) wire [7:0] \dut.tag_q ;
  (* hierconn *) wire [4:0] \dut.i_records.write_q , \dut.i_records.read_q , \dut.i_records.after_q ;
  (* hierconn *) wire [4:0] \dut.i_records.level_o ;
  (* hierconn *) wire \dut.i_records.there_q , \dut.i_records.m_tvalid_o ;
  (* hierconn *) wire [15:0] \dut.i_records.entry , \dut.i_records.m_tdata_o ;
  (* hierconn *) wire [16*Depth-1:0] \dut.i_records.i_entries.words_q ;
  logic pushed_q, pushed2_q;
  logic [15:0] sent1_q, lost1_q, limit1_q, end_sent_q, end_lost_q;
  logic [1:0] end_fault_q;
  logic [19:0] levels_q;  // of the last four clocks, newest in the low bits
  wire out_valid = \dut.i_records.m_tvalid_o ;
  wire [1:0] have = \dut.have_q ;
  wire [4:0] level = \dut.i_records.write_q - \dut.i_records.read_q ;
  wire [2:0] words = \dut.words_q ;
  wire [1:0] word_count = 2'(words[0]) + 2'(words[1]) + 2'(words[2]);
  wire waits = \dut.end_waits_q ;
  wire [5:0] under_way = 6'(level) + 6'(word_count) + (waits ? 6'd3 : 6'd0);
  wire [47:0] waiting_end = {1'b1, 11'b0, \dut.lost_q != '0, \dut.waiting_fault_q == 2'd3,
                             \dut.waiting_fault_q == 2'd2, \dut.waiting_fault_q == 2'd1, \dut.lost_q ,
                             \dut.sent_q };

  // The word at place i of those under way, from the first of the record that leaves next.
  wire [16*18-1:0] word;
  for (genvar i = 0; i < 18; i++) begin : gen_words
    wire [5:0] place = 6'(i) - 6'(have);
    wire [5:0] behind = place - 6'(out_valid);
    wire [5:0] last = behind - 6'(level);
    wire [5:0] beyond = last - 6'(word_count);
    wire [3:0] address = \dut.i_records.read_q [3:0] + behind[3:0];
    wire [15:0] stored = 16'(\dut.i_records.i_entries.words_q >> {address, 4'b0});
    wire [15:0] sending = 16'(\dut.record_q >> {last[1:0], 4'b0});
    wire [15:0] waiting = 16'(waiting_end >> {beyond[1:0], 4'b0});
    assign word[16*i+:16] = 6'(i) < 6'(have) ? (have == 2'd1 || i == 1 ? \dut.words_low_q [31:16]
                                                                      : \dut.words_low_q [15:0])
                            : out_valid && place == '0 ? \dut.i_records.m_tdata_o
                            : behind < 6'(level) ? stored : last < 6'(word_count) ? sending : waiting;
  end

  // Records loaded k + 1 clocks ago: a vertex, an end that found the last record sent, one that waited.
  wire [2:0] loaded = sent_vertex_q[2:0] | (end_q[2:0] & ~sent_vertex_q[3:1] & ~sent_vertex_q[4:2]) |
                      ((end_q[3:1] | end_q[4:2]) & sent_vertex_q[5:3]);
  wire [3:0] records = sent_vertex_q[3:0] | end_q[3:0];
  wire [5:0] ends_ahead = ends_q & ~(6'h3f << ahead_q), ends_under_way = ends_q & ~(6'h3f << count_q);
  function automatic logic [7:0] ones(input logic [5:0] bits);
    ones = 8'(bits[0]) + 8'(bits[1]) + 8'(bits[2]) + 8'(bits[3]) + 8'(bits[4]) + 8'(bits[5]);
  endfunction
  always_ff @(posedge clk_i) begin
    {pushed2_q, pushed_q} <= rst_ni ? {pushed_q, words[0]} : '0;
    levels_q <= rst_ni ? {levels_q[14:0], level} : '0;
    {sent1_q, lost1_q, limit1_q} <= {\dut.sent_q , \dut.lost_q , limit_q};
    if (end_valid) {end_sent_q, end_lost_q, end_fault_q} <= {sent_q, lost_q, fault};
    if (started_q && rst_ni) begin
      // What came in, and how far it is.
      assert ((sent_vertex_q & ~vertex_q) == '0 && (vertex_q & end_q) == '0);
      assert ((vertex_q & vertex_q >> 1) == '0 && (vertex_q & vertex_q >> 2) == '0);
      for (int k = 1; k < 5; k++) assert (((vertex_q | end_q) & end_q >> k) == '0);
      assert (words == (loaded[0] ? 3'b111 : loaded[1] ? 3'b011 : {2'b0, loaded[2]}));
      assert (waits == ((end_q[0] && (sent_vertex_q[1] || sent_vertex_q[2])) ||
                        (end_q[1] && sent_vertex_q[2])));
      // The counts.
      if (waits) begin
        assert ({\dut.waiting_fault_q , \dut.sent_q , \dut.lost_q } == {end_fault_q, end_sent_q, end_lost_q});
        assert (sent_q == '0 && lost_q == '0);
      end else begin
        assert (\dut.sent_q == sent_q && \dut.lost_q == lost_q);
      end
      assert (\dut.below_limit_q == (sent1_q != limit1_q) && \dut.lost_full_q == (lost1_q == '1));
      assert (was_reset_q ? may_q == '0 : limit1_q == limit_q);
      assert (was_reset_q || loaded[0] || sent1_q == \dut.sent_q );
      assert (was_reset_q || loaded[0] || vertex_q[0] || lost1_q == \dut.lost_q );
      // Room.
      assert (level >= 5'(pushed_q) && \dut.i_records.after_q == \dut.i_records.read_q + 5'd1);
      assert (\dut.i_records.there_q == (level != 5'(pushed_q)));
      assert (\dut.i_records.level_o == levels_q[4:0]);
      assert (!ready || levels_q[9:5] == '0);
      assert (!may_q[0] || levels_q[14:10] == '0);
      assert (!may_q[1] || levels_q[19:15] == '0);
      assert (under_way <= 6'(levels_q[4:0]) + 6'd6 + 6'd3 * 6'(records[0]));
      assert (under_way <= 6'(levels_q[9:5]) + 6'd6 + 6'd3 * 6'(ones({4'b0, records[1:0]})));
      assert (under_way <= 6'(levels_q[14:10]) + 6'd6 + 6'd3 * 6'(ones({3'b0, records[2:0]})));
      assert (under_way <= 6'(levels_q[19:15]) + 6'd6 + 6'd3 * 6'(ones({2'b0, records})));
      assert (under_way <= 6'd15);
      // Whole records.
      assert (have != 2'd3 && 6'd3 * 6'(count_q) == 6'(have) + 6'(out_valid) + under_way);
      assert ((\dut.idle_q & {pushed2_q, pushed_q}) == '0);
      assert (out_valid || levels_q[4:0] == 5'(pushed2_q));
      // Their words.
      assert (!\dut.i_records.there_q || \dut.i_records.entry ==
              16'(\dut.i_records.i_entries.words_q >> {\dut.i_records.read_q [3:0], 4'b0}));
      for (int i = 0; i < 6; i++) assert (3'(i) >= count_q || word[48*i+47] == ends_q[i]);
      assert (frame_q == \dut.tag_q + ones(ends_under_way));
      if (watching_q) begin
        assert (ahead_q < count_q && !watched_record_q[63]);
        assert (watched_record_q[0] || watched_record_q[62:59] == '0);
        assert (watched_record_q[0] == ends_q[ahead_q] && watched_record_q[7:1] == 7'd10);
        assert (watched_record_q[15:8] == \dut.tag_q + ones(ends_ahead));
        assert (48'(word >> (48 * ahead_q)) == {watched_record_q[0], watched_record_q[62:16]});
      end
    end
  end
endmodule
