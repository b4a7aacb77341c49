// SPDX-License-Identifier: Apache-2.0
//
// Where a stream of row slots stands: column, and how the rows around it belong to frames.
//
// A row slot is one row, real or void (void rows only push real ones through). It has a beat for each
// column of its frame, or more while a wider frame is on its way: what lies beyond the row belongs to no
// frame. Beats of a slot may have gaps. Two frame widths may be on their way at a time.
// {real, sof}: 0 void row, 2 row of a frame, 3 and 1 first row of a frame of the first and second width.
//
// The beat of column c, row r completes the window of pixels (c-4 .. c, r-4 .. r) with centre (c-2, r-2).
//
//   slot in   valid_i, sol_i (column 0); sof_i (row is the first of a frame), real_i and fault_i
//             (how the frame before this row ended, 0 = clean) count at sol_i
//   within_i  one clock later: the beat's column belongs to its row (row_limit), for inside_o; if Limited
//             it is found here, for the centre's row, from before_last_i: both widths - 2, first in the low bits
//   col_o     column of the beat, in the same clock;  valid1_o, col1_o  one clock later
//   centre, two clocks later   valid_o, sol_o, eol_o (first, last column), sof_o, real_o, fault_o
//             of its slot; in_row_o: it belongs to its row; inside_o: the whole window lies in one frame
//             (the border rule)
//   tail, two clocks later     tail_sol_o .. tail_fault_o: the slot stream of row r - TailRows
//   end_o     (two clocks later) first beat behind a frame's last row; end_fault_o how it ended
//
// 1 beat per clock. The last two columns of a centre row come out with the first two beats of the
// next slot; they are border.
module slot_tracker #(
    parameter int MaxWidthPx = 1920,  // longest row, px
    parameter int TailRows   = 4,     // 4 .. 12
    parameter bit Limited    = 1'b0   // rows may be shorter than their slots, see before_last_i
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            valid_i,
    input  logic                            sol_i,
    input  logic                            sof_i,
    input  logic                            real_i,
    input  logic [                     1:0] fault_i,
    input  logic                            within_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    output logic [  $clog2(MaxWidthPx)-1:0] col_o,
    output logic                            valid1_o,
    output logic [  $clog2(MaxWidthPx)-1:0] col1_o,
    output logic                            valid_o,
    output logic                            sol_o,
    output logic                            eol_o,
    output logic                            sof_o,
    output logic                            real_o,
    output logic [                     1:0] fault_o,
    output logic                            in_row_o,
    output logic                            inside_o,
    output logic                            tail_sol_o,
    output logic                            tail_sof_o,
    output logic                            tail_real_o,
    output logic [                     1:0] tail_fault_o,
    output logic                            end_o,
    output logic [                     1:0] end_fault_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080 || TailRows < 4 || TailRows > 12) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080_TailRows_4_to_12 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  // Clock 0: the column; attributes {real, sof, fault} of the last rows, newest in the low bits.
  logic [ColBits-1:0] next_col_q;
  logic sol1_q, third1_q;  // clock 1: columns 0 and 2
  logic [4*(TailRows+1)-1:0] rows_q;
  assign col_o = sol_i ? '0 : next_col_q;

  always_ff @(posedge clk_i) begin
    valid1_o <= rst_ni && valid_i;
    sol1_q   <= sol_i;
    third1_q <= !sol_i && next_col_q == ColBits'(2);
    col1_o   <= col_o;
    if (valid_i) next_col_q <= col_o + ColBits'(1);
    if (!rst_ni) begin
      rows_q <= '0;
    end else if (valid_i && sol_i) begin
      rows_q <= {rows_q[4*TailRows-1:0], real_i, sof_i, fault_i};
    end
  end

  // Clock 1: rows r-4 .. r are one frame's if all are real and none but the oldest is a first row.
  logic rows_inside;
  logic [3:0] centre_q;
  assign rows_inside = rows_q[3] && rows_q[7] && rows_q[11] && rows_q[15] && |rows_q[19:18] &&
                       !rows_q[2] && !rows_q[6] && !rows_q[10] && !rows_q[14];
  assign {real_o, sof_o, fault_o} = centre_q;

  always_ff @(posedge clk_i) begin
    valid_o     <= rst_ni && valid1_o;
    sol_o       <= third1_q;
    eol_o       <= within3_q && (!within2_q || col1_o == ColBits'(1));
    in_row_o    <= within3_q;
    inside_o    <= rows_inside && |col1_o[ColBits-1:2] && column_in_row;
    end_o       <= sol1_q && |rows_q[7:6] && (!rows_q[3] || rows_q[2]);
    end_fault_o <= rows_q[1:0];
    tail_sol_o  <= sol1_q;
    {tail_real_o, tail_sof_o, tail_fault_o} <= rows_q[4*TailRows+:4];
    if (!rst_ni) centre_q <= '0;
    else if (valid1_o && third1_q) centre_q <= rows_q[11:8];
  end

  // Clock 1: whether the newest column belongs to its row, and those one and two before.
  logic column_in_row, within2_q, within3_q;
  always_ff @(posedge clk_i) begin
    if (valid1_o) {within3_q, within2_q} <= {within2_q, column_in_row};
  end
  if (Limited) begin : gen_limited
    logic second_width_q;  // of the centre row's frame
    row_limit #(
        .ColBits(ColBits)
    ) i_limit (
        .clk_i,
        .valid_i(valid1_o),
        .sol_i(sol1_q),
        .col_i(col1_o),
        .before_last_i,
        .second_i(second_width_q),
        .within_o(column_in_row)
    );
    always_ff @(posedge clk_i) begin
      if (!rst_ni) second_width_q <= 1'b0;
      else if (valid1_o && sol1_q && rows_q[10]) second_width_q <= !rows_q[11];
    end
    logic unused;
    assign unused = within_i;
  end else begin : gen_given
    assign column_in_row = within_i;
    logic unused;
    assign unused = ^before_last_i;
  end

  // A whole window's centre is real and neither first nor last in its row.
  always_ff @(posedge clk_i) begin
    if (rst_ni && valid_o && inside_o) begin
      assert ((real_o || sof_o) && !sol_o && !eol_o);
    end
  end
endmodule
