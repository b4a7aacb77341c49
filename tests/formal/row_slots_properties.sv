// SPDX-License-Identifier: Apache-2.0
//
// row_slots for any announcements that frame_guard can make (its proved properties) and any back
// pressure: what leaves is a stream of row slots (slot_stream) in which each announced line is one
// row, in order, its pixels read from where they stand in the ring, and restart comes where it changes
// nothing; a frame's rows follow each
// other, and the row behind a frame carries its fault. Whoever can go on goes on: a patient
// consumer gets a beat in the fourth clock at the latest whenever a line waits or an ended frame is to be drained.
//
// drained: behind the last real row came 11 void rows and 96 beats of a twelfth or more; its frame has
// left the pipeline by then.
module row_slots_properties (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       line_valid,
    input logic       line_whole,
    input logic       line_last,
    input logic [2:0] new_width,
    input logic       go,
    input logic       idle,
    input logic       switch_wanted
);
  localparam int MaxWidthPx = 6;
  localparam int RingBits = 5;
  localparam int Lag = 10;

  logic started_q = 1'b0;
  logic line_ready, drained, valid, sol, sof, is_real, open_q, read, restart, unread;
  logic [1:0] fault, fault_in_q, fault_out_q;
  logic [2:0] width_q;
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
      .before_last_i(width_q - 3'd2),
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
      .fault_o(fault)
  );

  // frame_guard's part. Faults are marks: the frame's number. A width changes when nothing is in
  // flight and not with a line; frame_guard waits only behind a frame.
  logic [RingBits:0] announced_q, line_q, read_q;
  logic unread_q, line_ready_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
    assume (!line_valid || (rst_ni && line_ready_q && (line_whole || (line_last && open_q))));
    assume (!switch_wanted || !open_q || (line_valid && line_last));
    assume (new_width == 3'd5 || new_width == 3'd6);
    if (!rst_ni) begin
      {open_q, fault_in_q, announced_q, line_q, read_q} <= '0;
    end else begin
      if (line_valid) begin
        open_q <= !line_last;
        fault_in_q <= fault_in_q + 2'(line_last);
        announced_q <= announced_q + (line_whole ? 6'(width_q) : 6'd0);
        if (line_whole) line_q <= announced_q;
      end
      // pixel_ring's part.
      read_q <= restart ? line_q : read_q + 6'(read);
    end
    unread_q <= rst_ni && announced_q != read_q;
    line_ready_q <= rst_ni && line_ready;
    if (!rst_ni || (drained && !line_valid)) width_q <= new_width;
  end

  // The stages behind: the frames that ended, the beats behind eleven void rows.
  logic ok, real_q, end_here, far;
  logic [2:0] out_width, out_col;
  logic [6:0] beats_q;
  (* hierconn *) wire [3:0] \out.voids_q ;
  logic [3:0] row_voids;
  assign end_here = valid && sol && real_q && (!is_real || sof);
  assign row_voids = !(valid && sol) ? \out.voids_q : is_real ? 4'd0
                     : \out.voids_q == 4'd12 ? 4'd12 : \out.voids_q + 4'd1;
  assign far = row_voids == 4'd12;
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
      .width_o(out_width),
      .col_o(out_col)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {real_q, fault_out_q} <= '0;
      beats_q <= '1;
    end else if (valid) begin
      if (sol) real_q <= is_real;
      fault_out_q <= fault_out_q + 2'(end_here);
      beats_q <= !far ? 7'd0 : beats_q < 7'd96 ? beats_q + 7'd1 : beats_q;
    end
  end

  // Clocks without a beat although there is something to send and the consumer takes it.
  (* hierconn *) wire \dut.head_valid , \dut.head_whole , \dut.ended_q , \dut.left ;
  logic [1:0] waits_q, to_go;
  logic wanted;
  assign wanted = go && ((\dut.head_valid && \dut.head_whole ) ||
                         (\dut.ended_q && !\dut.left && (idle || switch_wanted)));
  always_ff @(posedge clk_i) begin
    waits_q <= rst_ni && wanted && !valid ? waits_q + 2'd1 : '0;
    if (started_q && rst_ni) begin
      assert (ok);
      assert (!end_here || fault == fault_out_q);
      assert (!drained || (!open_q && (beats_q >= 7'd96)));
      assert (!restart || line_q == read_q + 6'(read));
      assert (unread || !unread_q);
      assert (waits_q != 2'd3 || valid);
    end
  end

  // What holds inside, so that a proof needs less search.
  (* hierconn *) wire \dut.busy_q , \dut.real_q , \dut.sof_q , \dut.sol_q , \dut.last_q ;
  (* hierconn *) wire [2:0] \dut.col_q ;
  (* hierconn *) wire [3:0] \dut.voids_q ;
  (* hierconn *) wire [6:0] \dut.beats_q ;
  (* hierconn *) wire [1:0] \dut.fault_q , \dut.slot_fault_q ;
  (* hierconn *) wire [3:0] \dut.i_lines.used_q ;
  (* hierconn *) wire [19:0] \dut.i_lines.entries_q ;
  (* hierconn *) wire \out.real_q ;
  (* hierconn *) wire [2:0] \out.col_q , \out.width_q ;
  // An announcement: {whole, first, last, fault}.
  logic [2:0] whole_lines;
  logic row_begins, row_real, row_done, newest_last, row_ends, end_waits;
  logic [1:0] ends_popped, fault_out, next_fault;
  logic faults_ok;
  logic [3:0] begun_voids;
  logic [2:0] row_col;
  always_comb begin
    whole_lines = '0;
    newest_last = \dut.ended_q ;
    ends_popped = fault_in_q;
    for (int i = 0; i < 4; i++) begin
      if (\dut.i_lines.used_q [i]) begin
        whole_lines = whole_lines + 3'(\dut.i_lines.entries_q [5*i+4]);
        newest_last = \dut.i_lines.entries_q [5*i+2];
        ends_popped = ends_popped - 2'(newest_last);
      end
    end
    next_fault = ends_popped;
    faults_ok = 1'b1;
    for (int i = 0; i < 4; i++) begin
      if (\dut.i_lines.used_q [i]) begin
        faults_ok = faults_ok && \dut.i_lines.entries_q [5*i+:2] == next_fault;
        next_fault = next_fault + 2'(\dut.i_lines.entries_q [5*i+2]);
      end
    end
  end
  assign row_begins = \dut.busy_q && \dut.sol_q ;  // begun, no beat sent
  assign row_col = valid && out_col != 3'd7 ? out_col + 3'd1 : \out.col_q ;
  assign to_go = valid ? 2'd0 : \dut.busy_q ? 2'd1 : \dut.head_valid && !\dut.head_whole ? 2'd3 : 2'd2;
  assign begun_voids = !row_begins ? row_voids : \dut.real_q ? 4'd0
                       : row_voids == 4'd12 ? 4'd12 : row_voids + 4'd1;
  assign row_done = row_col == (valid ? out_width : \out.width_q ) || row_voids == 4'd12 ||
                    (row_voids == 4'd11 && row_col >= 3'd3);
  assign row_ends = row_begins && row_real && (!\dut.real_q || \dut.sof_q );
  assign end_waits = \dut.ended_q && (row_begins ? \dut.real_q : row_real);
  assign fault_out = fault_out_q + 2'(end_here);
  assign row_real = valid && sol ? is_real : real_q;
  logic was_reset_q;
  always_ff @(posedge clk_i) begin
    was_reset_q <= !rst_ni;
    if (started_q && rst_ni) begin
      // Void rows and beats so far, the ones begun included.
      assert (\dut.voids_q == begun_voids || (\dut.voids_q == 4'd15 && begun_voids == 4'd12));
      assert (begun_voids == 4'd12 ? \dut.beats_q == beats_q + 7'(valid && far && !(&beats_q[6:5]))
                                   : \dut.beats_q == '0);
      assert (far || beats_q == '0 || (valid && sol));
      assert (!drained || (!\dut.busy_q && !\dut.i_lines.used_q [0] && \dut.ended_q && !row_begins));
      assert (\out.voids_q == 4'd12 || \out.col_q != '0);
      assert (real_q == \out.real_q && real_q == (\out.voids_q == '0));
      assert (row_col <= 3'd6 && \out.voids_q <= 4'd12);
      // The row that is sent. A new width comes after at least eleven void rows.
      assert (width_q == 3'd5 || width_q == 3'd6);
      assert (\out.width_q == width_q || \out.voids_q == 4'd12 );
      if (\dut.busy_q ) begin
        assert (\dut.col_q == (row_begins ? 3'd0 : row_col));
        assert (\dut.last_q == (\dut.col_q == width_q - 3'd1));
        assert (\dut.col_q < width_q);
      end
      else assert (row_done);
      if (row_begins) assert (row_done);
      if (!row_begins && (\dut.busy_q || row_real)) assert (row_real == \dut.real_q );
      assert (!(row_begins && \dut.real_q && !\dut.sof_q ) || row_real);
      assert (\dut.ended_q || (\dut.real_q && (row_begins || row_real)));
      // Ends on their way to the output.
      assert (ends_popped == fault_out + 2'(row_ends) + 2'(end_waits));
      assert (faults_ok);
      assert (!row_ends || \dut.slot_fault_q == fault_out);
      assert (!end_waits || \dut.fault_q == ends_popped - 2'd1);
      // Clocks to the next beat: an end without a line, the row's begin, the beat.
      assert (3'(waits_q) + 3'(to_go) <= 3'd3);
      // The announcements: one may come in the clock after line_ready has fallen.
      assert (!\dut.i_lines.used_q [3] || !line_ready_q);
      assert (open_q == !newest_last);
      for (int i = 0; i < 4; i++) begin
        if (\dut.i_lines.used_q [i]) begin
          assert (\dut.i_lines.entries_q [5*i+3] ==
                  (i == 0 ? \dut.ended_q : \dut.i_lines.entries_q [5*(i==0?0:i-1)+2]));
          assert (\dut.i_lines.entries_q [5*i+4] ||
                  (\dut.i_lines.entries_q [5*i+2] && !\dut.i_lines.entries_q [5*i+3]));
        end
        if (i > 0) assert (!\dut.i_lines.used_q [i] || \dut.i_lines.used_q [i-1]);
      end
      // The ring: read stands where the lines that wait begin, line_q where the last one does.
      assert (whole_lines == '0 || announced_q - line_q == 6'(width_q));
      assert (announced_q - read_q == 6'(whole_lines) * 6'(width_q) +
              (\dut.busy_q && \dut.real_q ? 6'(width_q - \dut.col_q ) : 6'd0));
    end
  end
endmodule
