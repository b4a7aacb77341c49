// SPDX-License-Identifier: Apache-2.0
//
// Stage 4, second window: the vertices, where the vertex score is at least 25 and the largest of
// 5x3 pixels (see vertex_score, vertex_maximum).
//
//   slot in    see slot_tracker; before_last_i both widths - 2; value_i, above_i see vertex_value
//   vertex_*   in raster order, at least three columns apart, coordinates in px; branches and
//              pattern of the branch pixels around the vertex; strength_o the score, 25 .. 64
//   end_valid_o, end_fault_o   behind the last vertex of a frame; how the frame ended
//
// Latency 3 rows + 4 columns + 8 clocks, 1 beat per clock. Border: values are 0 where the window of
// vertex_value leaves the frame, so scores fall off towards the border and no vertex lies there.
module vertex_peak #(
    parameter int MaxWidthPx = 1920  // longest line, 5 .. 4080 px
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            valid_i,
    input  logic                            sol_i,
    input  logic                            sof_i,
    input  logic                            real_i,
    input  logic [                     1:0] fault_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    input  logic                            value_i,
    input  logic [                     1:0] above_i,
    output logic                            vertex_valid_o,
    output logic [                    11:0] vertex_x_o,
    output logic [                    11:0] vertex_y_o,
    output logic [                     3:0] vertex_branches_o,
    output logic [                     7:0] vertex_pattern_o,
    output logic [                     6:0] vertex_strength_o,
    output logic                            end_valid_o,
    output logic [                     1:0] end_fault_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  logic valid1, valid2, sol2, sof2, first2, is_end2;
  logic [1:0] end_fault2;
  logic [ColBits-1:0] col, col1;
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx)
  ) i_tracker (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i(1'b1),
      .before_last_i((2 * ColBits)'(0)),
      .col_o(col),
      .valid1_o(valid1),
      .col1_o(col1),
      .valid_o(valid2),
      .sol_o(sol2),
      .eol_o(),
      .sof_o(sof2),
      .real_o(),
      .fault_o(),
      .in_row_o(),
      .inside_o(),
      .tail_sol_o(first2),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(is_end2),
      .end_fault_o(end_fault2)
  );

  // Clock 1: the column's values of seven rows, newest in the high bits, and the branch pixels of
  // the five rows around the centre. Rows that are no frame's count 0, and so do those before a
  // frame that follows void rows: the memory may hold something else there, of another width. For
  // the same reason what lies beyond the row above does: a slot may be longer than its row.
  logic value1_q;
  logic [1:0] above1_q;
  logic [6:0] rows_real_q, values;
  logic [5:0] older;
  logic [2:0] older_on;
  logic sol1_q, in_row_above, second_width_q, above_second_q;
  assign values = {value1_q, in_row_above ? older & rows_real_q[5:0] : 6'd0};
  row_limit #(
      .ColBits(ColBits)
  ) i_limit (
      .clk_i,
      .valid_i(valid1),
      .sol_i(sol1_q),
      .col_i(col1),
      .before_last_i,
      .second_i(above_second_q),
      .within_o(in_row_above)
  );
  always_ff @(posedge clk_i) begin
    value1_q <= value_i;
    above1_q <= above_i;
    sol1_q   <= sol_i;
    if (valid_i && sol_i) above_second_q <= second_width_q;
    if (!rst_ni) second_width_q <= 1'b0;
    else if (valid_i && sol_i && sof_i) second_width_q <= !real_i;
    if (!rst_ni) begin
      rows_real_q <= '0;
    end else if (valid_i && sol_i) begin
      rows_real_q <= {real_i || sof_i, sof_i && !rows_real_q[6] ? 6'd0 : rows_real_q[6:1]};
    end
  end
  line_memory #(
      .Width(9),
      .Depth(MaxWidthPx)
  ) i_rows (
      .clk_i,
      .wen_i  (valid1),
      .waddr_i(col1),
      .wdata_i({above1_q[0], older_on[2:1], values[6:1]}),
      .raddr_i(col),
      .rdata_o({older_on, older})
  );

  // Clocks 2-8: the vertex scores of three rows, and whether the centre's is the largest around.
  logic [6:0] column_q;
  logic valid7, sol7, sof7, rows_inside7, inside_q;
  always_ff @(posedge clk_i) column_q <= values;
  vertex_maximum i_maximum (
      .clk_i,
      .rst_ni,
      .valid_i (valid2),
      .column_i(column_q),
      .within_i(rst_ni && valid7 && inside_q),
      .score_o (vertex_strength_o),
      .peak_o  (vertex_valid_o)
  );

  // Clocks 1-8: the branches around the centre, two columns behind the scores' newest.
  logic [4:0] on_q, on_late_q, on4;
  logic valid1_late4;
  always_ff @(posedge clk_i) begin
    if (valid1) {on_late_q, on_q} <= {on_q, above1_q, older_on};
  end
  delay_line #(
      .Width (6),
      .Clocks(3)
  ) i_on (
      .clk_i,
      .rst_ni,
      .data_i({valid1, on_late_q}),
      .data_o({valid1_late4, on4})
  );
  vertex_ring i_ring (
      .clk_i,
      .valid_i (valid1_late4),
      .column_i(on4[3:0]),
      .radial_i({{5{on4[4]}}, {2{on4[3]}}, on4[2], {2{on4[1]}}, {5{on4[0]}}}),
      .above_o(),
      .group_o(),
      .two_o(),
      .low_o(),
      .high_o(),
      .touches_o(),
      .inner_o(),
      .branches_o(vertex_branches_o),
      .pattern_o(vertex_pattern_o)
  );

  // A frame ends one row later than its last row has come: two row starts, and the two columns
  // that the last vertex may need. The row in between may be a frame of its own.
  logic [1:0] ending_q, fault_q;
  logic [3:0] faults_q;
  logic ends2, end7;
  assign ends2 = valid2 && sol2 && ending_q[1];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) ending_q <= '0;
    else if (valid2 && first2) ending_q <= {ending_q[0], is_end2};
    if (valid2 && first2) faults_q <= {faults_q[1:0], end_fault2};
    if (ends2) fault_q <= faults_q[3:2];
  end
  delay_line #(
      .Width (5),
      .Clocks(5)
  ) i_position (
      .clk_i,
      .rst_ni,
      .data_i({valid2, sol2, sof2, rows_real_q[5:1] == '1, ends2}),
      .data_o({valid7, sol7, sof7, rows_inside7, end7})
  );

  // Clock 8: position of the centre, and whether the five rows around it are a frame's. Frames
  // back to back need no more: their scores fall off towards the border.
  always_ff @(posedge clk_i) begin
    if (valid7) begin
      vertex_x_o <= sol7 ? -12'd2 : vertex_x_o + 12'd1;
      if (sol7) vertex_y_o <= sof7 ? -12'd1 : vertex_y_o + 12'd1;
    end
    if (!rst_ni) inside_q <= 1'b0;
    else if (valid7 && sol7) inside_q <= rows_inside7;
    end_valid_o <= rst_ni && end7;
    end_fault_o <= fault_q;
  end

  // A vertex lies inside its frame and never comes with the frame's end.
  always_ff @(posedge clk_i) begin
    if (rst_ni && vertex_valid_o) begin
      assert (!end_valid_o);
      assert (vertex_x_o >= 12'd2 && vertex_y_o >= 12'd2);
    end
  end
endmodule
