// SPDX-License-Identifier: Apache-2.0
//
// The neighbourhood of every pixel of a stream of row slots, from one line memory.
//
//   slot in    see slot_tracker; one clock behind it data_i, one pixel, and side_i, what only the
//              centre needs
//   column_o   the newest column straight from the memory, oldest row in the low bits, in the
//              clocks with column_valid_o: for a kernel that keeps its own column sums
//   window_o   one clock later, five columns; pixel (column i, row j) at bit (Rows i + j) Width,
//              oldest first
//   centre     in step with window_o, two rows and columns back: side_o, valid_o .. inside_o, see
//              slot_tracker
//   tail_*     in step with window_o, the slot stream Rows - 5 rows back: for a second tracker
//              of the five oldest rows
//   end_*      see slot_tracker
//
// Latency 2 clocks and 2 rows + 2 columns to the centre; 1 beat per clock.
module line_window #(
    parameter int Width      = 8,    // bits per pixel
    parameter int SideWidth  = 0,    // bits per pixel that only the centre needs
    parameter int SideRows   = 2,    // rows the side data wait: 2, or 0 if they come two rows late
    parameter int Rows       = 5,    // 5, 9 .. 17
    parameter int MaxWidthPx = 1920, // longest row, px
    parameter bit Limited    = 1'b0  // see slot_tracker
) (
    input  logic                                 clk_i,
    input  logic                                 rst_ni,
    input  logic                                 valid_i,
    input  logic                                 sol_i,
    input  logic                                 sof_i,
    input  logic                                 real_i,
    input  logic [                          1:0] fault_i,
    input  logic                                 within_i,
    input  logic [     2*$clog2(MaxWidthPx)-1:0] before_last_i,
    input  logic [                    Width-1:0] data_i,
    input  logic [(SideWidth>0?SideWidth:1)-1:0] side_i,
    output logic                                 column_valid_o,
    output logic [               Rows*Width-1:0] column_o,
    output logic [             5*Rows*Width-1:0] window_o,
    output logic [(SideWidth>0?SideWidth:1)-1:0] side_o,
    output logic                                 valid_o,
    output logic                                 sol_o,
    output logic                                 eol_o,
    output logic                                 sof_o,
    output logic                                 real_o,
    output logic [                          1:0] fault_o,
    output logic                                 in_row_o,
    output logic                                 inside_o,
    output logic                                 tail_sol_o,
    output logic                                 tail_sof_o,
    output logic                                 tail_real_o,
    output logic [                          1:0] tail_fault_o,
    output logic                                 end_o,
    output logic [                          1:0] end_fault_o
);
  if (Width < 1 || SideWidth < 0 || !(SideRows == 0 || SideRows == 2) ||
      !(Rows == 5 || (Rows >= 9 && Rows <= 17))) begin : gen_illegal
    illegal_Width_at_least_1_SideWidth_at_least_0_SideRows_0_or_2_Rows_5_or_9_to_17 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);
  localparam int OlderWidth = (Rows - 1) * Width;
  localparam int MemoryWidth = OlderWidth + SideRows * SideWidth;

  logic valid1;
  logic [ColBits-1:0] col, col1;
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx),
      .TailRows  (Rows == 5 ? 4 : Rows - 5),
      .Limited   (Limited)
  ) i_tracker (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i,
      .before_last_i,
      .col_o(col),
      .valid1_o(valid1),
      .col1_o(col1),
      .valid_o,
      .sol_o,
      .eol_o,
      .sof_o,
      .real_o,
      .fault_o,
      .in_row_o,
      .inside_o,
      .tail_sol_o,
      .tail_sof_o,
      .tail_real_o,
      .tail_fault_o,
      .end_o,
      .end_fault_o
  );

  // Clock 0: the column's older pixels are read, oldest in the low bits; clock 1: written back
  // with the new one in place of the oldest.
  logic [MemoryWidth-1:0] memory_in, memory_out;
  assign memory_in[OlderWidth-1:0] = {data_i, memory_out[OlderWidth-1:Width]};

  line_memory #(
      .Width(MemoryWidth),
      .Depth(MaxWidthPx)
  ) i_rows (
      .clk_i,
      .wen_i  (valid1),
      .waddr_i(col1),
      .wdata_i(memory_in),
      .raddr_i(col),
      .rdata_o(memory_out)
  );

  // Side data wait in the memory and two columns in registers.
  if (SideWidth > 0) begin : gen_side
    logic [SideWidth-1:0] side2_q, side3_q, side_late;
    if (SideRows == 2) begin : gen_rows
      assign memory_in[MemoryWidth-1:OlderWidth] = {side_i, memory_out[MemoryWidth-1-:SideWidth]};
      assign side_late = memory_out[OlderWidth+:SideWidth];
    end else begin : gen_no_rows
      assign side_late = side_i;
    end
    always_ff @(posedge clk_i) begin
      if (valid1) begin
        side2_q <= side_late;
        side3_q <= side2_q;
        side_o  <= side3_q;
      end
    end
  end else begin : gen_no_side
    logic unused;
    assign unused = side_i;
    assign side_o = 1'b0;
  end

  // Clock 1: the new column joins the window.
  assign column_valid_o = valid1;
  assign column_o = {data_i, memory_out[OlderWidth-1:0]};
  always_ff @(posedge clk_i) begin
    if (valid1) window_o <= {column_o, window_o[5*Rows*Width-1:Rows*Width]};
  end

  // The window moves exactly with the beats.
  logic moved_q;
  always_ff @(posedge clk_i) begin
    moved_q <= rst_ni && valid1;
    if (rst_ni) assert (valid_o == moved_q);
  end
endmodule
