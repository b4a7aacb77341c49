// SPDX-License-Identifier: Apache-2.0
//
// Column and line of a frame's next pixel, and what they mean for it: facts in registers, worked out
// with the pixel before, so that frame_guard decides about a pixel in a level or two of logic.
//
//   step_i, sof_i, eol_i  a pixel of the frame is taken; commit_i: it ends a whole line
//   begun_i          the frame has its first line
//   load_width_i     the other of two widths becomes that of the line that ended last, and comes in force
//   frame_height_i, hold_i   see frame_guard
//   in_line_o        part of a line is there; else the next pixel is a line's first
//   fits_o           the next pixel may end a line: the first at 5 px, the others at the width
//   must_end_o       the next pixel must end its line: at MaxWidthPx or at the width
//   same_width_o     the next pixel stands in the width's last column
//   before_last_o    width - 2 of the first and of the second width, second_o which one is in force
//   last_row_o       the line that is being received, not the first, is the frame's last by frame_height_i
//   over_max_o       it is one more than MaxHeightPx
//   few_rows_o       the frame has fewer than 5 lines; fifth_o: it has 5 with the one being received
//   height_known_o   frame_height_i was not 0
//
// Facts of a column hold from the clock after the pixel before, those of a line three clocks after the
// line before: lines have 5 columns.
module line_checks #(
    parameter int MaxWidthPx  = 1920,  // longest line, 5 .. 4080 px
    parameter int MaxHeightPx = 1200   // most lines, 5 .. 4095
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            step_i,
    input  logic                            sof_i,
    input  logic                            eol_i,
    input  logic                            commit_i,
    input  logic                            begun_i,
    input  logic                            load_width_i,
    input  logic                            hold_i,
    input  logic [                    11:0] frame_height_i,
    output logic                            in_line_o,
    output logic                            fits_o,
    output logic                            must_end_o,
    output logic                            same_width_o,
    output logic [2*$clog2(MaxWidthPx)-1:0] before_last_o,
    output logic                            second_o,
    output logic                            last_row_o,
    output logic                            over_max_o,
    output logic                            few_rows_o,
    output logic                            fifth_o,
    output logic                            height_known_o
);
  if (MaxWidthPx < 5 || MaxWidthPx > 4080 || MaxHeightPx < 5 || MaxHeightPx > 4095) begin : gen_illegal
    illegal_MaxWidthPx_5_to_4080_MaxHeightPx_5_to_4095 stop ();
  end
  localparam int ColBits = $clog2(MaxWidthPx);

  // Of the next pixel in a line; after a line's last pixel it stays at the width. Like the facts it needs no
  // reset: they count within a frame, and its first pixel sets them.
  logic [ColBits-1:0] col_q;
  logic [ColBits-1:0] limit_q;  // the width in force less 2, in time for column 2
  logic first, goes_on, before_width;
  assign first = sof_i || !in_line_o;
  assign goes_on = !first && !eol_i;
  assign before_width = col_q == limit_q;
  always_ff @(posedge clk_i) begin
    limit_q <= second_o ? before_last_o[ColBits+:ColBits] : before_last_o[ColBits-1:0];
    if (step_i) begin
      in_line_o    <= !eol_i;
      col_q        <= first ? ColBits'(1) : col_q + ColBits'(1);
      same_width_o <= goes_on && before_width;
      must_end_o   <= goes_on && (begun_i ? before_width : col_q == ColBits'(MaxWidthPx - 2));
      // The first line fits once column 3 has been there.
      fits_o       <= goes_on && (begun_i ? before_width && !over_max_o
                                          : fits_o || col_q[1:0] == 2'd3);
    end
    if (!rst_ni) begin
      {second_o, before_last_o} <= '0;
    end else if (load_width_i) begin
      second_o <= !second_o;
      if (second_o) before_last_o[ColBits-1:0] <= col_q - ColBits'(2);
      else before_last_o[ColBits+:ColBits] <= col_q - ColBits'(2);
    end
  end

  logic [11:0] line_q, height_q;  // line: 1 for a frame's first
  logic five_q;
  assign few_rows_o = !five_q;
  always_ff @(posedge clk_i) begin
    if (step_i && sof_i) line_q <= 12'd1;
    else if (commit_i) line_q <= line_q + 12'd1;
    // Not taken back by a start of frame, which ends the frame before.
    if (commit_i) five_q <= begun_i && (five_q || fifth_o);
    fifth_o <= line_q[2:0] == 3'd5;
    if (!rst_ni || (step_i && sof_i && !hold_i)) height_q <= frame_height_i;
    height_known_o <= height_q != '0;
    last_row_o     <= begun_i && height_known_o && line_q == height_q;
    over_max_o     <= line_q == 12'(MaxHeightPx + 1);
  end
endmodule
