// SPDX-License-Identifier: Apache-2.0
//
// frame_guard for any input stream: the lines it announces make frames of one width and at most
// MaxHeightPx rows, each line is one whole input line, in order, at the place in the ring where its
// reader looks, and nothing that waits there is overwritten. It never blocks a patient reader's
// input. With a good stream nothing is lost or reported.
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
    input logic        drained
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
    if (Good && rst_ni) begin
      assume (width == 3'd5 || width == 3'd6);
      assume (enable && flush_timeout == 20'd16 && pause_q != 3'd7);
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

  // Lines announced and not yet read: from read_q to base_q.
  logic write_valid, line_valid, line_whole, line_first, line_last;
  logic switch_wanted, load_settings, idle;
  logic [RingBits-1:0] write_address, offset;
  logic [RingBits:0] base_q, read_q, waiting;
  logic [7:0] write_data, events;
  logic [1:0] line_fault;
  logic [2:0] last_col;
  assign waiting = base_q - read_q;
  assign offset  = write_address - base_q[RingBits-1:0];

  frame_guard #(
      .MaxWidthPx (MaxWidthPx),
      .MaxHeightPx(MaxHeightPx),
      .RingBits   (RingBits)
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
      .write_valid_o(write_valid),
      .write_address_o(write_address),
      .write_data_o(write_data),
      .read_i(read_q),
      .line_valid_o(line_valid),
      .line_ready_i(line_ready),
      .line_whole_o(line_whole),
      .line_first_o(line_first),
      .line_last_o(line_last),
      .line_fault_o(line_fault),
      .last_col_o(last_col),
      .settings_changed_i(settings_changed),
      .switch_o(switch_wanted),
      .drained_i(drained),
      .load_settings_o(load_settings),
      .idle_o(idle),
      .event_o(events)
  );

  // The pixel of the watched column, as the ring holds it.
  logic [7:0] watched_q, watched;
  assign watched = write_valid && offset == 5'(watched_col) ? write_data : watched_q;

  logic open_q, frame_parity_q, was_reset_q, drained_q;
  logic [2:0] last_col_q;
  logic [2:0] rows_q, stall_q, frame_last_col_q, rows;
  assign rows = (line_first ? 3'd0 : rows_q) + 3'(line_whole);
  always_ff @(posedge clk_i) begin
    assume (watched_col <= 3'd5);
    assume (!drained || !open_q);  // row_slots: an open frame is in flight
    was_reset_q <= !rst_ni;
    drained_q <= drained;
    last_col_q <= last_col;
    watched_q <= watched;
    if (!rst_ni) begin
      {base_q, read_q, stall_q} <= '0;
      open_q <= 1'b0;
    end else begin
      if (read_step && waiting != '0) read_q <= read_q + 6'd1;
      if (line_valid && line_whole) base_q <= base_q + 6'(last_col) + 6'd1;
      if (line_valid) open_q <= !line_last;
      stall_q <= tvalid && !tready && line_ready && drained && waiting == '0 ? stall_q + 3'd1
                                                                             : '0;
    end
    if (line_valid) begin
      rows_q <= rows;
      frame_parity_q <= watched[7];
      frame_last_col_q <= last_col;
    end

    if (started_q && rst_ni) begin
      // Ring: what waits is not overwritten.
      if (Shape) assert (!write_valid || waiting + 6'(offset) < 6'd32);
      if (Shape) assert (stall_q < 3'd6);
      // Width and settings change only when nothing is in flight, settings before a first pixel.
      if (Shape && !was_reset_q) assert (last_col == last_col_q || drained_q);
      if (Shape) assert (!load_settings || (drained && settings_changed && !open_q && tuser && tvalid));
      if (Shape && line_valid) begin
        // Frames: begin with a first line, end once, all rows of one width.
        assert (line_ready);
        assert (line_first == !open_q && (line_whole || line_last));
        assert (open_q || line_whole);
        assert (rows <= 3'(MaxHeightPx));
        assert (line_first || last_col == frame_last_col_q);
        assert (!line_last || line_fault != 2'd0 || rows >= 3'd5);
        assert (!line_last || line_fault != 2'd0 || height_q == '0 ||
                rows == height_q);
      end
      // A whole line is one line of the input, the frame's next.
      if (Order && line_valid && line_whole) begin
        assert (last_col == 3'd4 || last_col == 3'd5);
        if (watched_col <= last_col) begin
          assert (watched[2:0] == watched_col);
          assert (watched[5:3] == rows - 3'd1);
          assert (watched[6] == (watched_col == last_col));
          assert (line_first || watched[7] == frame_parity_q);
        end
      end
      // Of a good stream nothing is lost: only the unfinished line is not announced.
      if (Good) begin
        assert (events == '0);
        assert (!line_valid || !line_last || line_fault == 2'd0);
        assert (accepted_q - base_q == 6'(next_col_q));
      end
    end
  end

  // What holds inside, so that a proof needs less search: how the guard's state follows from the
  // place in the stream.
  (* hierconn *) wire \dut.active_q ;
  (* hierconn *) wire \dut.begun_q ;
  (* hierconn *) wire \dut.switched_q ;
  (* hierconn *) wire \dut.ring_full_q ;
  (* hierconn *) wire \dut.col_is_width_q ;
  (* hierconn *) wire \dut.col_is_max_q ;
  (* hierconn *) wire \dut.wide_enough_q ;
  (* hierconn *) wire \dut.rows_is_max_q ;
  (* hierconn *) wire \dut.rows_is_height_m1_q ;
  (* hierconn *) wire [2:0] \dut.col_q ;
  (* hierconn *) wire [2:0] \dut.last_col_m1_q ;
  (* hierconn *) wire [11:0] \dut.rows_q ;
  (* hierconn *) wire [11:0] \dut.height_q ;
  (* hierconn *) wire [RingBits:0] \dut.write_q ;
  (* hierconn *) wire [RingBits:0] \dut.commit_q ;
  (* hierconn *) wire [19:0] \dut.idle_clocks_q ;
  (* hierconn *) wire \dut.idle_timeout_q ;
  wire active = \dut.active_q ;
  wire begun = \dut.begun_q ;
  wire [2:0] guard_col = \dut.col_q ;
  wire [11:0] guard_rows = \dut.rows_q ;
  wire [RingBits:0] fill = \dut.write_q - read_q;

  logic start_pending_q;
  always_ff @(posedge clk_i) begin
    start_pending_q <= rst_ni && tvalid && tuser && !tready;
    if (started_q && rst_ni) begin
      assert (\dut.commit_q == base_q);
      assert (\dut.write_q - base_q <= 6'd6);
      assert (fill <= 6'd30 && (\dut.ring_full_q || fill <= 6'd29) && waiting <= fill);
      assert (open_q == (active && begun));
      assert (was_reset_q || \dut.switched_q || \dut.last_col_m1_q == last_col - 3'd1);
      if (active) begin
        assert (\dut.write_q - base_q == 6'(guard_col) && guard_col <= 3'd5);
        assert (next_col_q == guard_col && next_row_q == (begun ? guard_rows[2:0] : 3'd0));
        assert (begun || \dut.wide_enough_q == (guard_col > 3'd3));
        assert (\dut.col_is_max_q == (guard_col == 3'd5));
        assert (\dut.switched_q && !start_pending_q ? guard_col == last_col && !begun && guard_col > 3'd3
                                : \dut.col_is_width_q == (guard_col != '0 && guard_col == last_col));
        assert (\dut.height_q == 12'(height_q));
        assert (start_pending_q || watched_col >= guard_col ||
                watched_q == {parity_q, 1'b0, next_row_q, watched_col});
      end
      if (active && begun) begin
        assert (guard_rows == 12'(rows_q) && rows_q != '0 && rows_q <= 3'd6);
        assert (frame_last_col_q == last_col);
        assert (watched_col > last_col || frame_parity_q == parity_q);
        assert (last_col == 3'd4 || last_col == 3'd5);
        assert (guard_col <= last_col);
        assert (guard_col == '0 || (\dut.rows_is_max_q == (rows_q == 3'd6) &&
                \dut.rows_is_height_m1_q == (height_q != '0 &&
                                             rows_q == height_q - 3'd1)));
        assert (height_q < 3'd2 || rows_q < height_q);
      end
      if (Good) begin
        assert (20'(pause_q) >= \dut.idle_clocks_q && (was_reset_q || !\dut.idle_timeout_q ));
        assert (!open_q || last_col == width - 3'd1);
        assert (active || next_col_q == '0);
        assert (active || start_pending_q || next_row_q == 3'd7 || (height_q != '0 &&
                                                 next_row_q == height_q));
        assert (!active || begun || (next_col_q != '0 && next_col_q < width));
      end
    end
  end
endmodule
