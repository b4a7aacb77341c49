// SPDX-License-Identifier: Apache-2.0
//
// slot_tracker for any stream of row slots (slot_stream): the centre stream is the same rows two
// rows and two columns later, again a stream of row slots; inside_o is the border rule, in_row_o the row's own
// columns, eol_o the last of them, end_o the first beat behind a frame; the tail stream is TailRows rows behind.
module slot_tracker_properties #(
    parameter int TailRows = 6
) (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       valid,
    input logic       sol,
    input logic       sof,
    input logic       is_real,
    input logic [1:0] fault,
    input logic [1:0] change,
    input logic [2:0] new_width
);
  localparam int MaxWidthPx = 6;
  localparam int Voids = TailRows;  // of the input; two rows fewer behind the centre

  logic started;
  logic [5:0] width, width1_q, width2_q, before_last;
  logic [2:0] in_col, col;
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
      .width_o(width),
      .before_last_o(before_last),
      .kind_o(),
      .col_o(in_col),
      .in_row_o()
  );

  logic centre_valid, centre_sol, centre_eol, centre_sof, centre_real, in_row, inside, ends;
  logic tail_sol, tail_sof, tail_real;
  logic [1:0] centre_fault, tail_fault, end_fault;
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx),
      .TailRows  (TailRows),
      .Limited   (1'b1)
  ) dut (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(fault),
      .within_i(1'b0),
      .before_last_i(before_last),
      .col_o(col),
      .valid1_o(),
      .col1_o(),
      .valid_o(centre_valid),
      .sol_o(centre_sol),
      .eol_o(centre_eol),
      .sof_o(centre_sof),
      .real_o(centre_real),
      .fault_o(centre_fault),
      .in_row_o(in_row),
      .inside_o(inside),
      .tail_sol_o(tail_sol),
      .tail_sof_o(tail_sof),
      .tail_real_o(tail_real),
      .tail_fault_o(tail_fault),
      .end_o(ends),
      .end_fault_o(end_fault)
  );

  // The rows so far, {real, sof, fault}, newest in the low bits; the current beat's included.
  logic [4*(TailRows+1)-1:0] rows, rows_q, rows1_q, rows2_q;
  logic valid1_q, valid2_q, sol1_q, sol2_q;
  assign rows = sol ? {rows_q[4*TailRows-1:0], is_real, sof, fault} : rows_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) rows_q <= '0;
    else if (valid) rows_q <= rows;
    {valid2_q, valid1_q} <= rst_ni ? {valid1_q, valid} : '0;
    {sol2_q, sol1_q} <= {sol1_q, sol};
    {rows2_q, rows1_q} <= {rows1_q, rows};
    {width2_q, width1_q} <= {width1_q, width};
  end

  logic centre_ok, tail_ok;
  logic [1:0] kind;
  logic [2:0] x, centre_width, tail_x;
  slot_stream #(
      .Voids(Voids - 2)
  ) centre (
      .clk_i,
      .rst_ni,
      .width_i(width2_q),
      .valid_i(centre_valid),
      .sol_i(centre_sol),
      .sof_i(centre_sof),
      .real_i(centre_real),
      .ok_o(centre_ok),
      .kind_o(kind),
      .col_o(x),
      .age_o(),
      .may_change_o()
  );
  slot_stream #(
      .Voids(Voids - TailRows)
  ) tail (
      .clk_i,
      .rst_ni,
      .width_i(width2_q),
      .valid_i(centre_valid),
      .sol_i(tail_sol),
      .sof_i(tail_sof),
      .real_i(tail_real),
      .ok_o(tail_ok),
      .kind_o(),
      .col_o(tail_x),
      .age_o(),
      .may_change_o()
  );
  assign centre_width = kind[1] ? width2_q[5:3] : width2_q[2:0];

  always_ff @(posedge clk_i) begin
    if (started && rst_ni) begin
      assert (!valid || rows[3:2] == '0 || col == in_col);
      assert (centre_valid == valid2_q);
      if (centre_valid) begin
        assert (centre_ok && tail_ok);
        assert (tail_sol == sol2_q);
        assert ({tail_real, tail_sof, tail_fault} == rows2_q[4*TailRows+:4]);
        if (centre_sol) assert ({centre_real, centre_sof, centre_fault} == rows2_q[11:8]);
        if (kind != 2'd0) begin
          assert (in_row == (x < centre_width));
          assert (centre_eol == (x == centre_width - 3'd1));
          // The window is in the frame: two columns and two rows of it on each side.
          assert (inside == (x > 3'd1 && x < centre_width - 3'd2 && rows2_q[3] && rows2_q[7] &&
                             rows2_q[11] && rows2_q[15] && |rows2_q[19:18] && !rows2_q[2] &&
                             !rows2_q[6] && !rows2_q[10] && !rows2_q[14]));
        end else begin
          assert (!inside);
        end
        assert (ends == (sol2_q && |rows2_q[7:6] && (!rows2_q[3] || rows2_q[2])));
        if (ends) assert (end_fault == rows2_q[1:0]);
      end
    end
  end
endmodule
