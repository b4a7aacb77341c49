// SPDX-License-Identifier: Apache-2.0
//
// Pixels in, row slots of well-formed frames out, with the settings that each frame is to have.
//
//   frame_guard -- lines --> row_slots --> slots
//          \-- pixels --> pixel_ring --> data_o, as row_slots reads them
//
//   s_axis_*         8-bit grey video: tuser start of frame, tlast end of line
//   enable_i .. flush_timeout_i, event_o   see frame_guard
//   settings_i       sampled when a frame's first pixel leaves the input register; with hold_i 1 the
//                    settings of the frame before stay. Others than those in force let that pixel
//                    wait until no frame is in flight
//   settings_o       of the frames in flight
//   go_i             the stages behind have room
//   slot out         see row_slots; before_last_o both widths - 2; data_o pixel, 1 clock behind it
//
// Latency 1 line + 5 clocks to data_o; 1 pixel per clock.
module row_source #(
    parameter int MaxWidthPx   = 1920,  // longest line, 5 .. 4080 px
    parameter int MaxHeightPx  = 1200,  // most lines, 5 .. 4095
    parameter int SettingsBits = 58     // 1 ..
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
    input  logic [        SettingsBits-1:0] settings_i,
    output logic [        SettingsBits-1:0] settings_o,
    output logic [                     7:0] event_o,
    input  logic                            go_i,
    output logic                            valid_o,
    output logic                            sol_o,
    output logic                            sof_o,
    output logic                            real_o,
    output logic [                     1:0] fault_o,
    output logic                            in_row_o,
    output logic [2*$clog2(MaxWidthPx)-1:0] before_last_o,
    output logic [                     7:0] data_o
);
  if (SettingsBits < 1) begin : gen_illegal
    illegal_SettingsBits_must_be_at_least_1 stop ();
  end

  // The comparison takes two clocks, eight bits at a time in the first: two levels of logic. What it
  // says behind a load is still of the settings before: a next frame may start in the clock after.
  localparam int Parts = SettingsBits / 8 + 1;
  logic [8*Parts-1:0] difference;
  logic [Parts-1:0] differs_q;
  logic settings_changed_q, load_settings, loaded_q;
  assign difference = (8 * Parts)'(settings_i) ^ (8 * Parts)'(settings_o);
  always_ff @(posedge clk_i) begin
    for (int i = 0; i < Parts; i++) differs_q[i] <= difference[8*i+:8] != '0;
    settings_changed_q <= !hold_i && !loaded_q && differs_q != '0;
    loaded_q           <= rst_ni && load_settings;
    if (!rst_ni || (load_settings && !hold_i)) settings_o <= settings_i;
  end

  logic line_valid, line_ready, line_whole, line_first, line_last;
  logic switch_wanted, drained, idle, unread;
  logic [1:0] line_fault;
  logic pixel_valid, pixel_first, pixel_step, pixel_commit, pixel_begins, ring_ready, read, restart;
  logic [7:0] pixel;
  logic line_tag, width_free;
  frame_guard #(
      .MaxWidthPx (MaxWidthPx),
      .MaxHeightPx(MaxHeightPx)
  ) i_guard (
      .clk_i,
      .rst_ni,
      .s_axis_tvalid_i,
      .s_axis_tready_o,
      .s_axis_tdata_i,
      .s_axis_tuser_i,
      .s_axis_tlast_i,
      .enable_i,
      .hold_i,
      .frame_height_i,
      .flush_timeout_i,
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
      .before_last_o,
      .width_free_i(width_free),
      .settings_changed_i(settings_changed_q),
      .switch_o(switch_wanted),
      .drained_i(drained),
      .load_settings_o(load_settings),
      .idle_o(idle),
      .event_o
  );

  row_slots #(
      .MaxWidthPx(MaxWidthPx)
  ) i_slots (
      .clk_i,
      .rst_ni,
      .line_valid_i(line_valid),
      .line_ready_o(line_ready),
      .line_whole_i(line_whole),
      .line_first_i(line_first),
      .line_last_i(line_last),
      .line_fault_i(line_fault),
      .line_tag_i(line_tag),
      .before_last_i(before_last_o),
      .width_free_o(width_free),
      .read_o(read),
      .restart_o(restart),
      .unread_o(unread),
      .go_i,
      .idle_i(idle),
      .switch_i(switch_wanted),
      .drained_o(drained),
      .valid_o,
      .sol_o,
      .sof_o,
      .real_o,
      .fault_o,
      .in_row_o
  );

  // The ring reads a clock later; where another frame begins in between, its restart would be wrong.
  logic read_q, restart_q;
  always_ff @(posedge clk_i) begin
    read_q    <= rst_ni && read;
    restart_q <= rst_ni && restart && !(pixel_commit && pixel_begins);
  end
  pixel_ring #(
      .MaxWidthPx (MaxWidthPx),
      .AddressBits($clog2(MaxWidthPx + 16))
  ) i_ring (
      .clk_i,
      .rst_ni,
      .pixel_valid_i(pixel_valid),
      .pixel_i(pixel),
      .first_i(pixel_first),
      .step_i(pixel_step),
      .commit_i(pixel_commit),
      .begins_i(pixel_begins),
      .ready_o(ring_ready),
      .read_i(read_q),
      .restart_i(restart_q),
      .unread_i(unread),
      .data_o
  );
endmodule
