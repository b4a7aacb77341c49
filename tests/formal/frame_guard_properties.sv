// SPDX-License-Identifier: Apache-2.0
//
// frame_guard for any input stream: the lines it announces make frames of one width and at most
// MaxHeightPx rows, each line is one whole input line, in order, at the place in the ring where its
// reader looks, and nothing that waits there is overwritten. It never blocks a patient reader's
// input, nor forgets a time-out. With a good stream nothing is lost or reported.
//
// Each input pixel is marked with its place in the stream; the design only moves pixels, so the
// marks say whether they are moved right.
module frame_guard_properties #(
    parameter bit Shape = 1'b1,  // which of the properties
    parameter bit Order = 1'b1,
    parameter bit Good  = 1'b1   // only good streams
) (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        tvalid,
    input logic        tuser,
    input logic        tlast,
    input logic        enable,
    input logic        hold,
    input logic [ 2:0] frame_height,
    input logic [19:0] flush_timeout,
    input logic        line_ready,
    input logic        read_step,
    input logic        settings_changed,
    input logic        drained,
    input logic        width_free,
    input logic        unread
);
  localparam int MaxWidthPx = 6;
  localparam int MaxHeightPx = 6;
  localparam int RingBits = 5;

  (* anyconst *) logic [ 2:0] width;
  (* anyconst *) logic [ 2:0] watched_col;

  logic started_q = 1'b0;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
  end

  // The frame's height: what FRAME_HEIGHT holds when its first pixel is taken.
  logic tready;
  logic [2:0] height_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || (tvalid && tready && tuser && !hold)) height_q <= frame_height;
  end

  // Marks: column and row in the frame (7: far out), last column, parity of the frame.
  logic parity_q, parity;
  logic [2:0] next_col_q, next_row_q, col, row;
  logic [RingBits:0] accepted_q;
  assign col = tuser ? 3'd0 : next_col_q;
  assign row = tuser ? 3'd0 : next_row_q;
  assign parity = parity_q ^ tuser;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {next_row_q, parity_q, accepted_q} <= {3'd7, 7'd0};
      next_col_q <= '0;
    end else if (tvalid && tready) begin
      parity_q   <= parity;
      accepted_q <= accepted_q + 6'd1;
      next_col_q <= tlast ? 3'd0 : col == 3'd7 ? 3'd7 : col + 3'd1;
      next_row_q <= tlast && row != 3'd7 ? row + 3'd1 : row;
    end
  end

  // A good stream: lines of `width`, frames of as many rows as FRAME_HEIGHT says or, where that
  // is 0, of 5 or more until the next start of frame, without long pauses.
  logic [2:0] pause_q;
  always_ff @(posedge clk_i) begin
    pause_q <= rst_ni && !tvalid ? pause_q + 3'd1 : '0;
    if (Good) assume (frame_height == 3'd0 || frame_height == 3'd5 || frame_height == 3'd6);
    if (Good) assume (flush_timeout == 20'd16);
    if (Good && rst_ni) begin
      assume (width == 3'd5 || width == 3'd6);
      assume (enable && pause_q != 3'd7);
      if (tvalid) begin
        assume (tlast == (col == width - 3'd1));
        if (height_q != '0) begin
          assume (tuser == (next_col_q == '0 && (next_row_q == height_q ||
                                                 next_row_q == 3'd7)));
        end else begin
          assume (tuser ? next_col_q == '0 && next_row_q >= 3'd5
                        : next_row_q < 3'd6);
        end
      end
    end
  end

  // Lines announced and not yet read: from read_q to base_q. The ring's reader is a counter here.
  logic pixel_valid, pixel_first, pixel_step, pixel_commit, pixel_begins, ring_ready;
  logic line_valid, line_whole, line_first, line_last, switch_wanted, load_settings, idle;
  logic [RingBits:0] base_q, read_q, waiting;
  logic [7:0] pixel, events;
  logic [1:0] line_fault;
  logic [5:0] before_last;
  logic [2:0] last_col;
  logic line_tag;
  assign waiting = base_q - read_q;
  assign last_col = (line_tag ? before_last[5:3] : before_last[2:0]) + 3'd1;

  frame_guard #(
      .MaxWidthPx (MaxWidthPx),
      .MaxHeightPx(MaxHeightPx)
  ) dut (
      .clk_i,
      .rst_ni,
      .s_axis_tvalid_i(tvalid),
      .s_axis_tready_o(tready),
      .s_axis_tdata_i({parity, tlast, row, col}),
      .s_axis_tuser_i(tuser),
      .s_axis_tlast_i(tlast),
      .enable_i(enable),
      .hold_i(hold),
      .frame_height_i({9'd0, frame_height}),
      .flush_timeout_i(flush_timeout),
      .pixel_valid_o(pixel_valid),
      .pixel_o(pixel),
      .pixel_first_o(pixel_first),
      .pixel_step_o(pixel_step),
      .pixel_commit_o(pixel_commit),
      .pixel_begins_o(pixel_begins),
      .ring_ready_i(ring_ready),
      .line_valid_o(line_valid),
      .line_ready_i(line_ready),
      .line_whole_o(line_whole),
      .line_first_o(line_first),
      .line_last_o(line_last),
      .line_fault_o(line_fault),
      .line_tag_o(line_tag),
      .before_last_o(before_last),
      .width_free_i(width_free),
      .settings_changed_i(settings_changed),
      .switch_o(switch_wanted),
      .drained_i(drained),
      .load_settings_o(load_settings),
      .idle_o(idle),
      .event_o(events)
  );
  pixel_ring #(
      .MaxWidthPx (MaxWidthPx),
      .AddressBits(RingBits)
  ) ring (
      .clk_i,
      .rst_ni,
      .pixel_valid_i(pixel_valid),
      .pixel_i(pixel),
      .first_i(pixel_first),
      .step_i(pixel_step),
      .commit_i(pixel_commit),
      .begins_i(pixel_begins),
      .ready_o(ring_ready),
      .read_i(read_step && waiting != '0),
      .restart_i(1'b0),
      .unread_i(unread),
      .data_o()
  );
  (* hierconn *) wire [RingBits:0] \ring.write_q ;
  (* hierconn *) wire [RingBits:0] \ring.commit_q ;
  (* hierconn *) wire [RingBits:0] \ring.frame_q ;
  (* hierconn *) wire [RingBits:0] \ring.read_q ;
  (* hierconn *) wire [RingBits:0] \ring.here ;
  (* hierconn *) wire \ring.nearly_full ;

  // The pixel of the watched column, as the ring holds it: of the line that comes in, and of the one
  // committed last.
  logic [RingBits:0] offset;
  logic [7:0] watched_q, watched, line_watched_q;
  assign offset  = \ring.here - \ring.commit_q ;
  assign watched = pixel_valid && offset == 6'(watched_col) ? pixel : watched_q;

  logic open_q, frame_parity_q, was_reset_q, width_free_q, line_tag_q, line_ready_q;
  logic [5:0] before_last_q;
  logic [2:0] height1_q;
  logic [2:0] rows_q, stall_q, frame_last_col_q, rows;
  logic [RingBits:0] frame_start_q, waiting_q;
  assign rows = (line_first ? 3'd0 : rows_q) + 3'(line_whole);
  always_ff @(posedge clk_i) begin
    assume (watched_col <= 3'd5);
    assume (!drained || !open_q);        // row_slots: an open frame is in flight
    assume (!width_free || line_ready);  // and nothing is announced
    assume (unread || waiting_q == '0);
    waiting_q <= rst_ni ? waiting : '0;
    was_reset_q <= !rst_ni;
    width_free_q <= width_free;
    line_tag_q <= line_tag;
    before_last_q <= before_last;
    line_ready_q <= line_ready;
    height1_q <= height_q;
    watched_q <= watched;
    if (pixel_commit) line_watched_q <= watched;
    if (!rst_ni) begin
      {base_q, read_q, stall_q, frame_start_q} <= '0;
      open_q <= 1'b0;
    end else begin
      if (read_step && waiting != '0) read_q <= read_q + 6'd1;
      if (line_valid && line_whole) begin
        base_q <= base_q + 6'(last_col) + 6'd1;
        if (line_first) frame_start_q <= base_q;
      end
      if (line_valid) open_q <= !line_last;
      stall_q <= tvalid && !tready && line_ready && drained && width_free && waiting == '0 ? stall_q + 3'd1
                                                                             : '0;
    end
    if (line_valid) begin
      rows_q <= rows;
      frame_parity_q <= line_watched_q[7];
      frame_last_col_q <= last_col;
    end

    if (started_q && rst_ni) begin
      // Ring: what waits is not overwritten, and where the frame announced last begins is known.
      if (Shape) assert (!pixel_valid || waiting + (\ring.here - base_q) < 6'd32);
      if (Shape) assert (\ring.frame_q == frame_start_q || switch_wanted || (line_valid && line_first) || width_free);
      if (Shape) assert (!line_valid || !line_first || \ring.frame_q == base_q);
      if (Shape) assert (stall_q < 3'd6);
      // A width takes the place of one that is free; settings change only when nothing is in flight,
      // before a first pixel.
      if (Shape && !was_reset_q && line_tag == line_tag_q) assert (before_last == before_last_q);
      if (Shape && !was_reset_q && line_tag != line_tag_q) begin
        assert (width_free_q && (line_tag ? before_last[2:0] == before_last_q[2:0]
                                          : before_last[5:3] == before_last_q[5:3]));
      end
      if (Shape) assert (!load_settings || (drained && !open_q && tuser && tvalid));
      if (Shape) assert (!switch_wanted || !open_q || (line_valid && line_last));
      if (Shape && line_valid) begin
        // Frames: begin with a first line, end once, all rows of one width.
        assert (line_ready_q);
        assert (line_first == !open_q && (line_whole || line_last));
        assert (open_q || line_whole);
        assert (rows <= 3'(MaxHeightPx));
        assert (line_first || last_col == frame_last_col_q);
        assert (!line_last || line_fault != 2'd0 || rows >= 3'd5);
        assert (!line_last || line_fault != 2'd0 || height1_q == '0 ||
                rows == height1_q);
      end
      // A whole line is one line of the input, the frame's next.
      if (Order && line_valid && line_whole) begin
        assert (last_col == 3'd4 || last_col == 3'd5);
        if (watched_col <= last_col) begin
          assert (line_watched_q[2:0] == watched_col && line_watched_q[5:3] == rows - 3'd1);
          assert (line_first || line_watched_q[7] == frame_parity_q);
          assert (line_watched_q[6] == (watched_col == last_col));
        end
      end
      // Of a good stream nothing is lost: only the unfinished line is not committed.
      if (Good) begin
        // The skid buffer, which is left out, shows no pixel in reset.
        assert (was_reset_q || events == '0);
        assert (!line_valid || !line_last || line_fault == 2'd0);
        assert (accepted_q - \ring.commit_q == 6'(next_col_q));
      end
    end
  end

  // What holds inside, so that a proof needs less search: how the guard's state follows from the
  // place in the stream.
  (* hierconn *) wire \dut.active_q ;
  (* hierconn *) wire \dut.begun_q ;
  (* hierconn *) wire \dut.width_wait_q ;
  (* hierconn *) wire \dut.settings_wait_q ;
  (* hierconn *) wire \dut.settings_loaded_q ;
  (* hierconn *) wire \dut.announce_q ;
  (* hierconn *) wire \dut.late_q , \dut.held_q ;
  (* hierconn *) wire [10:0] \dut.i_idle.left_low_q , \dut.i_idle.left_high_q ;
  (* hierconn *) wire \dut.i_checks.in_line_o ;
  (* hierconn *) wire \dut.i_checks.fits_o ;
  (* hierconn *) wire \dut.i_checks.must_end_o ;
  (* hierconn *) wire \dut.i_checks.same_width_o ;
  (* hierconn *) wire \dut.i_checks.last_row_o ;
  (* hierconn *) wire \dut.i_checks.over_max_o ;
  (* hierconn *) wire \dut.i_checks.height_known_o ;
  (* hierconn *) wire \dut.i_checks.five_q ;
  (* hierconn *) wire [2:0] \dut.i_checks.col_q , \dut.i_checks.limit_q ;
  (* hierconn *) wire [11:0] \dut.i_checks.line_q ;
  (* hierconn *) wire [11:0] \dut.i_checks.height_q ;
  wire active = \dut.active_q ;
  wire begun = \dut.begun_q ;
  wire waits = \dut.width_wait_q ;
  wire announced = \dut.announce_q ;
  wire in_line = \dut.i_checks.in_line_o ;
  wire over_max = \dut.i_checks.over_max_o ;
  wire [2:0] guard_col = in_line ? \dut.i_checks.col_q : 3'd0;
  wire [11:0] guard_line = \dut.i_checks.line_q ;
  wire [RingBits:0] fill = \ring.write_q - read_q;
  // With the announcement that is under way.
  wire [2:0] width_next = waits ? \dut.i_checks.col_q : last_col + 3'd1;
  wire [2:0] rows_next = announced ? rows : rows_q;

  // A time-out that has passed ends its frame before another pixel is taken, however long room,
  // width or settings let it wait.
  wire timed_out = \dut.i_idle.left_high_q [10];
  logic due_q;
  always_ff @(posedge clk_i) begin
    due_q <= rst_ni && active && (due_q || (timed_out && !tvalid && begun && !in_line &&
                                            !\dut.i_checks.height_known_o ));
    if (started_q && rst_ni && Shape) assert (!due_q || !active || !tvalid || !tready);
  end

  logic start_pending_q;
  always_ff @(posedge clk_i) begin
    start_pending_q <= rst_ni && tvalid && tuser && !tready;
    if (started_q && rst_ni) begin
      assert (!\dut.late_q || timed_out);
      assert (\dut.held_q == (\dut.late_q || waits));
      assert (!due_q || !active || (\dut.late_q && begun && !in_line && !\dut.i_checks.height_known_o ));
      assert (was_reset_q || line_tag != line_tag_q || \dut.i_checks.limit_q == last_col - 3'd1);
      assert (\ring.read_q == read_q && \dut.i_checks.height_q == 12'(height_q));
      assert (\ring.frame_q == (announced && line_first ? base_q : frame_start_q));
      if (announced && line_whole && watched_col < width_next) begin
        assert (line_watched_q[6:0] == {watched_col == width_next - 3'd1, rows - 3'd1, watched_col});
      end
      assert (\ring.commit_q == base_q + (announced && line_whole ? 6'(width_next) : 6'd0));
      assert (\ring.write_q - \ring.commit_q <= 6'd6);
      assert (fill <= 6'd26 && (!ring_ready || fill <= 6'd25) && waiting <= fill);
      assert (\ring.nearly_full ? fill >= 6'd16 : fill <= 6'd24);
      assert (waiting <= waiting_q + 6'd6 && waiting_q <= waiting + 6'd1);
      assert (stall_q == '0 || (!waits && ring_ready));
      assert (stall_q <= (\dut.settings_loaded_q ? 3'd4 : \dut.settings_wait_q ? 3'd3 :
                          \dut.late_q ? 3'd1 : 3'd2));
      assert ((announced ? !line_last : open_q) == (active && begun));
      assert (!announced || (line_first == !open_q && (line_whole || (line_last && open_q)) &&
                             !(line_first && line_last)));
      assert (!waits || (announced && line_whole && line_first && active && begun && !in_line &&
                         (width_next == 3'd5 || width_next == 3'd6)));
      if (active) begin
        assert (\ring.write_q - \ring.commit_q == 6'(guard_col) && guard_col <= 3'd5);
        assert (next_col_q == guard_col && next_row_q == (begun ? guard_line[2:0] - 3'd1 : 3'd0));
        assert ((begun || guard_line == 12'd1) && in_line == (guard_col != '0));
        assert (\dut.i_checks.same_width_o == (guard_col > 3'd1 && guard_col == last_col));
        assert (\dut.i_checks.must_end_o == (begun ? guard_col > 3'd1 && guard_col == last_col
                                                   : guard_col == 3'd5));
        assert (\dut.i_checks.fits_o == (begun ? guard_col == last_col && !over_max && guard_col > 3'd1
                                               : guard_col > 3'd3));
        assert (guard_col == '0 || start_pending_q || watched_col >= guard_col ||
                watched_q == {parity_q, 1'b0, next_row_q, watched_col});
        if (begun || guard_col > 3'd1) assert (\dut.i_checks.height_known_o == (height_q != '0));
      end
      if (active && begun) begin
        assert (guard_line == 12'(rows_next) + 12'd1 && rows_next != '0 && rows_next <= 3'd6);
        assert (announced || frame_last_col_q == last_col);
        assert (waits || last_col == 3'd4 || last_col == 3'd5);
        assert (waits || guard_col <= last_col);
        assert (watched_col >= width_next || line_watched_q[7] == parity_q);
        assert ((announced && line_first) || watched_col > last_col || frame_parity_q == parity_q);
        assert (guard_col == '0 || (over_max == (guard_line == 12'd7) &&
                \dut.i_checks.last_row_o == (height_q != '0 && guard_line == 12'(height_q))));
        assert (height_q < 3'd2 || rows_next < height_q);
        assert (\dut.i_checks.five_q == (rows_next >= 3'd5));
      end
      if (Good) begin
        assert (!\dut.late_q );
        assert (\dut.i_idle.left_low_q == 11'd16 - 11'(pause_q) && \dut.i_idle.left_high_q == '0);
        assert (!open_q || last_col == width - 3'd1);
        assert (!active || !begun || (waits ? width_next == width : last_col == width - 3'd1));
        assert (height_q == 3'd0 || height_q == 3'd5 || height_q == 3'd6);
        assert (active || next_col_q == '0);
        assert (active || start_pending_q || next_row_q == 3'd7 || (height_q != '0 &&
                                                 next_row_q == height_q));
        assert (!active || begun || (next_col_q != '0 && next_col_q < width));
      end
    end
  end
endmodule
