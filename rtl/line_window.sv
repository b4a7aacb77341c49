// SPDX-License-Identifier: Apache-2.0
//
// The 5x5 neighbourhood of every pixel of a stream of row slots.
//
// A row slot is one row of the frame's width, real or void (void rows only push real ones
// through). Each beat belongs to one column of one slot; beats of a slot may have gaps. For
// the beat of column c, row r the window is pixels (c-4 .. c, r-4 .. r), its centre (c-2, r-2).
//
//   slot in    valid_i, sol_i (column 0), data_i; sof_i (row is the first of a frame), real_i
//              and fault_i (how the frame before this row ended, 0 = clean) count at sol_i
//   window_o   the newest Columns columns of the window: pixel (column i, row j) at bit
//              (5 i + j) Width, oldest first
//   centre     valid_o, sol_o, eol_o (first, last column), sof_o, real_o, fault_o of its slot;
//              inside_o: the whole window lies in one frame (the border rule)
//   tail       the stream of row r-4, column c: input of a second window below this one
//   bottom     how the newest row relates to its frame: end_o marks the first beat behind a
//              frame's last row, end_fault_o how that frame ended
//
// Latency 2 clocks and 2 rows + 2 columns to the centre; 1 beat per clock. The last two columns
// of a centre row come out with the first two beats of the next slot; they are border.
module line_window #(
    parameter int Width      = 8,    // bits per pixel
    parameter int Columns    = 5,    // 1 .. 5, for a kernel that keeps its own column sums
    parameter int MaxWidthPx = 1920  // longest row, px
) (
    input  logic                clk_i,
    input  logic                rst_ni,
    input  logic                valid_i,
    input  logic                sol_i,
    input  logic                sof_i,
    input  logic                real_i,
    input  logic [         1:0] fault_i,
    input  logic [   Width-1:0] data_i,
    output logic [5*Columns*Width-1:0] window_o,
    output logic                valid_o,
    output logic                sol_o,
    output logic                eol_o,
    output logic                sof_o,
    output logic                real_o,
    output logic [         1:0] fault_o,
    output logic                inside_o,
    output logic                tail_sol_o,
    output logic                tail_sof_o,
    output logic                tail_real_o,
    output logic [         1:0] tail_fault_o,
    output logic [   Width-1:0] tail_data_o,
    output logic                end_o,
    output logic [         1:0] end_fault_o
);
  if (Width < 1 || Columns < 1 || Columns > 5 || MaxWidthPx < 5 ||
      MaxWidthPx > 4080) begin : gen_illegal
    illegal_Width_at_least_1_Columns_1_to_5_MaxWidthPx_5_to_4080 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  // Clock 0: the column's four older pixels are read, oldest in the low bits.
  logic [ColBits-1:0] next_col_q, col, col1_q;
  logic               valid1_q, sol1_q;
  logic [  Width-1:0] data1_q;
  logic [4*Width-1:0] older;
  // Row attributes {real, sof, fault}, newest row first.
  logic [3:0] row0_q, row1_q, row2_q, row3_q, row4_q, centre_q;

  assign col = sol_i ? '0 : next_col_q;

  always_ff @(posedge clk_i) begin
    valid1_q <= rst_ni && valid_i;
    sol1_q   <= sol_i;
    col1_q   <= col;
    data1_q  <= data_i;
    if (valid_i) next_col_q <= col + ColBits'(1);
    if (!rst_ni) begin
      {row0_q, row1_q, row2_q, row3_q, row4_q} <= '0;
    end else if (valid_i && sol_i) begin
      row0_q <= {real_i, real_i && sof_i, fault_i};
      row1_q <= row0_q;
      row2_q <= row1_q;
      row3_q <= row2_q;
      row4_q <= row3_q;
    end
  end

  line_memory #(
      .Width(4 * Width),
      .Depth(MaxWidthPx)
  ) i_rows (
      .clk_i,
      .wen_i  (valid1_q),
      .waddr_i(col1_q),
      .wdata_i({data1_q, older[4*Width-1:Width]}),
      .raddr_i(col),
      .rdata_o(older)
  );

  // Clock 1: the new column joins the window. Rows r-4 .. r are one frame's if all are real and
  // none but the oldest is a first row.
  logic rows_inside;
  assign rows_inside = row0_q[3] && row1_q[3] && row2_q[3] && row3_q[3] && row4_q[3] &&
                       !row0_q[2] && !row1_q[2] && !row2_q[2] && !row3_q[2];

  logic [3:0] tail_q;
  assign {real_o, sof_o, fault_o} = centre_q;
  assign {tail_real_o, tail_sof_o, tail_fault_o} = tail_q;
  assign tail_data_o = window_o[5*(Columns-1)*Width+:Width];

  always_ff @(posedge clk_i) begin
    valid_o    <= rst_ni && valid1_q;
    tail_sol_o <= sol1_q;
    tail_q     <= row4_q;
    sol_o      <= col1_q == ColBits'(2);
    eol_o      <= col1_q == ColBits'(1);
    inside_o   <= rows_inside && (col1_q > ColBits'(3));
    end_o      <= sol1_q && row1_q[3] && (!row0_q[3] || row0_q[2]);
    end_fault_o <= row0_q[1:0];
    if (!rst_ni) centre_q <= '0;
    else if (valid1_q && col1_q == ColBits'(2)) centre_q <= row2_q;
  end

  if (Columns == 1) begin : gen_column
    always_ff @(posedge clk_i) if (valid1_q) window_o <= {data1_q, older};
  end else begin : gen_window
    always_ff @(posedge clk_i) begin
      if (valid1_q) window_o <= {data1_q, older, window_o[5*Columns*Width-1:5*Width]};
    end
  end

  // Every window follows a beat by two clocks, in step with it.
  logic valid_past_q;
  always_ff @(posedge clk_i) begin
    valid_past_q <= rst_ni && valid1_q;
    if (rst_ni) begin
      assert (valid_o == valid_past_q);
      assert (!(valid_o && inside_o) || (real_o && !sol_o && !eol_o));
    end
  end
endmodule
