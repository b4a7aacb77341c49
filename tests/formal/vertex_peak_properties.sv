// SPDX-License-Identifier: Apache-2.0
//
// vertex_peak for any stream of row slots, whatever its line memory held before: a value that a score sees
// is of a row of a frame and of one of its columns. So no score, and no vertex, comes from beyond a row, from
// void rows or from before a reset.
//
// What comes in is 0 beyond a row, as vertex_value's results are. Scores and rings are cut out.
module vertex_peak_properties (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       valid,
    input logic       sol,
    input logic       sof,
    input logic       is_real,
    input logic [1:0] change,
    input logic [2:0] new_width,
    input logic       value,
    input logic [1:0] above
);
  localparam int MaxWidthPx = 6;
  // A width may change two rows behind the last one of it, and not while it is that of the last frame.
  localparam int Voids = 0;

  logic started, in_row, value_now;
  logic [5:0] width, before_last;
  logic [1:0] kind, last_q;
  logic [2:0] col;
  assumed_slots #(
      .Voids(Voids)
  ) in (
      .clk_i,
      .rst_ni,
      .change_i(change & ~last_q),
      .new_width_i(new_width),
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .started_o(started),
      .width_o(width),
      .before_last_o(before_last),
      .kind_o(kind),
      .col_o(col),
      .in_row_o(in_row)
  );
  vertex_peak #(
      .MaxWidthPx(MaxWidthPx)
  ) dut (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(2'd0),
      .before_last_i(before_last),
      .value_i(value_now),
      .above_i(above),
      .vertex_valid_o(),
      .vertex_x_o(),
      .vertex_y_o(),
      .vertex_branches_o(),
      .vertex_pattern_o(),
      .vertex_strength_o(),
      .end_valid_o(),
      .end_fault_o()
  );

  // Widths of the last seven rows, 0 for a void one, newest in the high bits.
  logic [20:0] widths_q;
  logic [2:0] col_q;
  logic valid_q;
  (* hierconn *) wire [6:0] \dut.values ;
  assign value_now = value && in_row;
  always_ff @(posedge clk_i) begin
    valid_q <= rst_ni && valid;
    col_q   <= col;
    if (!rst_ni) last_q <= '0;
    else if (kind != 2'd0) last_q <= kind;
    if (!rst_ni) widths_q <= '0;
    else if (valid && sol) begin
      widths_q <= {kind[1] ? width[5:3] : kind[0] ? width[2:0] : 3'd0, widths_q[20:3]};
    end
    if (started && rst_ni && valid_q) begin
      for (int k = 0; k < 7; k++) assert (!\dut.values [k] || col_q < widths_q[3*k+:3]);
    end
  end
endmodule
