// SPDX-License-Identifier: Apache-2.0
//
// register_bank: a writable byte takes what is written to it and keeps it; a sticky bit is set by
// its event, also in the clock in which it is cleared, and stays until 1 is written to it; a read
// returns the word. Word 0: bits 7:0 writable, 8 sticky, 9 read only; word 1: bits 15:0 writable.
module register_bank_properties (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        write,
    input logic        word,
    input logic [31:0] data,
    input logic [ 3:0] strobe,
    input logic        read_word,
    input logic        status,
    input logic        sticky_event
);
  localparam logic [63:0] Writable = 64'h0000_ffff_0000_00ff;
  localparam logic [63:0] Reset = 64'h0000_5a5a_0000_0012;
  logic [31:0] read_data;
  logic [63:0] value;
  register_bank #(
      .Words   (2),
      .Writable(Writable),
      .Sticky  (64'h0000_0000_0000_0100),
      .Reset   (Reset)
  ) dut (
      .clk_i,
      .rst_ni,
      .write_i(write),
      .word_i(word),
      .data_i(data),
      .strobe_i(strobe),
      .read_word_i(read_word),
      .read_data_o(read_data),
      .status_i({54'd0, status, 9'd0}),
      .event_i({55'd0, sticky_event, 8'd0}),
      .value_o(value)
  );

  logic started_q = 1'b0;
  logic was_reset_q, sticky_q, read_word_q, status_q;
  logic [7:0] low_q, low1_q, high1_q;  // the three writable bytes
  logic [63:0] value_q;
  always_ff @(posedge clk_i) begin
    started_q   <= 1'b1;
    was_reset_q <= !rst_ni;
    read_word_q <= read_word;
    status_q    <= status;
    value_q     <= value;
    if (!started_q) assume (!rst_ni);
    if (!rst_ni) begin
      sticky_q <= 1'b0;
      {high1_q, low1_q, low_q} <= {16'h5a5a, 8'h12};
    end else begin
      if (sticky_event) sticky_q <= 1'b1;
      else if (write && !word && strobe[1] && data[8]) sticky_q <= 1'b0;
      if (write && !word && strobe[0]) low_q <= data[7:0];
      if (write && word && strobe[0]) low1_q <= data[7:0];
      if (write && word && strobe[1]) high1_q <= data[15:8];
    end
    if (started_q && rst_ni) begin
      assert (value == {16'd0, high1_q, low1_q, 23'd0, sticky_q, low_q});
      assert (was_reset_q || read_data == (read_word_q ? value_q[63:32]
                                                       : value_q[31:0] | {22'd0, status_q, 9'd0}));
    end
  end
endmodule
