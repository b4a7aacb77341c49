// SPDX-License-Identifier: Apache-2.0
//
// row_slots for any announcements that frame_guard can make (its proved properties) and any back
// pressure: what leaves is a stream of row slots (slot_stream) in which each announced line is one
// row of its width, in order, its pixels read from where they stand in the ring, and restart comes where
// it changes nothing; a frame's rows follow each other, and the row behind a frame carries its fault.
// Whoever can go on goes on: a patient consumer gets a beat in the fourth clock at the latest whenever a
// line waits or an ended frame is to be drained.
//
// drained: behind the last real row came 11 void rows and 96 beats of a twelfth or more; its frame has
// left the pipeline by then. width_free: the same behind the last row of the width that is not in force.
//
// Steady leaves nothing open, for searches far from reset: a consumer that takes every beat, an input that
// rests, frames of three rows, 6 and 5 px wide in turn, each as soon as it may come.
module row_slots_properties #(
    parameter bit Steady = 1'b0
) (
    input logic       clk_i,
    input logic       any_rst_n,
    input logic       any_line,
    input logic       any_whole,
    input logic       any_last,
    input logic       any_flip,
    input logic [2:0] any_width,
    input logic       any_go,
    input logic       any_idle,
    input logic       any_switch
);
  localparam int MaxWidthPx = 6;
  localparam int RingBits = 5;
  localparam int Lag = 10;
  localparam logic [3:0] Most = 4'd12;

  logic started_q = 1'b0;
  logic line_ready, drained, free, valid, sol, sof, is_real, in_row, open_q, read, restart, unread;
  logic [1:0] fault, fault_in_q, fault_out_q;
  logic [5:0] width_q, before_last;
  logic tag_q;  // the width in force
  assign before_last = {width_q[5:3] - 3'd2, width_q[2:0] - 3'd2};
  logic rst_ni, line_valid, line_whole, line_last, flip, go, idle, switch_wanted, line_ready_q, fresh_q;
  logic [2:0] new_width;
  if (Steady) begin : gen_steady
    logic [1:0] rows_q;
    assign {rst_ni, go, idle, switch_wanted} = {started_q, 3'b110};
    assign flip = rst_ni && free && !open_q && !fresh_q;
    assign new_width = tag_q ? 3'd5 : 3'd6;
    assign {line_valid, line_whole} = {rst_ni && line_ready_q && !flip && rows_q != 2'd3, 1'b1};
    assign line_last = rows_q == 2'd2;
    always_ff @(posedge clk_i) rows_q <= !rst_ni ? 2'd3 : flip ? 2'd0 : rows_q + 2'(line_valid);
  end else begin : gen_any
    assign {rst_ni, line_valid, line_whole, line_last} = {any_rst_n, any_line, any_whole, any_last};
    assign {flip, new_width, go, idle, switch_wanted} = {any_flip, any_width, any_go, any_idle, any_switch};
  end
  row_slots #(
      .MaxWidthPx(MaxWidthPx)
  ) dut (
      .clk_i,
      .rst_ni,
      .line_valid_i(line_valid),
      .line_ready_o(line_ready),
      .line_whole_i(line_whole),
      .line_first_i(!open_q),
      .line_last_i(line_last),
      .line_fault_i(fault_in_q),
      .line_tag_i(tag_q),
      .before_last_i(before_last),
      .width_free_o(free),
      .read_o(read),
      .restart_o(restart),
      .unread_o(unread),
      .go_i(go),
      .idle_i(idle),
      .switch_i(switch_wanted),
      .drained_o(drained),
      .valid_o(valid),
      .sol_o(sol),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(fault),
      .in_row_o(in_row)
  );

  // frame_guard's part. Faults are marks: the frame's number. A width changes when it is free, between
  // frames; the next line has it. frame_guard waits only behind a frame.
  logic [RingBits:0] announced_q, frame_q, read_q;
  logic unread_q;
  wire [2:0] width = tag_q ? width_q[5:3] : width_q[2:0];
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
    assume (!line_valid || (rst_ni && line_ready_q && (line_whole || (line_last && open_q))));
    assume (!switch_wanted || !open_q || (line_valid && line_last));
    assume (new_width == 3'd5 || new_width == 3'd6);
    assume (!line_valid || width >= 3'd5);
    assume (!flip || (rst_ni && free && !line_valid && !open_q && !fresh_q));
    if (!rst_ni) begin
      {open_q, fault_in_q, announced_q, frame_q, read_q, tag_q, fresh_q} <= '0;
      width_q <= {2{3'd2}};  // before_last_i is 0 after a reset
    end else begin
      if (line_valid) begin
        open_q <= !line_last;
        fault_in_q <= fault_in_q + 2'(line_last);
        announced_q <= announced_q + (line_whole ? 6'(width) : 6'd0);
        if (!open_q) frame_q <= announced_q;
      end
      if (flip) begin
        tag_q <= !tag_q;
        if (tag_q) width_q[2:0] <= new_width;
        else width_q[5:3] <= new_width;
      end
      fresh_q <= flip || (fresh_q && !(line_valid && line_whole));
      // pixel_ring's part.
      read_q <= restart ? frame_q : read_q + 6'(read);
    end
    unread_q <= rst_ni && announced_q != read_q;
    line_ready_q <= rst_ni && line_ready;
  end

  // The stages behind: the frames that ended, the beats behind eleven rows.
  logic ok, real_q, end_here;
  logic [1:0] kind, far, may_change;
  logic [2:0] out_col;
  logic [7:0] age;
  logic [13:0] beats_q;  // for each width
  assign end_here = valid && sol && real_q && (sof || !is_real);
  slot_stream #(
      .Voids(Lag)
  ) out (
      .clk_i,
      .rst_ni,
      .width_i(width_q),
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .ok_o(ok),
      .kind_o(kind),
      .col_o(out_col),
      .age_o(age),
      .may_change_o(may_change)
  );
  assign far = {age[7:4] == Most, age[3:0] == Most};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {real_q, fault_out_q} <= '0;
      beats_q <= '1;
    end else if (valid) begin
      if (sol) real_q <= is_real || sof;
      fault_out_q <= fault_out_q + 2'(end_here);
      for (int t = 0; t < 2; t++) begin
        beats_q[7*t+:7] <= !far[t] ? 7'd0 : beats_q[7*t+:7] < 7'd96 ? beats_q[7*t+:7] + 7'd1
                                                                    : beats_q[7*t+:7];
      end
    end
  end

  // Clocks without a beat although there is something to send and the consumer takes it.
  (* hierconn *) wire \dut.head_valid , \dut.head_whole , \dut.ended_q , \dut.left , \dut.other_left ;
  (* hierconn *) wire \dut.second_width_q , \dut.second_slot_q , \dut.first_wider_q ;
  wire [6:0] other_beats = tag_q ? beats_q[6:0] : beats_q[13:7];
  logic [1:0] waits_q, to_go;
  logic wanted;
  assign wanted = go && ((\dut.head_valid && \dut.head_whole ) ||
                         (\dut.ended_q && !\dut.left && (idle || switch_wanted)));
  always_ff @(posedge clk_i) begin
    waits_q <= rst_ni && wanted && !valid ? waits_q + 2'd1 : '0;
    if (started_q && rst_ni) begin
      assert (ok);
      assert (!end_here || fault == fault_out_q);
      assert (!drained || (!open_q && beats_q[6:0] >= 7'd96 && beats_q[13:7] >= 7'd96));
      assert (!free || fresh_q || (other_beats >= 7'd96 && may_change[!tag_q]));
      assert (!restart || (frame_q == read_q + 6'(read) && !free));
      assert (unread || !unread_q);
      assert (waits_q != 2'd3 || valid);
      // A row's columns are those of its width.
      assert (!valid || kind == 2'd0 || in_row == (out_col < (kind[1] ? width_q[5:3] : width_q[2:0])));
    end
  end

  // What holds inside, so that a proof needs less search.
  (* hierconn *) wire \dut.busy_q , \dut.real_q , \dut.sof_q , \dut.sol_q , \dut.last_q ;
  (* hierconn *) wire \dut.row_last_q , \dut.in_row_q , \dut.head_tag ;
  (* hierconn *) wire [2:0] \dut.col_q , \dut.slot_limit_q , \dut.row_limit_q ;
  (* hierconn *) wire \dut.start_line , \dut.start_void ;
  logic slot_started_q;
  (* hierconn *) wire [3:0] \dut.i_left.rows_q , \dut.i_other_left.rows_q ;
  (* hierconn *) wire [6:0] \dut.i_left.beats_q , \dut.i_other_left.beats_q ;
  (* hierconn *) wire [1:0] \dut.fault_q , \dut.slot_fault_q ;
  (* hierconn *) wire [3:0] \dut.i_lines.used_q ;
  (* hierconn *) wire [23:0] \dut.i_lines.entries_q ;
  (* hierconn *) wire [1:0] \out.kind_q ;
  (* hierconn *) wire [2:0] \out.col_q ;
  (* hierconn *) wire [7:0] \out.age_q ;
  // An announcement: {tag, whole, first, last, fault}.
  logic [RingBits:0] pixels;
  logic row_begins, row_real, newest_last, newest_tag, any_first, row_ends, end_waits;
  logic [RingBits:0] since_first;
  logic [1:0] ends_popped, fault_out, next_fault, done;
  logic faults_ok, tags_ok;
  logic [7:0] begun;  // ages with the slot begun
  logic [2:0] row_col, own_width, slot_width;
  always_comb begin
    pixels = '0;
    newest_last = \dut.ended_q ;
    newest_tag = \dut.second_width_q ;
    any_first = 1'b0;
    since_first = '0;
    tags_ok = 1'b1;
    ends_popped = fault_in_q;
    for (int i = 0; i < 4; i++) begin
      if (\dut.i_lines.used_q [i]) begin
        if (\dut.i_lines.entries_q [6*i+4]) begin
          pixels = pixels + 6'(\dut.i_lines.entries_q [6*i+5] ? width_q[5:3] : width_q[2:0]);
          if (\dut.i_lines.entries_q [6*i+3]) since_first = '0;
          since_first = since_first + 6'(\dut.i_lines.entries_q [6*i+5] ? width_q[5:3] : width_q[2:0]);
          any_first = any_first || \dut.i_lines.entries_q [6*i+3];
          tags_ok = tags_ok && (\dut.i_lines.entries_q [6*i+5] == newest_tag ||
                                \dut.i_lines.entries_q [6*i+3]);
          newest_tag = \dut.i_lines.entries_q [6*i+5];
          tags_ok = tags_ok && (newest_tag ? width_q[5:3] : width_q[2:0]) >= 3'd5;
        end
        newest_last = \dut.i_lines.entries_q [6*i+2];
        ends_popped = ends_popped - 2'(newest_last);
      end
    end
    next_fault = ends_popped;
    faults_ok = 1'b1;
    for (int i = 0; i < 4; i++) begin
      if (\dut.i_lines.used_q [i]) begin
        faults_ok = faults_ok && \dut.i_lines.entries_q [6*i+:2] == next_fault;
        next_fault = next_fault + 2'(\dut.i_lines.entries_q [6*i+2]);
      end
    end
  end
  assign row_begins = \dut.busy_q && \dut.sol_q ;  // begun, no beat sent
  assign row_col = valid && out_col != 3'd7 ? out_col + 3'd1 : \out.col_q ;
  assign to_go = valid ? 2'd0 : \dut.busy_q ? 2'd1 : \dut.head_valid && !\dut.head_whole ? 2'd3 : 2'd2;
  assign own_width = \dut.second_width_q ? width_q[5:3] : width_q[2:0];
  assign slot_width = \dut.second_slot_q ? width_q[5:3] : width_q[2:0];
  always_comb begin
    for (int t = 0; t < 2; t++) begin
      begun[4*t+:4] = !row_begins ? age[4*t+:4]
                      : \dut.real_q && \dut.second_width_q == 1'(t) ? 4'd0
                      : age[4*t+:4] == Most ? Most : age[4*t+:4] + 4'd1;
      done[t] = row_col >= width_q[3*t+:3] || far[t] || (age[4*t+:4] == 4'd11 && row_col >= 3'd3);
    end
  end
  wire [3:0] own_age = \dut.second_width_q ? begun[7:4] : begun[3:0];
  wire [3:0] other_age = \dut.second_width_q ? begun[3:0] : begun[7:4];
  wire [6:0] own_beats = \dut.second_width_q ? beats_q[13:7] : beats_q[6:0];
  wire [6:0] far_beats = \dut.second_width_q ? beats_q[6:0] : beats_q[13:7];
  wire own_far = \dut.second_width_q ? far[1] : far[0];
  wire other_far = \dut.second_width_q ? far[0] : far[1];
  assign row_ends = row_begins && row_real && (!\dut.real_q || \dut.sof_q );
  assign end_waits = \dut.ended_q && (row_begins ? \dut.real_q : row_real);
  assign fault_out = fault_out_q + 2'(end_here);
  assign row_real = valid && sol ? is_real || sof : real_q;
  always_ff @(posedge clk_i) begin
    slot_started_q <= rst_ni && (\dut.start_line || \dut.start_void );
    if (started_q && rst_ni) begin
      // Rows and beats behind the last row of each width, the ones begun included.
      assert (\dut.i_left.rows_q == own_age || (\dut.i_left.rows_q == 4'd15 && own_age == Most));
      assert (own_age == Most ? \dut.i_left.beats_q == own_beats + 7'(valid && own_far && !(&own_beats[6:5]))
                              : \dut.i_left.beats_q == '0);
      assert (\dut.i_other_left.rows_q <= other_age ||
              (\dut.i_other_left.rows_q == 4'd15 && other_age == Most));
      assert (\dut.i_other_left.beats_q == '0 || &\dut.i_other_left.rows_q [3:2]);
      assert (other_age == Most ? \dut.i_other_left.beats_q <= far_beats +
                                  7'(valid && other_far && !(&far_beats[6:5]))
                                : \dut.i_other_left.beats_q == '0);
      assert (\dut.i_other_left.rows_q >= \dut.i_left.rows_q && other_age >= own_age);
      assert (\dut.i_other_left.beats_q >= \dut.i_left.beats_q );
      for (int t = 0; t < 2; t++) begin
        assert (far[t] || beats_q[7*t+:7] == '0 || (valid && sol));
        assert (\out.age_q [4*t+:4] <= Most);
      end
      assert (!drained || (!\dut.busy_q && !\dut.i_lines.used_q [0] && \dut.ended_q ));
      assert (!free || (!\dut.i_lines.used_q [0] && \dut.other_left &&
                        (!\dut.busy_q || \dut.second_slot_q == \dut.second_width_q )));
      assert (&\out.age_q || \out.col_q != '0 || \out.age_q == {2{Most}});
      assert (real_q == (\out.kind_q != 2'd0) && \out.kind_q != 2'd3);
      assert (\out.kind_q == {real_q && \out.age_q [7:4] == '0, real_q && \out.age_q [3:0] == '0});
      assert (row_col <= 3'd6);
      // The row that is sent, and its slot.
      for (int t = 0; t < 2; t++) begin
        assert (width_q[3*t+:3] == 3'd2 || width_q[3*t+:3] == 3'd5 || width_q[3*t+:3] == 3'd6);
        assert (width_q[3*t+:3] != 3'd2 || begun[4*t+:4] == Most);
      end
      assert (own_width != 3'd2 || (!\dut.busy_q && own_age == Most && (&\dut.i_left.beats_q [6:5])));
      if (\dut.busy_q ) begin
        assert (\dut.col_q == (row_begins ? 3'd0 : row_col));
        assert (\dut.last_q == (\dut.col_q == slot_width - 3'd1));
        assert (\dut.row_last_q == (\dut.col_q == own_width - 3'd1));
        assert (\dut.in_row_q == (\dut.col_q < own_width));
        assert (\dut.col_q < slot_width && slot_width >= own_width);
        assert (slot_started_q ? \dut.col_q == '0
                               : \dut.slot_limit_q == slot_width - 3'd2 && \dut.row_limit_q == own_width - 3'd2);
        assert (\dut.i_other_left.rows_q [3:2] == 2'b11 || slot_width >= 3'(width_q[2:0]));
        assert (\dut.i_other_left.rows_q [3:2] == 2'b11 || slot_width >= 3'(width_q[5:3]));
        if (other_age < Most) assert (slot_width >= width_q[2:0] && slot_width >= width_q[5:3]);
      end
      else assert (&done);
      if (row_begins) assert (&done);
      if (!row_begins && (\dut.busy_q || row_real)) assert (row_real == \dut.real_q );
      if (!row_begins && row_real) assert (kind == (2'd1 << \dut.second_width_q ));
      assert (!(row_begins && \dut.real_q && !\dut.sof_q ) ||
              (row_real && kind == (2'd1 << \dut.second_width_q )));
      assert (\dut.ended_q || (\dut.real_q && (row_begins || row_real)));
      assert (!\dut.busy_q || !\dut.sof_q || \dut.real_q );
      // Ends on their way to the output.
      assert (ends_popped == fault_out + 2'(row_ends) + 2'(end_waits));
      assert (faults_ok);
      assert (!row_ends || \dut.slot_fault_q == fault_out);
      assert (!end_waits || \dut.fault_q == ends_popped - 2'd1);
      // Clocks to the next beat: an end without a line, the row's begin, the beat.
      assert (3'(waits_q) + 3'(to_go) <= 3'd3);
      // The announcements: one may come in the clock after line_ready has fallen.
      assert (!\dut.i_lines.used_q [3] || !line_ready_q);
      assert (open_q == !newest_last && tags_ok);
      assert (fresh_q ? !open_q && !\dut.i_lines.used_q [0] && tag_q != \dut.second_width_q
                      : newest_tag == tag_q);
      for (int i = 0; i < 4; i++) begin
        if (\dut.i_lines.used_q [i]) begin
          assert (\dut.i_lines.entries_q [6*i+3] ==
                  (i == 0 ? \dut.ended_q : \dut.i_lines.entries_q [6*(i==0?0:i-1)+2]));
          assert (\dut.i_lines.entries_q [6*i+4] ||
                  (\dut.i_lines.entries_q [6*i+2] && !\dut.i_lines.entries_q [6*i+3]));
        end
        if (i > 0) assert (!\dut.i_lines.used_q [i] || \dut.i_lines.used_q [i-1]);
      end
      // The ring: read stands where the lines that wait begin, frame_q where the last frame among them does.
      assert (!any_first || announced_q - frame_q == since_first);
      assert (announced_q - read_q == pixels +
              (\dut.busy_q && \dut.real_q && \dut.col_q < own_width ? 6'(own_width - \dut.col_q ) : 6'd0));
    end
  end
endmodule
