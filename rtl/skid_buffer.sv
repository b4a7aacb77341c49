// SPDX-License-Identifier: Apache-2.0
//
// Register slice of an AXI4-Stream: no combinational path between its two sides.
//
//   s_*, m_*  stream in and out; tdata is any payload (data, tuser, tlast) packed by the user
//
// Latency 1 clock, throughput 1 beat per clock. While the output is blocked, one more beat is
// taken into the spare register, then s_tready_o falls.
module skid_buffer #(
    parameter int Width = 10  // payload, bits
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
  if (Width < 1) begin : gen_illegal
    illegal_Width_must_be_at_least_1 stop ();
  end

  logic             main_valid_q, spare_valid_q;
  logic [Width-1:0] main_q, spare_q;

  assign s_tready_o = !spare_valid_q;
  assign m_tvalid_o = main_valid_q;
  assign m_tdata_o  = main_q;

  always_ff @(posedge clk_i) begin
    if (m_tready_i || !main_valid_q) main_q <= spare_valid_q ? spare_q : s_tdata_i;
    if (!spare_valid_q) spare_q <= s_tdata_i;
    main_valid_q  <= rst_ni && (spare_valid_q || s_tvalid_i || (main_valid_q && !m_tready_i));
    spare_valid_q <= rst_ni && (spare_valid_q || s_tvalid_i) && main_valid_q && !m_tready_i;
  end

  // Handshake: an offered beat stays, unchanged, until it is taken.
  logic             held_q;
  logic [Width-1:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_tvalid_o && !m_tready_i;
    held_data_q <= m_tdata_o;
    if (rst_ni && held_q) begin
      assert (m_tvalid_o && m_tdata_o == held_data_q);
    end
  end
endmodule
