// SPDX-License-Identifier: Apache-2.0
//
// Stage 4, second window: the vertices, where the vertex value is the largest of its 5x5 window.
//
// A value must be above those before it in raster order and not below those after it. Per row only
// the maximum of five columns is kept; a value that leads its own row and the two rows above waits
// for the two rows below:
//
//   h(x, y) = max s(x-2 .. x+2, y)
//   alive(x, y) = s > s(x-2), s(x-1), h(x, y-1), h(x, y-2) and s >= s(x+1), s(x+2)
//   vertex(x, y-2) = alive(x, y-2) and h(x, y-2) >= h(x, y-1), h(x, y);  there h is s itself
//
//   slot in    see slot_tracker; strength_i, above_i see vertex_value
//   vertex_*   in raster order, coordinates in px; branches and pattern are found once more, from
//              one bit per pixel, instead of waiting two rows
//   end_valid_o, end_fault_o   behind the last vertex of a frame; how the frame ended
//
// Latency 2 rows + 2 columns + 9 clocks, 1 beat per clock. Border: candidates have strength 0.
module vertex_peak #(
    parameter int MaxWidthPx = 1920
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic        valid_i,
    input  logic        sol_i,
    input  logic        sof_i,
    input  logic        real_i,
    input  logic [ 1:0] fault_i,
    input  logic [ 5:0] strength_i,
    input  logic [ 2:0] above_i,
    output logic        vertex_valid_o,
    output logic [11:0] vertex_x_o,
    output logic [11:0] vertex_y_o,
    output logic [ 3:0] vertex_branches_o,
    output logic [ 7:0] vertex_pattern_o,
    output logic [ 7:0] vertex_strength_o,
    output logic        end_valid_o,
    output logic [ 1:0] end_fault_o
);
  localparam int ColBits = $clog2(MaxWidthPx);

  // Clocks 1-4: the row.
  logic [5*6-1:0] s_q;
  logic [5:0] before_q, after_q, centre2_q, others_q, centre3_q, highest_q;
  logic leads3_q, leads4_q;
  always_ff @(posedge clk_i) begin
    if (valid_i) s_q <= {s_q[23:0], strength_i};
    before_q  <= s_q[29:24] > s_q[23:18] ? s_q[29:24] : s_q[23:18];
    after_q   <= s_q[11:6] > s_q[5:0] ? s_q[11:6] : s_q[5:0];
    centre2_q <= s_q[17:12];

    others_q  <= before_q > after_q ? before_q : after_q;
    leads3_q  <= centre2_q > before_q && centre2_q >= after_q;
    centre3_q <= centre2_q;

    highest_q <= leads3_q ? centre3_q : others_q;
    leads4_q  <= leads3_q;
  end

  // The tracker runs three clocks behind: the rows above come out of the memory at clock 4.
  logic valid, sol, sof, is_real, valid_end, in_frame, valid4, is_end;
  logic [1:0] fault, end_fault;
  logic [ColBits-1:0] col, col4, col5_q;
  delay_line #(
      .Width (6),
      .Clocks(3)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .data_i({valid_i, sol_i, sof_i, real_i, fault_i}),
      .data_o({valid, sol, sof, is_real, fault})
  );
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx)
  ) i_tracker (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(fault),
      .col_o(col),
      .valid1_o(valid4),
      .col1_o(col4),
      .valid_o(valid_end),
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
      .end_o(is_end),
      .end_fault_o(end_fault)
  );

  // Clock 5: per column {branch pixel, alive, highest} of the last two rows, older in the low bits.
  logic [2:0] above4;
  logic [15:0] rows_q;
  logic [5:0] highest1, highest2;
  logic alive1, alive2, above1, above2, vertex_q, valid5_q;
  delay_line #(
      .Width (3),
      .Clocks(4)
  ) i_above (
      .clk_i,
      .rst_ni,
      .data_i(above_i),
      .data_o(above4)
  );
  line_memory #(
      .Width(16),
      .Depth(MaxWidthPx)
  ) i_rows (
      .clk_i,
      .wen_i  (valid5_q),
      .waddr_i(col5_q),
      .wdata_i(rows_q),
      .raddr_i(col),
      .rdata_o({above1, alive1, highest1, above2, alive2, highest2})
  );
  logic [5:0] strength5_q;
  always_ff @(posedge clk_i) begin
    valid5_q <= rst_ni && valid4;
    col5_q   <= col4;
    rows_q   <= {above4[0], leads4_q && highest_q > highest1 && highest_q > highest2, highest_q,
                 above1, alive1 && highest1 >= highest_q, highest1};
    vertex_q    <= alive2 && highest2 >= highest_q;
    strength5_q <= highest2;
  end

  // Clocks 5-8: the branches around the centre. Everything else waits for them.
  logic [3:0] branches;
  logic [7:0] pattern;
  vertex_ring i_ring (
      .clk_i,
      .valid_i(valid4),
      .column_i({above4, above1, above2}),
      .above_o(),
      .group_o(),
      .low_o(),
      .high_o(),
      .branches_o(branches),
      .pattern_o(pattern),
      .junction_o()
  );
  logic sol4_q, sof4_q, valid7, sol7, sof7, vertex8, end8;
  logic [5:0] strength8;
  logic [1:0] end_fault8;
  delay_line #(
      .Width (3),
      .Clocks(3)
  ) i_position (
      .clk_i,
      .rst_ni,
      .data_i({valid4, sol4_q, sof4_q}),
      .data_o({valid7, sol7, sof7})
  );
  delay_line #(
      .Width (10),
      .Clocks(3)
  ) i_vertex (
      .clk_i,
      .rst_ni,
      .data_i({valid_end && in_frame && vertex_q, strength5_q, valid_end && is_end, end_fault}),
      .data_o({vertex8, strength8, end8, end_fault8})
  );

  // Clocks 8, 9: position of the centre, strength in full.
  logic [11:0] x_q, y_q;
  always_ff @(posedge clk_i) begin
    {sol4_q, sof4_q} <= {sol, sof};
    if (valid7) begin
      x_q <= sol7 ? -12'd2 : x_q + 12'd1;
      if (sol7) y_q <= sof7 ? -12'd2 : y_q + 12'd1;
    end
    vertex_valid_o    <= rst_ni && vertex8;
    vertex_x_o        <= x_q;
    vertex_y_o        <= y_q;
    vertex_branches_o <= branches;
    vertex_pattern_o  <= pattern;
    vertex_strength_o <= strength8 >= 6'd50 ? {1'b0, strength8, 1'b0} + 8'd12
                       : strength8 >= 6'd41 ? {1'b0, strength8, 1'b0} - 8'd2 : {2'b0, strength8};
    end_valid_o       <= rst_ni && end8;
    end_fault_o       <= end_fault8;
  end

  // A vertex lies inside its frame and never comes with the frame's end.
  always_ff @(posedge clk_i) begin
    if (rst_ni && vertex_valid_o) begin
      assert (!end_valid_o);
      assert (vertex_x_o >= 12'd2 && vertex_y_o >= 12'd2);
    end
  end
endmodule
