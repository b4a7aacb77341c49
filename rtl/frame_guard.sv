// SPDX-License-Identifier: Apache-2.0
//
// Turns any AXI4-Stream video input into whole lines of well-formed frames.
//
// Pixels go into a ring of memory as they arrive; a line is committed (announced to row_slots)
// only when it is whole and as wide as its frame, otherwise it is forgotten. The first line sets
// the frame's width. A bad line ends its frame after the last whole line (the frame is cut) and
// everything up to the next start of frame is dropped. A frame ends at the next start of frame,
// after frame_height_i lines (if not 0), or after flush_timeout_i idle clocks (if it is 0).
//
//   s_axis_*         video: tuser start of frame, tlast end of line
//   enable_i         0: frames are dropped; sampled at a start of frame
//   frame_height_i   lines per frame, px; 0: not known; sampled at a start of frame unless hold_i
//   flush_timeout_i  idle clocks after a whole line that end a frame of unknown height
//   write_*_o        pixel ring; read_i is its reader's position (one bit more than an address)
//   line_*           announcements: line_whole_o a line (line_first_o of a frame), line_last_o
//                    the frame ends here, line_fault_o how: 0 clean, 1 bad line, 2 bad height,
//                    3 smaller than 5 rows
//   last_col_o       width - 1 of the frames announced from now on
//   switch_o         waits for drained_i (nothing in flight): a start of frame when
//                    settings_changed_i, the last pixel of a first line when the width is new
//   load_settings_o  a start of frame is let in now: the settings come into force
//   idle_o           nothing arrived for 16 clocks
//   event_o          one clock per event: see the bits below
//
// Latency 1 line; throughput 1 pixel per clock, also with 5 px lines.
module frame_guard #(
    parameter int MaxWidthPx  = 1920,
    parameter int MaxHeightPx = 1200,
    parameter int RingBits    = 11     // log2 of the pixel ring, at least MaxWidthPx + 16
) (
    input  logic                          clk_i,
    input  logic                          rst_ni,
    input  logic                          s_axis_tvalid_i,
    output logic                          s_axis_tready_o,
    input  logic [                   7:0] s_axis_tdata_i,
    input  logic                          s_axis_tuser_i,
    input  logic                          s_axis_tlast_i,
    input  logic                          enable_i,
    input  logic                          hold_i,
    input  logic [                  11:0] frame_height_i,
    input  logic [                  19:0] flush_timeout_i,
    output logic                          write_valid_o,
    output logic [          RingBits-1:0] write_address_o,
    output logic [                   7:0] write_data_o,
    input  logic [            RingBits:0] read_i,
    output logic                          line_valid_o,
    input  logic                          line_ready_i,
    output logic                          line_whole_o,
    output logic                          line_first_o,
    output logic                          line_last_o,
    output logic [                   1:0] line_fault_o,
    output logic [$clog2(MaxWidthPx)-1:0] last_col_o,
    input  logic                          settings_changed_i,
    output logic                          switch_o,
    input  logic                          drained_i,
    output logic                          load_settings_o,
    output logic                          idle_o,
    output logic [                   7:0] event_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080 || MaxHeightPx < 5 || MaxHeightPx > 4095 ||
      (1 << RingBits) < MaxWidthPx + 16) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080_MaxHeightPx_5_to_4095_RingBits_log2_of_MaxWidthPx_plus_16 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);
  localparam logic [1:0] Clean = 2'd0, BadLine = 2'd1, BadHeight = 2'd2, TooSmall = 2'd3;
  localparam int ShortLine = 0, LongLine = 1, TooWide = 2, TooNarrow = 3, TooTall = 4,
                 NoStart = 5, EarlyStart = 6, TooFewRows = 7;

  logic in_valid, in_ready, sof, eol;
  logic [7:0] pixel;
  skid_buffer #(
      .Width(10)
  ) i_input (
      .clk_i,
      .rst_ni,
      .s_tvalid_i(s_axis_tvalid_i),
      .s_tready_o(s_axis_tready_o),
      .s_tdata_i ({s_axis_tdata_i, s_axis_tuser_i, s_axis_tlast_i}),
      .m_tvalid_o(in_valid),
      .m_tready_i(in_ready),
      .m_tdata_o ({pixel, sof, eol})
  );

  // Between start of frame and the frame's end or first fault: active. Its first line committed:
  // begun. After a fault the rest of the frame is dropped without further notice: quiet.
  logic active_q, begun_q, quiet_q;
  logic [ColBits-1:0] col_q, last_col_q, last_col_m1_q;
  logic col_is_width_q, col_is_max_q;  // col_q + 1 is the frame's width, MaxWidthPx
  logic wide_enough_q;                 // col_q + 1 >= 5
  logic [11:0] rows_q, height_q;
  logic rows_is_height_m1_q, rows_is_max_q;
  logic [RingBits:0] write_q, commit_q;
  logic ring_full_q, switched_q;
  logic [19:0] idle_clocks_q;
  logic idle_timeout_q;

  logic take, row_end, whole, too_long, few_rows, too_small, commit, timeout, end_now;
  logic switch_needed, load, start_now;
  assign row_end = active_q && !sof;
  assign whole = row_end && eol && (begun_q ? col_is_width_q && !rows_is_max_q
                                            : wide_enough_q);
  assign too_long = row_end && !eol && (begun_q ? col_is_width_q : col_is_max_q);
  assign switch_needed = !switched_q && (sof ? settings_changed_i
                                             : whole && !begun_q && !col_is_width_q);
  assign few_rows = rows_q[11:3] == '0 && (rows_q[2:0] < 3'd5);
  assign too_small = few_rows && !(commit && rows_q[2:0] == 3'd4);
  assign in_ready = line_ready_i && !ring_full_q && !switch_needed;
  assign take = in_valid && in_ready;
  assign commit = take && whole;
  // A start of frame ends the frame before, also while it waits itself.
  assign start_now = in_valid && sof && line_ready_i && !ring_full_q;
  assign timeout = idle_timeout_q && !in_valid && line_ready_i && active_q && begun_q &&
                   col_q == '0 && height_q == '0;
  // The frame that has begun ends with this beat (or, by timeout, without one).
  assign end_now = timeout ||
                   (active_q && begun_q &&
                    (start_now || (take && (too_long || (eol && (!whole || rows_is_height_m1_q))))));

  assign line_valid_o = commit || end_now;
  assign line_whole_o = commit;
  assign line_first_o = !begun_q;
  assign line_last_o = end_now;
  always_comb begin
    if (take && !whole && (too_long || (eol && !sof))) begin
      line_fault_o = rows_is_max_q ? BadHeight : BadLine;
    end else if (start_now && col_q != '0) begin
      line_fault_o = BadLine;
    end else if (start_now && height_q != '0) begin
      line_fault_o = BadHeight;
    end else begin
      line_fault_o = too_small ? TooSmall : Clean;
    end
  end

  assign switch_o = in_valid && switch_needed;
  assign load = switch_o && drained_i && !ring_full_q;
  assign load_settings_o = load && sof;
  assign last_col_o = last_col_q;
  assign write_valid_o = in_valid;
  assign write_address_o = sof ? commit_q[RingBits-1:0] : write_q[RingBits-1:0];
  assign write_data_o = pixel;
  assign idle_o = |idle_clocks_q[19:4];

  always_ff @(posedge clk_i) begin
    if (take && (sof || row_end)) begin
      col_is_width_q <= !sof && !eol && col_q == last_col_m1_q;
      wide_enough_q  <= !sof && !eol && (|col_q[ColBits-1:2] || (&col_q[1:0]));
      col_is_max_q   <= !sof && !eol && col_q == ColBits'(MaxWidthPx - 2);
      col_q          <= sof ? ColBits'(1) : col_q + ColBits'(1);
    end
    last_col_m1_q       <= last_col_q - ColBits'(1);
    rows_is_height_m1_q <= height_q != '0 && rows_q == height_q - 12'd1;
    rows_is_max_q       <= rows_q == 12'(MaxHeightPx);
    idle_timeout_q      <= idle_clocks_q >= flush_timeout_i;
    if (load && !sof) last_col_q <= col_q;

    if (!rst_ni) begin
      {active_q, begun_q, quiet_q, switched_q, ring_full_q} <= '0;
      {write_q, commit_q, rows_q, idle_clocks_q} <= '0;
      last_col_q <= '0;
      height_q <= frame_height_i;
    end else begin
      if (take && sof && !hold_i) height_q <= frame_height_i;
      idle_clocks_q <= in_valid ? '0 : idle_clocks_q + 20'(!(&idle_clocks_q));
      ring_full_q <= (RingBits + 1)'(write_q - read_i) >= (RingBits + 1)'((1 << RingBits) - 3);
      switched_q <= load || (switched_q && !take);
      if (take && sof) begin
        write_q  <= commit_q + (RingBits + 1)'(1);
        active_q <= enable_i && !eol;
        begun_q  <= 1'b0;
        quiet_q  <= 1'b1;
        rows_q   <= '0;
      end else if (commit) begin
        {write_q, commit_q} <= {2{write_q + (RingBits + 1)'(1)}};
        col_q    <= '0;
        begun_q  <= 1'b1;
        rows_q   <= rows_q + 12'd1;
        active_q <= !end_now;
        quiet_q  <= !end_now;
      end else if (take && row_end) begin
        write_q  <= write_q + (RingBits + 1)'(1);
        active_q <= !(eol || too_long);
      end else if (take) begin
        quiet_q <= 1'b1;
      end else if (timeout || start_now) begin
        active_q <= 1'b0;
        quiet_q  <= 1'b0;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    event_o <= '0;
    if (rst_ni) begin
      event_o[ShortLine]  <= take && row_end && eol && begun_q && !col_is_width_q;
      event_o[LongLine]   <= take && too_long && begun_q;
      event_o[TooWide]    <= take && too_long && !begun_q;
      event_o[TooNarrow]  <= take && eol && (sof ? enable_i : active_q && !begun_q && !whole);
      event_o[TooTall]    <= take && row_end && eol && begun_q && col_is_width_q && rows_is_max_q;
      event_o[NoStart]    <= take && !sof && !active_q && !quiet_q;
      event_o[EarlyStart] <= start_now && active_q && (col_q != '0 || height_q != '0);
      event_o[TooFewRows] <= line_valid_o && line_last_o && line_fault_o == TooSmall;
    end
  end

  // Only whole lines are announced, and only lines of a frame that has a first one.
  always_ff @(posedge clk_i) begin
    if (rst_ni && line_valid_o) begin
      assert (line_ready_i);
      assert (!line_whole_o || col_q > ColBits'(3));
      assert (line_whole_o || !line_first_o);
    end
  end
endmodule
