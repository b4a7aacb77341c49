// SPDX-License-Identifier: Apache-2.0
//
// When rows that row_slots has sent have left the pipeline: eleven rows and 13 columns later, and some 60
// clocks of arithmetic.
//
//   clear_i   the row that begins is the last of those rows, or with row_i the first behind them
//   row_i     a row behind them begins
//   beat_i    a beat is sent
//   passed_o  eleven rows and 96 beats have passed
//
// An upset of the count is right again with the next clear_i.
module drain_count (
    input  logic clk_i,
    input  logic rst_ni,
    input  logic clear_i,
    input  logic row_i,
    input  logic beat_i,
    output logic passed_o
);
  logic [3:0] rows_q;   // begun, up to 12
  logic [6:0] beats_q;  // from then on, up to 96
  logic far;
  assign far = rows_q[3:2] == 2'b11;
  assign passed_o = beats_q[6:5] == 2'b11;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {rows_q, beats_q} <= '1;
    end else if (clear_i) begin
      {rows_q, beats_q} <= {3'b0, row_i, 7'b0};
    end else begin
      if (row_i && !far) rows_q <= rows_q + 4'd1;
      if (beat_i && far && !passed_o) beats_q <= beats_q + 7'd1;
    end
  end
endmodule
