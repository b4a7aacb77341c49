// SPDX-License-Identifier: Apache-2.0
//
// The memory between frame_guard and row_slots: a ring of pixels in which whole lines wait.
//
//   pixel_*      writer: pixel_valid_i a pixel is offered, first_i it begins a frame (what came since
//                the last commit is forgotten), step_i it is taken, commit_i it ends a whole line,
//                begins_i that line is its frame's first
//   ready_o      room for the next pixel
//   read_i       reader: a pixel of a whole line is read, data_o one clock later
//   restart_i    with the next pixel the frame begins whose first line was committed last
//   unread_i     the reader has lines to read
//
// restart_i brings a reader or writer back that an upset has moved, also where lines always wait; and
// since a line alone never fills the ring, it is never full while nothing waits in it.
//
// Latency 1 clock, 1 pixel per clock on both sides. The room ends 8 pixels early, since it is known two
// clocks late.
module pixel_ring #(
    parameter int MaxWidthPx  = 1920,  // longest line, 5 .. 4080 px
    parameter int AddressBits = 11     // 2^AddressBits pixels, at least MaxWidthPx + 16
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic       pixel_valid_i,
    input  logic [7:0] pixel_i,
    input  logic       first_i,
    input  logic       step_i,
    input  logic       commit_i,
    input  logic       begins_i,
    output logic       ready_o,
    input  logic       read_i,
    input  logic       restart_i,
    input  logic       unread_i,
    output logic [7:0] data_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080 || (1 << AddressBits) < MaxWidthPx + 16) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080_AddressBits_log2_of_MaxWidthPx_plus_16 stop ();
  end

  // Positions have one bit more than an address: their difference tells empty from full. A line begins
  // at commit_q, the frame begun last began at frame_q.
  logic [AddressBits:0] write_q, commit_q, frame_q, read_q, here, next, filled_q;
  logic nearly_full;
  assign here   = first_i ? commit_q : write_q;
  assign next   = here + (AddressBits + 1)'(1);
  assign nearly_full = filled_q[AddressBits] || &filled_q[AddressBits-1:3];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {write_q, commit_q, frame_q, read_q} <= '0;
      ready_o <= 1'b0;
    end else begin
      if (step_i) write_q <= next;
      if (commit_i) commit_q <= next;
      if (commit_i && begins_i) frame_q <= commit_q;
      if (restart_i) read_q <= frame_q;
      else if (read_i) read_q <= read_q + (AddressBits + 1)'(1);
      ready_o <= !(unread_i && nearly_full);
    end
    filled_q <= rst_ni ? write_q - read_q : '0;
  end

  line_memory #(
      .Width(8),
      .Depth(1 << AddressBits)
  ) i_pixels (
      .clk_i,
      .wen_i  (pixel_valid_i),
      .waddr_i(here[AddressBits-1:0]),
      .wdata_i(pixel_i),
      .raddr_i(read_q[AddressBits-1:0]),
      .rdata_o(data_o)
  );

  // The reader is where it should be.
  always_ff @(posedge clk_i) begin
    if (rst_ni && restart_i) assert (frame_q == read_q + (AddressBits + 1)'(read_i));
  end
endmodule
