// SPDX-License-Identifier: Apache-2.0
//
// Where a stream of row slots stands: column, and how the rows around it belong to frames.
//
// A row slot is one row of the frame's width, real or void (void rows only push real ones
// through). Each beat belongs to one column of one slot; beats of a slot may have gaps. The beat
// of column c, row r completes the window of pixels (c-4 .. c, r-4 .. r) with centre (c-2, r-2).
//
//   slot in   valid_i, sol_i (column 0); sof_i (row is the first of a frame), real_i and fault_i
//             (how the frame before this row ended, 0 = clean) count at sol_i
//   col_o     column of the beat, in the same clock;  valid1_o, col1_o  one clock later
//   centre, two clocks later   valid_o, sol_o, eol_o (first, last column), sof_o, real_o, fault_o
//             of its slot; inside_o: the whole window lies in one frame (the border rule)
//   tail, two clocks later     tail_sol_o .. tail_fault_o: the slot stream of row r - TailRows
//   end_o     (two clocks later) first beat behind a frame's last row; end_fault_o how it ended
//
// 1 beat per clock. The last two columns of a centre row come out with the first two beats of the
// next slot; they are border.
module slot_tracker #(
    parameter int MaxWidthPx = 1920,  // longest row, px
    parameter int TailRows   = 4      // 4 .. 12
) (
    input  logic                          clk_i,
    input  logic                          rst_ni,
    input  logic                          valid_i,
    input  logic                          sol_i,
    input  logic                          sof_i,
    input  logic                          real_i,
    input  logic [                   1:0] fault_i,
    output logic [$clog2(MaxWidthPx)-1:0] col_o,
    output logic                          valid1_o,
    output logic [$clog2(MaxWidthPx)-1:0] col1_o,
    output logic                          valid_o,
    output logic                          sol_o,
    output logic                          eol_o,
    output logic                          sof_o,
    output logic                          real_o,
    output logic [                   1:0] fault_o,
    output logic                          inside_o,
    output logic                          tail_sol_o,
    output logic                          tail_sof_o,
    output logic                          tail_real_o,
    output logic [                   1:0] tail_fault_o,
    output logic                          end_o,
    output logic [                   1:0] end_fault_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080 || TailRows < 4 || TailRows > 12) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080_TailRows_4_to_12 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  // Clock 0: the column; attributes {real, sof, fault} of the last rows, newest in the low bits.
  logic [ColBits-1:0] next_col_q;
  logic sol1_q;
  logic [4*(TailRows+1)-1:0] rows_q;
  assign col_o = sol_i ? '0 : next_col_q;

  always_ff @(posedge clk_i) begin
    valid1_o <= rst_ni && valid_i;
    sol1_q   <= sol_i;
    col1_o   <= col_o;
    if (valid_i) next_col_q <= col_o + ColBits'(1);
    if (!rst_ni) begin
      rows_q <= '0;
    end else if (valid_i && sol_i) begin
      rows_q <= {rows_q[4*TailRows-1:0], real_i, real_i && sof_i, fault_i};
    end
  end

  // Clock 1: rows r-4 .. r are one frame's if all are real and none but the oldest is a first row.
  logic rows_inside;
  logic [3:0] centre_q;
  assign rows_inside = rows_q[3] && rows_q[7] && rows_q[11] && rows_q[15] && rows_q[19] &&
                       !rows_q[2] && !rows_q[6] && !rows_q[10] && !rows_q[14];
  assign {real_o, sof_o, fault_o} = centre_q;

  always_ff @(posedge clk_i) begin
    valid_o     <= rst_ni && valid1_o;
    sol_o       <= col1_o == ColBits'(2);
    eol_o       <= col1_o == ColBits'(1);
    inside_o    <= rows_inside && |col1_o[ColBits-1:2];
    end_o       <= sol1_q && rows_q[7] && (!rows_q[3] || rows_q[2]);
    end_fault_o <= rows_q[1:0];
    tail_sol_o  <= sol1_q;
    {tail_real_o, tail_sof_o, tail_fault_o} <= rows_q[4*TailRows+:4];
    if (!rst_ni) centre_q <= '0;
    else if (valid1_o && col1_o == ColBits'(2)) centre_q <= rows_q[11:8];
  end

  // A whole window's centre is real and neither first nor last in its row.
  always_ff @(posedge clk_i) begin
    if (rst_ni && valid_o && inside_o) begin
      assert (real_o && !sol_o && !eol_o);
    end
  end
endmodule
