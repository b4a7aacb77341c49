// SPDX-License-Identifier: Apache-2.0
//
// One view's register block: counters and sticky status.
//
//   event_i       events of frame_guard, one clock each
//   frame_done_i  one clock per frame that has left the pipeline; sent_i, lost_i its vertices
//   write_i .. read_data_o  access to the block, see register_bank
//
// Counters wrap around.
module view_counters (
    input  logic                         clk_i,
    input  logic                         rst_ni,
    input  logic [                  7:0] event_i,
    input  logic                         frame_done_i,
    input  logic [                 15:0] sent_i,
    input  logic [                 15:0] lost_i,
    input  logic                         write_i,
    input  logic [$clog2(trihedron_registers::ViewWords)-1:0] word_i,
    input  logic [                 31:0] data_i,
    input  logic [                  3:0] strobe_i,
    input  logic [$clog2(trihedron_registers::ViewWords)-1:0] read_word_i,
    output logic [                 31:0] read_data_o
);
  logic [31:0] frames_q, vertices_q, lost_q, last_frame_q;
  logic [15:0] errors_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {frames_q, vertices_q, lost_q, errors_q, last_frame_q} <= '0;
    end else begin
      if (frame_done_i) begin
        frames_q     <= frames_q + 32'd1;
        vertices_q   <= vertices_q + 32'(sent_i);
        lost_q       <= lost_q + 32'(lost_i);
        last_frame_q <= {lost_i, sent_i};
      end
      // Several events in one clock count as one.
      errors_q <= errors_q + 16'(event_i != '0);
    end
  end

  logic [32*trihedron_registers::ViewWords-1:0] status, events;
  always_comb begin
    status = '0;
    status[trihedron_registers::FramesFramesBit+:32] = frames_q;
    status[trihedron_registers::VerticesVerticesBit+:32] = vertices_q;
    status[trihedron_registers::LostVerticesBit+:32] = lost_q;
    status[trihedron_registers::ErrorsEventsBit+:16] = errors_q;
    status[trihedron_registers::LastFrameSentBit+:32] = last_frame_q;
    events = '0;
    events[trihedron_registers::StatusShortLineBit+:8] = event_i;
    events[trihedron_registers::StatusVerticesLostBit] = frame_done_i && lost_i != '0;
  end

  register_bank #(
      .Words(trihedron_registers::ViewWords),
      .Writable(trihedron_registers::ViewWritable),
      .Sticky(trihedron_registers::ViewSticky),
      .Reset(trihedron_registers::ViewReset)
  ) i_bank (
      .clk_i,
      .rst_ni,
      .write_i,
      .word_i,
      .data_i,
      .strobe_i,
      .read_word_i,
      .read_data_o,
      .status_i(status),
      .event_i(events),
      .value_o()
  );
endmodule
