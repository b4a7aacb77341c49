// SPDX-License-Identifier: Apache-2.0
module second_contour #(
    parameter int MaxWidthPx    = 1920,
    parameter int MagnitudeBits = 9
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic [MagnitudeBits+4:0] support_i,
    input  logic                     valid_i,
    input  logic                     sol_i,
    input  logic                     sof_i,
    input  logic                     real_i,
    input  logic [              1:0] fault_i,
    input  logic [MagnitudeBits+2:0] data_i,
    output logic                     valid_o,
    output logic                     sol_o,
    output logic                     eol_o,
    output logic                     sof_o,
    output logic                     real_o,
    output logic [              1:0] fault_o,
    output logic [MagnitudeBits+1:0] data_o
);
  logic [5*5*(MagnitudeBits+3)-1:0] window;
  logic valid, eol, sol, sof, is_real, in_frame;
  logic [1:0] fault;
  line_window #(
      .Width(MagnitudeBits+3),
      .MaxWidthPx(MaxWidthPx)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .data_i,
      .window_o(window),
      .valid_o(valid),
      .sol_o(sol),
      .eol_o(eol),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(fault),
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .tail_data_o(),
      .end_o(),
      .end_fault_o()
  );
  logic [MagnitudeBits+2:0] centre;
  assign centre = window[12*(MagnitudeBits+3)+:MagnitudeBits+3];
  always_ff @(posedge clk_i) begin
    valid_o <= valid && rst_ni;
    {eol_o, sol_o, sof_o, real_o, fault_o} <= {eol, sol, sof, is_real, fault};
    data_o <= {centre[MagnitudeBits+2], in_frame && centre[MagnitudeBits+2] &&
               centre[MagnitudeBits+1] && support_i != '0, centre[MagnitudeBits-1:0]};
  end
endmodule
