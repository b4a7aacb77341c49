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
//   pixel_*          to pixel_ring: its writer's ports
//   line_*           announcements: line_whole_o a line (line_first_o of a frame), line_last_o
//                    the frame ends here, line_fault_o how: 0 clean, 1 bad line, 2 bad height,
//                    3 smaller than 5 rows; line_ready_i: room for two more
//   before_last_o    the two widths - 2 that lines in flight may have, the first in the low bits;
//                    line_tag_o which of them the line announced has
//   switch_o         waits: before a start of frame when settings_changed_i for drained_i (nothing
//                    in flight), behind a first line of a new width for width_free_i (no line of
//                    the width that is not in force)
//   load_settings_o  a start of frame is let in next: the settings come into force
//   idle_o           nothing arrived for 16 clocks
//   event_o          one clock per event: see the bits below
//
// Latency 1 line + 1 clock; throughput 1 pixel per clock, also with 5 px lines.
module frame_guard #(
    parameter int MaxWidthPx  = 1920,  // longest line, 5 .. 4080 px
    parameter int MaxHeightPx = 1200   // most lines, 5 .. 4095
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            s_axis_tvalid_i,
    output logic                            s_axis_tready_o,
    input  logic [                     7:0] s_axis_tdata_i,
    input  logic                            s_axis_tuser_i,
    input  logic                            s_axis_tlast_i,
    input  logic                            enable_i,
    input  logic                            hold_i,
    input  logic [                    11:0] frame_height_i,
    input  logic [                    19:0] flush_timeout_i,
    output logic                            pixel_valid_o,
    output logic [                     7:0] pixel_o,
    output logic                            pixel_first_o,
    output logic                            pixel_step_o,
    output logic                            pixel_commit_o,
    output logic                            pixel_begins_o,
    input  logic                            ring_ready_i,
    output logic                            line_valid_o,
    input  logic                            line_ready_i,
    output logic                            line_whole_o,
    output logic                            line_first_o,
    output logic                            line_last_o,
    output logic [                     1:0] line_fault_o,
    output logic                            line_tag_o,
    output logic [2*$clog2(MaxWidthPx)-1:0] before_last_o,
    input  logic                            width_free_i,
    input  logic                            settings_changed_i,
    output logic                            switch_o,
    input  logic                            drained_i,
    output logic                            load_settings_o,
    output logic                            idle_o,
    output logic [                     7:0] event_o
);
  localparam int ShortLine = 0, LongLine = 1, TooWide = 2, TooNarrow = 3, TooTall = 4,
                 NoStart = 5, EarlyStart = 6, TooFewRows = 7;

  logic front_valid, in_valid, in_ready, sof, eol;
  skid_buffer #(
      .Width(10)
  ) i_input (
      .clk_i,
      .rst_ni,
      .s_tvalid_i(s_axis_tvalid_i),
      .s_tready_o(s_axis_tready_o),
      .s_tdata_i ({s_axis_tdata_i, s_axis_tuser_i, s_axis_tlast_i}),
      .m_tvalid_o(front_valid),
      .m_tready_i(in_ready),
      .m_tdata_o ({pixel_o, sof, eol})
  );

  // Between start of frame and the frame's end or first fault: active. Its first line committed:
  // begun. After a fault the rest of the frame is dropped without further notice: quiet.
  logic active_q, begun_q, quiet_q;
  // For what is in flight to leave wait a start of frame, until new settings are loaded, and a first
  // line, taken but not announced. A pixel that comes later than the time-out waits until its
  // frame has ended: late. held: width_wait or late.
  logic settings_wait_q, settings_loaded_q, width_wait_q, width_wait, late_q, late, held_q;
  logic go, settings_stop, take, arrival, start, step, whole, ends, commit, timed_out, end_now;
  logic in_line, fits, must_end, same_width, last_row, over_max, few_rows, fifth, height_known;
  line_checks #(
      .MaxWidthPx (MaxWidthPx),
      .MaxHeightPx(MaxHeightPx)
  ) i_checks (
      .clk_i,
      .rst_ni,
      .step_i(pixel_step_o),
      .sof_i(sof),
      .eol_i(eol),
      .commit_i(commit),
      .begun_i(begun_q),
      .load_width_i(width_wait_q && width_free_i),
      .hold_i,
      .frame_height_i,
      .in_line_o(in_line),
      .fits_o(fits),
      .must_end_o(must_end),
      .same_width_o(same_width),
      .before_last_o,
      .second_o(line_tag_o),
      .last_row_o(last_row),
      .over_max_o(over_max),
      .few_rows_o(few_rows),
      .fifth_o(fifth),
      .height_known_o(height_known)
  );

  assign go = ring_ready_i && line_ready_i && !width_wait_q;
  assign settings_stop = sof && settings_changed_i && !settings_loaded_q;
  assign in_valid = front_valid && !late_q;
  assign in_ready = ring_ready_i && line_ready_i && !held_q && !settings_stop;
  assign take = front_valid && in_ready;
  assign start = take && sof;
  assign arrival = in_valid && sof && go;  // ends the frame before, also while it waits itself
  assign step = take && !sof && active_q;
  // What the pixel in front does once there is room: it makes a line whole; the frame ends with it or, by
  // time-out, without one.
  assign whole = in_valid && !sof && active_q && eol && fits;
  assign ends = in_valid ? sof || (eol ? !fits || last_row : must_end)
                         : timed_out && begun_q && !in_line && !height_known;
  assign commit = go && whole;
  assign end_now = go && active_q && begun_q && ends;

  assign late = timed_out && !in_valid && !go;
  assign width_wait = (commit && !begun_q && !same_width) || (width_wait_q && !width_free_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {active_q, begun_q, quiet_q, settings_wait_q, settings_loaded_q, width_wait_q, late_q, held_q} <= '0;
    end else begin
      {late_q, width_wait_q, held_q} <= {late, width_wait, late || width_wait};
      settings_wait_q   <= arrival && settings_stop && !load_settings_o;
      settings_loaded_q <= load_settings_o || (settings_loaded_q && !take);
      active_q <= start ? enable_i && !eol : active_q && !(go && ends);
      begun_q  <= commit || (begun_q && !start);
      quiet_q  <= (take && (sof || !active_q)) || (quiet_q && !(end_now && (whole || !in_valid)));
    end
  end
  assign switch_o = settings_wait_q || (width_wait_q && !width_free_i);
  assign load_settings_o = settings_wait_q && drained_i;

  assign pixel_valid_o = in_valid;
  assign pixel_first_o = sof;
  assign pixel_step_o = start || step;
  assign pixel_commit_o = commit;
  assign pixel_begins_o = !begun_q;

  // The announcement of the pixel taken last; one of a new width waits for it. A frame that did not
  // end badly may be too small.
  logic announce_q;
  logic [1:0] fault_q;
  assign line_valid_o = announce_q && !width_wait_q;
  assign line_fault_o = fault_q | {2{event_o[TooFewRows]}};
  always_ff @(posedge clk_i) begin
    announce_q <= rst_ni && (commit || end_now || (announce_q && width_wait_q));
    if (go) begin
      line_whole_o <= whole;
      line_first_o <= !begun_q;
      line_last_o  <= active_q && begun_q && ends;
      // Of a frame's end only.
      fault_q[0]   <= in_valid && (sof ? in_line : !whole && !over_max);
      fault_q[1]   <= in_valid && (sof ? !in_line && height_known : !whole && over_max);
    end
  end

  idle_timer i_idle (
      .clk_i,
      .restart_i(!rst_ni || in_valid),
      .timeout_i(flush_timeout_i),
      .idle_o,
      .timed_out_o(timed_out)
  );

  always_ff @(posedge clk_i) begin
    event_o[ShortLine]  <= step && eol && begun_q && !same_width;
    event_o[LongLine]   <= step && !eol && begun_q && must_end;
    event_o[TooWide]    <= step && !eol && !begun_q && must_end;
    event_o[TooNarrow]  <= take && eol && (sof ? enable_i : active_q && !begun_q && !fits);
    event_o[TooTall]    <= step && eol && begun_q && same_width && !fits;
    event_o[NoStart]    <= take && !sof && !active_q && !quiet_q;
    event_o[EarlyStart] <= arrival && active_q && (in_line || height_known);
    event_o[TooFewRows] <= end_now && few_rows &&
                           (!in_valid || (sof ? !in_line && !height_known : whole && !fifth));
  end

  always_ff @(posedge clk_i) begin
    if (rst_ni && line_valid_o) assert (!line_first_o || (line_whole_o && !line_last_o));
  end
endmodule
