// SPDX-License-Identifier: Apache-2.0
//
// Sends announced lines out of the pixel ring as row slots, and void slots that drain a frame.
//
// A row slot is one beat per column. Lines follow each other without a gap. When a frame has
// ended, is still in flight, and neither a line nor (for 16 clocks) any input is there, void
// rows push it on; a line that arrives meanwhile takes over at the void row's end.
//
//   line_*       announcements of frame_guard; last_col_i: width - 1
//   write_*, read_o   the pixel ring: written by frame_guard, read here
//   go_i         a beat may be sent in this clock (room for it is sure)
//   idle_i       no input for 16 clocks;  switch_i: frame_guard waits for drained_o
//   frame_done_i one clock per frame that has left the pipeline
//   drained_o    no frame in flight, nothing announced
//   slot out     valid_o, sol_o (column 0), sof_o, real_o, fault_o (how the frame before this
//                row ended), data_o; see line_window
//
// Latency 3 clocks; throughput 1 pixel per clock, frames back to back.
module row_slots #(
    parameter int MaxWidthPx = 1920,
    parameter int RingBits   = 11
) (
    input  logic                          clk_i,
    input  logic                          rst_ni,
    input  logic                          line_valid_i,
    output logic                          line_ready_o,
    input  logic                          line_whole_i,
    input  logic                          line_first_i,
    input  logic                          line_last_i,
    input  logic [                   1:0] line_fault_i,
    input  logic [$clog2(MaxWidthPx)-1:0] last_col_i,
    input  logic                          write_valid_i,
    input  logic [          RingBits-1:0] write_address_i,
    input  logic [                   7:0] write_data_i,
    output logic [            RingBits:0] read_o,
    input  logic                          go_i,
    input  logic                          idle_i,
    input  logic                          switch_i,
    input  logic                          frame_done_i,
    output logic                          drained_o,
    output logic                          valid_o,
    output logic                          sol_o,
    output logic                          sof_o,
    output logic                          real_o,
    output logic [                   1:0] fault_o,
    output logic [                   7:0] data_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080 || (1 << RingBits) < MaxWidthPx + 16) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080_RingBits_log2_of_MaxWidthPx_plus_16 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  // The announcements; an end without a line is taken at once, a line when its row starts.
  logic head_valid, head_ready, head_whole, head_first, head_last;
  logic [1:0] head_fault;
  shift_fifo #(
      .Width(5),
      .Depth(4)
  ) i_lines (
      .clk_i,
      .rst_ni,
      .s_tvalid_i(line_valid_i),
      .s_tready_o(line_ready_o),
      .s_tdata_i ({line_whole_i, line_first_i, line_last_i, line_fault_i}),
      .m_tvalid_o(head_valid),
      .m_tready_i(head_ready),
      .m_tdata_o ({head_whole, head_first, head_last, head_fault})
  );

  logic busy_q, real_q, sof_q, sol_q, last_q;  // the slot being sent, column 0, last column
  logic ended_q;                               // no frame is open
  logic [1:0] fault_q, slot_fault_q;
  logic [ColBits-1:0] col_q, last_col_m1_q;
  logic [RingBits:0] read_q;
  logic [7:0] frames_q;                        // in flight: begun, not done
  logic in_flight_q;

  logic send, free, start_line, start_void;
  assign send = busy_q && go_i;
  assign free = !busy_q || (send && last_q) || (!real_q && !in_flight_q);
  assign start_line = free && head_valid && head_whole;
  assign start_void = free && !head_valid && ended_q && in_flight_q && (idle_i || switch_i);
  assign head_ready = start_line || !head_whole;
  assign drained_o = !in_flight_q && !busy_q && !head_valid;
  assign read_o = read_q;

  always_ff @(posedge clk_i) begin
    last_col_m1_q <= last_col_i - ColBits'(1);
    if (send) begin
      col_q  <= col_q + ColBits'(1);
      last_q <= col_q == last_col_m1_q;
      sol_q  <= 1'b0;
    end
    if (start_line || start_void) begin
      col_q        <= '0;
      last_q       <= 1'b0;
      sol_q        <= 1'b1;
      real_q       <= start_line;
      sof_q        <= head_first;
      slot_fault_q <= fault_q;
    end
    if (head_valid && head_ready && head_last) fault_q <= head_fault;
    if (!rst_ni) begin
      {busy_q, in_flight_q} <= '0;
      ended_q <= 1'b1;
      {read_q, frames_q} <= '0;
    end else begin
      busy_q <= start_line || start_void || (busy_q && !free);
      if (head_valid && head_ready) ended_q <= head_last;
      if (send && real_q) read_q <= read_q + (RingBits + 1)'(1);
      frames_q <= frames_q + 8'(start_line && head_first) - 8'(frame_done_i);
      in_flight_q <= (frames_q != '0) || (start_line && head_first);
    end
  end

  always_ff @(posedge clk_i) begin
    valid_o <= rst_ni && send;
    sol_o   <= sol_q;
    sof_o   <= sof_q;
    real_o  <= real_q;
    fault_o <= slot_fault_q;
  end

  line_memory #(
      .Width(8),
      .Depth(1 << RingBits)
  ) i_ring (
      .clk_i,
      .wen_i  (write_valid_i),
      .waddr_i(write_address_i),
      .wdata_i(write_data_i),
      .raddr_i(read_q[RingBits-1:0]),
      .rdata_o(data_o)
  );

  // A frame leaves only after it has entered, and a row is never left unfinished.
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!frame_done_i || frames_q != '0);
      assert (!(start_line && busy_q && real_q) || last_q);
    end
  end
endmodule
