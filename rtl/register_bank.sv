// SPDX-License-Identifier: Apache-2.0
//
// A block of 32-bit registers described by three masks (see trihedron_registers).
//
//   write_i, word_i, data_i, strobe_i  write access to one word
//   read_word_i, read_data_o           the word's value, one clock later
//   status_i   values of read-only bits;  event_i  a 1 sets its sticky bit
//   value_o    writable and sticky bits
//
// A write takes effect in the next clock; an event wins over a write that clears it.
module register_bank #(
    parameter int Words = 4,                       // 2, 4, 8, 16 ..
    parameter logic [32*Words-1:0] Writable = '1,  // bits that software writes
    parameter logic [32*Words-1:0] Sticky = '0,    // bits that an event sets, a written 1 clears
    parameter logic [32*Words-1:0] Reset = '0      // value after reset of writable bits
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic                     write_i,
    input  logic [$clog2(Words)-1:0] word_i,
    input  logic [             31:0] data_i,
    input  logic [              3:0] strobe_i,
    input  logic [$clog2(Words)-1:0] read_word_i,
    output logic [             31:0] read_data_o,
    input  logic [     32*Words-1:0] status_i,
    input  logic [     32*Words-1:0] event_i,
    output logic [     32*Words-1:0] value_o
);
  if (Words < 2 || Words != (1 << $clog2(Words))) begin : gen_illegal
    illegal_Words_must_be_a_power_of_two_from_2 stop ();
  end

  logic [31:0] byte_mask;
  assign byte_mask = {{8{strobe_i[3]}}, {8{strobe_i[2]}}, {8{strobe_i[1]}}, {8{strobe_i[0]}}};

  // Bits that are neither writable nor sticky stay at 0 and vanish in synthesis.
  always_ff @(posedge clk_i) begin
    for (int w = 0; w < Words; w++) begin
      if (!rst_ni) begin
        value_o[32*w+:32] <= Reset[32*w+:32] & Writable[32*w+:32];
      end else begin
        value_o[32*w+:32] <=
            (write_i && word_i == $clog2(Words)'(w)
                 ? (value_o[32*w+:32] & ~byte_mask) | (data_i & byte_mask & Writable[32*w+:32]) |
                   (value_o[32*w+:32] & ~data_i & Sticky[32*w+:32])
                 : value_o[32*w+:32]) |
            (event_i[32*w+:32] & Sticky[32*w+:32]);
      end
    end
    read_data_o <= value_o[32*read_word_i+:32] | status_i[32*read_word_i+:32];
  end

  // A bit that is neither writable nor sticky is never set.
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert ((value_o & ~Writable & ~Sticky) == '0);
  end
endmodule
