// SPDX-License-Identifier: Apache-2.0
module vertices #(
    parameter int MaxWidthPx = 1920
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic [ 7:0] min_strength_i,
    input  logic        valid_i,
    input  logic        sol_i,
    input  logic        sof_i,
    input  logic        real_i,
    input  logic [ 1:0] fault_i,
    input  logic        data_i,
    output logic        vertex_valid_o,
    output logic [11:0] vertex_x_o,
    output logic [11:0] vertex_y_o,
    output logic [ 3:0] vertex_branches_o,
    output logic [ 7:0] vertex_pattern_o,
    output logic [ 7:0] vertex_strength_o,
    output logic        end_valid_o,
    output logic [ 1:0] end_fault_o
);
  logic [24:0] window;
  logic valid, in_frame, is_end;
  logic [1:0] end_fault;
  line_window #(
      .Width(1),
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
      .sol_o(),
      .eol_o(),
      .sof_o(),
      .real_o(),
      .fault_o(),
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .tail_data_o(),
      .end_o(is_end),
      .end_fault_o(end_fault)
  );
  always_ff @(posedge clk_i) begin
    vertex_valid_o <= rst_ni && valid && in_frame && window[12] && &window[24:20];
    {vertex_x_o, vertex_y_o, vertex_branches_o, vertex_pattern_o} <= '0;
    vertex_strength_o <= min_strength_i;
    end_valid_o <= rst_ni && valid && is_end;
    end_fault_o <= end_fault;
  end
endmodule
