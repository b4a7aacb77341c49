// SPDX-License-Identifier: Apache-2.0
//
// A skid buffer without its registers. skid_buffer is proved to be a queue; what is true for every
// stream in front of it is true for every stream behind it, so the proofs of its users leave it out.
module skid_buffer #(
    parameter int Width = 10
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             s_tvalid_i,
    output logic             s_tready_o,
    input  logic [Width-1:0] s_tdata_i,
    output logic             m_tvalid_o,
    input  logic             m_tready_i,
    output logic [Width-1:0] m_tdata_o
);
  assign s_tready_o = m_tready_i;
  assign m_tvalid_o = s_tvalid_i;
  assign m_tdata_o  = s_tdata_i;

  // A stream: an offered beat stays, unchanged, until it is taken.
  logic held_q;
  logic [Width-1:0] data_q;
  always_ff @(posedge clk_i) begin
    held_q <= rst_ni && s_tvalid_i && !m_tready_i;
    data_q <= s_tdata_i;
    if (rst_ni && held_q) assume (s_tvalid_i && s_tdata_i == data_q);
  end
endmodule
