// SPDX-License-Identifier: Apache-2.0
//
// A slot stream (see slot_tracker) Clocks later, to keep it in step with a kernel's arithmetic.
//
//   slot in, out   sof, real, fault of a row hold from its sol to the next, 0 before the first; between two
//                  sol at least two other beats, as a tracker's centre has them
//
// Only valid and sol are delayed clock by clock. What holds for a row is looked at after three clocks and
// handed on, which takes 4 registers per three clocks instead of 12. Latency Clocks, 1 beat per clock.
module slot_delay #(
    parameter int Clocks = 3  // 1 ..
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic       valid_i,
    input  logic       sol_i,
    input  logic       sof_i,
    input  logic       real_i,
    input  logic [1:0] fault_i,
    output logic       valid_o,
    output logic       sol_o,
    output logic       sof_o,
    output logic       real_o,
    output logic [1:0] fault_o
);
  if (Clocks < 1) begin : gen_illegal
    illegal_Clocks_must_be_at_least_1 stop ();
  end
  localparam int Steps = (Clocks + 2) / 3;

  // Bit k: k clocks later. A sol counts with its beat only.
  logic [Clocks:0] valid, sol;
  logic [Clocks-1:0] valid_q, sol_q;
  assign valid = {valid_q, valid_i};
  assign sol = {sol_q, valid_i && sol_i};
  assign valid_o = valid[Clocks];
  assign sol_o = sol[Clocks];
  always_ff @(posedge clk_i) begin
    valid_q <= rst_ni ? valid[Clocks-1:0] : '0;
    sol_q   <= sol[Clocks-1:0];
  end

  // Row k: as its sol is 3 k clocks late; the last one as it leaves.
  logic [4*(Steps+1)-1:0] rows;
  logic [4*Steps-1:0] rows_q;
  assign rows = {rows_q, sof_i, real_i, fault_i};
  assign {sof_o, real_o, fault_o} = rows[4*Steps+:4];
  for (genvar k = 1; k <= Steps; k++) begin : gen_rows
    localparam int Late = k < Steps ? 3 * k : Clocks;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) rows_q[4*(k-1)+:4] <= '0;
      else if (sol[Late-1]) rows_q[4*(k-1)+:4] <= rows[4*(k-1)+:4];
    end
  end
endmodule
