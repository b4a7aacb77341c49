// SPDX-License-Identifier: Apache-2.0
//
// Assumes that the input is any stream of row slots (slot_stream) of two widths of 5 or 6 px, which may
// change whenever slot_stream allows, with any pauses and resets at any time; a stream begins with column 0, the
// run with a reset.
//
//   change_i, new_width_i   free: which width changes if it may, and to what
//   started_o        past the first clock: what is asserted holds from here
//   width_o          the two widths, the first in the low bits; before_last_o each less 2
//   kind_o, col_o    as those of slot_stream; in_row_o: the column belongs to a frame's row
module assumed_slots #(
    parameter int Voids = 4
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic [1:0] change_i,
    input  logic [2:0] new_width_i,
    input  logic       valid_i,
    input  logic       sol_i,
    input  logic       sof_i,
    input  logic       real_i,
    output logic       started_o,
    output logic [5:0] width_o,
    output logic [5:0] before_last_o,
    output logic [1:0] kind_o,
    output logic [2:0] col_o,
    output logic       in_row_o
);
  logic started_q = 1'b0;
  logic begun_q, ok;
  logic [1:0] may_change;
  logic [5:0] width_q;
  slot_stream #(
      .Voids(Voids)
  ) i_stream (
      .clk_i,
      .rst_ni,
      .width_i(width_q),
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .ok_o(ok),
      .kind_o,
      .col_o,
      .age_o(),
      .may_change_o(may_change)
  );
  assign started_o = started_q;
  assign width_o = width_q;
  assign before_last_o = {width_q[5:3] - 3'd2, width_q[2:0] - 3'd2};
  assign in_row_o = (kind_o[0] && col_o < width_q[2:0]) || (kind_o[1] && col_o < width_q[5:3]);
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
    assume (ok && (new_width_i == 3'd5 || new_width_i == 3'd6));
    assume (!(kind_o[0] && width_q[2:0] == 3'd2) && !(kind_o[1] && width_q[5:3] == 3'd2));
    assume (!valid_i || (rst_ni && (begun_q || sol_i)));
    begun_q <= rst_ni && (begun_q || valid_i);
    for (int t = 0; t < 2; t++) begin
      if (!rst_ni) width_q[3*t+:3] <= 3'd2;  // as frame_guard's, which no row has
      else if (change_i[t] && may_change[t]) width_q[3*t+:3] <= new_width_i;
    end
  end
endmodule
