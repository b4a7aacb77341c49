// SPDX-License-Identifier: Apache-2.0
//
// Sends announced lines out of the pixel ring as row slots, and void slots that drain a frame.
//
// A row slot is one beat per column. Lines follow each other without a gap. When a frame has
// ended, is still in flight, and neither a line nor (for 16 clocks) any input is there, void
// rows push it on; a line that arrives meanwhile takes over at the void row's end.
//
// Nothing tells when a frame has left the pipeline: drain_count knows it by counting.
//
// A slot is as long as the wider of two widths until the rows of the other one have left.
//
//   line_*       announcements of frame_guard; before_last_i: both widths - 2, line_tag_i which one
//   width_free_o no line of the width that the line sent last does not have is announced or in flight
//   read_o, restart_o, unread_o   to pixel_ring; read_o one clock ahead of the slot out
//   go_i         a beat may be sent in this clock (room for it is sure)
//   idle_i       no input for 16 clocks;  switch_i: frame_guard waits for drained_o
//   drained_o    no frame in flight, nothing announced
//   slot out     valid_o, sol_o (column 0), sof_o, real_o, fault_o (how the frame before this
//                row ended), see slot_tracker; in_row_o the column belongs to the row
//
// Latency 3 clocks; throughput 1 pixel per clock, frames back to back.
module row_slots #(
    parameter int MaxWidthPx = 1920  // longest line, 5 .. 4080 px
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            line_valid_i,
    output logic                            line_ready_o,
    input  logic                            line_whole_i,
    input  logic                            line_first_i,
    input  logic                            line_last_i,
    input  logic [                     1:0] line_fault_i,
    input  logic                            line_tag_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    output logic                            width_free_o,
    output logic                            read_o,
    output logic                            restart_o,
    output logic                            unread_o,
    input  logic                            go_i,
    input  logic                            idle_i,
    input  logic                            switch_i,
    output logic                            drained_o,
    output logic                            valid_o,
    output logic                            sol_o,
    output logic                            sof_o,
    output logic                            real_o,
    output logic [                     1:0] fault_o,
    output logic                            in_row_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  // The announcements; an end without a line is taken at once, a line when its row starts.
  logic head_valid, head_ready, head_whole, head_first, head_last, head_tag, fifo_ready;
  logic first_behind;  // of another frame
  logic [1:0] head_fault;
  logic [4:0] unused_behind;
  shift_fifo #(
      .Width(6),
      .Depth(4)
  ) i_lines (
      .clk_i,
      .rst_ni,
      .s_tvalid_i(line_valid_i),
      .s_tready_o(fifo_ready),
      .s_tdata_i ({line_tag_i, line_whole_i, line_first_i, line_last_i, line_fault_i}),
      .m_tvalid_o(head_valid),
      .m_tready_i(head_ready),
      .m_tdata_o ({head_tag, head_whole, head_first, head_last, head_fault}),
      .room_o(line_ready_o),
      .behind_o({unused_behind[4:3], first_behind, unused_behind[2:0]})
  );

  // The slot being sent: column 0, last column; its row: first of a frame, last column, still within.
  logic busy_q, real_q, sof_q, sol_q, last_q, row_last_q, in_row_q;
  logic over_q;                                // a void row that nothing needs any more
  logic ended_q;                               // no frame is open
  logic second_width_q, second_slot_q;         // which of the widths its row and its slot have
  logic [1:0] fault_q, slot_fault_q;
  logic [ColBits-1:0] col_q, first_width, second_width;
  logic [ColBits-1:0] slot_limit_q, row_limit_q;  // their widths less 2, in time for column 1
  assign {second_width, first_width} = before_last_i;

  logic send, free, start_line, start_void, other_width, left, other_left, nothing_announced;
  assign nothing_announced = !head_valid && !line_valid_i;
  assign send = busy_q && go_i;
  assign free = !busy_q || (go_i && last_q) || over_q;
  assign start_line = free && head_valid && head_whole;
  assign start_void = free && nothing_announced && !left && ((ended_q && idle_i) || switch_i);
  assign other_width = start_line && head_tag != second_width_q;
  assign head_ready = start_line || !head_whole;
  assign read_o = send && real_q && in_row_q;
  // The frame that starts is the one begun last: no other is announced or waits for its width.
  assign restart_o = start_line && head_first && !first_behind && !(line_valid_i && line_first_i) && !switch_i;

  drain_count i_left (
      .clk_i,
      .rst_ni,
      .clear_i (start_line),
      .row_i   (start_void),
      .beat_i  (send),
      .passed_o(left)
  );
  drain_count i_other_left (
      .clk_i,
      .rst_ni,
      .clear_i (other_width),
      .row_i   (start_line || start_void),
      .beat_i  (send),
      .passed_o(other_left)
  );

  logic first_wider_q;
  always_ff @(posedge clk_i) begin
    first_wider_q <= first_width > second_width;
    slot_limit_q  <= second_slot_q ? second_width : first_width;
    row_limit_q   <= second_width_q ? second_width : first_width;
    if (send) begin
      col_q      <= col_q + ColBits'(1);
      last_q     <= !sol_q && col_q == slot_limit_q;
      row_last_q <= !sol_q && col_q == row_limit_q;
      sol_q      <= 1'b0;
      if (row_last_q) in_row_q <= 1'b0;
    end
    if (start_line || start_void) begin
      col_q        <= '0;
      last_q       <= 1'b0;
      row_last_q   <= 1'b0;
      in_row_q     <= 1'b1;
      sol_q        <= 1'b1;
      real_q       <= start_line;
      sof_q        <= start_line && head_first;
      slot_fault_q <= fault_q;
      second_slot_q <= other_width || !other_left ? !first_wider_q
                       : start_line ? head_tag : second_width_q;
    end
    if (head_valid && head_ready && head_last) fault_q <= head_fault;
    if (!rst_ni) begin
      {busy_q, over_q, drained_o, width_free_o, unread_o, second_width_q} <= '0;
      ended_q <= 1'b1;
    end else begin
      busy_q <= start_line || start_void || (busy_q && !free);
      over_q <= busy_q && !real_q && left && !start_line;
      if (start_line) second_width_q <= head_tag;
      if (head_valid && head_ready) ended_q <= head_last;
      drained_o    <= left && !busy_q && nothing_announced;
      // Not while a slot still has the other width.
      width_free_o <= other_left && nothing_announced &&
                      (!busy_q || second_slot_q == second_width_q);
      unread_o     <= head_valid || (busy_q && real_q);
    end
  end

  always_ff @(posedge clk_i) begin
    valid_o  <= rst_ni && send;
    sol_o    <= sol_q;
    sof_o    <= sof_q;
    real_o   <= real_q && !(sof_q && second_width_q);
    fault_o  <= slot_fault_q;
    in_row_o <= in_row_q;
  end

  // No announcement is lost, and a row is never left unfinished.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!line_valid_i || fifo_ready);
      assert (!(start_line && busy_q && real_q) || last_q);
    end
  end
endmodule
