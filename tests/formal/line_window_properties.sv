// SPDX-License-Identifier: Apache-2.0
//
// line_window for any stream of row slots, any pauses: an arbitrary pixel is watched, and wherever it
// must be seen it is: in the newest column of each of the Rows - 1 rows that follow, in each of the
// window's places as the columns pass, and its side data with the centre. Proved for every pixel,
// that is the whole window: all its pixels are the right neighbours.
//
// A pixel counts as long as the current row is a row of its frame, which is what inside_o asks of
// every pixel of a window.
module line_window_properties #(
    parameter int Rows = 5,
    parameter int SideRows = 2
) (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       valid,
    input logic       sol,
    input logic       sof,
    input logic       is_real,
    input logic [1:0] change,
    input logic [2:0] new_width,
    input logic       data,
    input logic       side,
    input logic       watch
);
  localparam int MaxWidthPx = 6;
  localparam int Voids = 2;  // the fewest void rows that any stage is told of a change of width

  logic started, in_row;
  logic [1:0] kind;
  logic [2:0] col;
  assumed_slots #(
      .Voids(Voids)
  ) in (
      .clk_i,
      .rst_ni,
      .change_i(change),
      .new_width_i(new_width),
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .started_o(started),
      .width_o(),
      .before_last_o(),
      .kind_o(kind),
      .col_o(col),
      .in_row_o(in_row)
  );

  // Pixels and side data come one clock behind their slot.
  logic data1_q, side1_q;
  always_ff @(posedge clk_i) {data1_q, side1_q} <= {data, side};

  logic column_valid, side_out;
  logic [Rows-1:0] column;
  logic [5*Rows-1:0] window;
  line_window #(
      .Width     (1),
      .SideWidth (1),
      .SideRows  (SideRows),
      .Rows      (Rows),
      .MaxWidthPx(MaxWidthPx)
  ) dut (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(2'd0),
      .within_i(1'b1),
      .before_last_i(6'd0),
      .data_i(data1_q),
      .side_i(side1_q),
      .column_valid_o(column_valid),
      .column_o(column),
      .window_o(window),
      .side_o(side_out),
      .valid_o(),
      .sol_o(),
      .eol_o(),
      .sof_o(),
      .real_o(),
      .fault_o(),
      .in_row_o(),
      .inside_o(),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  // The watched pixel; rows since, whether the current row is one of its frame. Its side data are due
  // two beats behind the second visit of its column since, where they wait two rows, or behind itself.
  logic watched_q, same_q, now, same, data_q, side_q, visit;
  logic [3:0] rows_q, rows, visits_q, visits;
  logic [2:0] col_q;
  logic [1:0] side_beats_q, side_beats;
  assign now  = valid && watch && !watched_q && in_row;
  assign rows = now ? 4'd0 : rows_q + 4'(sol && rows_q != 4'd15);
  assign same = now || (watched_q && same_q && !(sol && (kind == 2'd0 || sof)));
  assign visit  = now || (watched_q && col == col_q);
  assign visits = now ? 4'd0 : visits_q + 4'(visit && visits_q != 4'd15);
  assign side_beats = visit && visits == 4'(SideRows) ? 2'd0
                      : side_beats_q == 2'd3 ? 2'd3 : side_beats_q + 2'd1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      watched_q <= 1'b0;
      side_beats_q <= 2'd3;
    end else if (valid) begin
      watched_q <= watched_q || now;
      {same_q, rows_q, visits_q, side_beats_q} <= {same, rows, visits, side_beats};
    end
    if (now) {data_q, side_q, col_q} <= {data, side, col};
  end

  // What the newest beat must show, one clock later in column_o, from two clocks later until the next
  // beat in window_o: places behind the newest column count down the columns.
  logic seen, seen1_q, seen2_q, valid1_q, due1_q, due2_q;
  logic [3:0] row1_q, row2_q;
  logic [2:0] back, back1_q, back2_q;
  assign back = col - (now ? col : col_q);
  assign seen = same && rows < 4'(Rows) && col >= (now ? col : col_q) && back < 3'd5;
  logic [5*Rows-1:0] place;
  assign place = window >> (Rows * (4 - 32'(back2_q)) + (Rows - 1) - 32'(row2_q));
  always_ff @(posedge clk_i) begin
    valid1_q <= rst_ni && valid;
    {row1_q, back1_q, seen1_q, due1_q} <= {rows, back, seen, side_beats == 2'd2};
    if (!rst_ni) {seen2_q, due2_q} <= '0;
    else if (valid1_q) {seen2_q, due2_q, row2_q, back2_q} <= {seen1_q, due1_q, row1_q, back1_q};
    if (started && rst_ni) begin
      if (valid1_q && seen1_q && back1_q == '0) begin
        assert (column_valid && column[(Rows-1)-32'(row1_q)] == data_q);
      end
      if (seen2_q) assert (place[0] == data_q);
      if (due2_q) assert (side_out == side_q);
    end
  end
endmodule
