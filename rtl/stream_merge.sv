// SPDX-License-Identifier: Apache-2.0
//
// Merges record streams, one whole record (beat) at a time, round robin.
//
//   s_*  Inputs streams, packed side by side;  m_*  the merged stream
//
// Latency 1 clock, throughput 1 record per clock. A waiting input is served after at most
// Inputs - 1 others; the records of one input keep their order.
module stream_merge #(
    parameter int Inputs = 3,  // 1 .. 16
    parameter int Width  = 65  // payload (tdata and tlast), bits
) (
    input  logic                    clk_i,
    input  logic                    rst_ni,
    input  logic [      Inputs-1:0] s_tvalid_i,
    output logic [      Inputs-1:0] s_tready_o,
    input  logic [Inputs*Width-1:0] s_tdata_i,
    output logic                    m_tvalid_o,
    input  logic                    m_tready_i,
    output logic [       Width-1:0] m_tdata_o
);
  if (Inputs < 1 || Inputs > 16 || Width < 1) begin : gen_illegal
    illegal_Inputs_must_be_1_to_16_and_Width_at_least_1 stop ();
  end

  // Lowest valid input above the one served last, else lowest of all.
  logic [Inputs-1:0] above_q, candidates, grant;
  logic take;
  assign candidates = |(s_tvalid_i & above_q) ? s_tvalid_i & above_q : s_tvalid_i;
  assign grant = candidates & (~candidates + Inputs'(1));
  assign take = !m_tvalid_o || m_tready_i;
  assign s_tready_o = take ? grant : '0;

  logic [Width-1:0] chosen;
  always_comb begin
    chosen = '0;
    for (int i = 0; i < Inputs; i++) begin
      if (grant[i]) chosen = chosen | s_tdata_i[i*Width+:Width];
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) m_tdata_o <= chosen;
    if (!rst_ni) begin
      m_tvalid_o <= 1'b0;
      above_q    <= '0;
    end else if (take) begin
      m_tvalid_o <= |s_tvalid_i;
      if (|s_tvalid_i) above_q <= ~(grant | (grant - Inputs'(1)));
    end
  end

  // Handshake: an offered record stays, unchanged, until it is taken; one input at a time.
  logic             held_q;
  logic [Width-1:0] held_data_q;
  always_ff @(posedge clk_i) begin
    held_q      <= rst_ni && m_tvalid_o && !m_tready_i;
    held_data_q <= m_tdata_o;
    if (rst_ni) begin
      assert (!held_q || (m_tvalid_o && m_tdata_o == held_data_q));
      assert ((s_tready_o & (s_tready_o - Inputs'(1))) == '0);
    end
  end
endmodule
