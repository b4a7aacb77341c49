// SPDX-License-Identifier: Apache-2.0
//
// drain_count: passed_o says that since clear_i eleven rows have gone by, a twelfth has begun and 96 beats
// have come from then on, and says so in the next clock. Nothing else than clear_i takes it back.
module drain_count_properties (
    input logic clk_i,
    input logic rst_ni,
    input logic clear,
    input logic row,
    input logic beat
);
  logic passed;
  drain_count dut (
      .clk_i,
      .rst_ni,
      .clear_i (clear),
      .row_i   (row),
      .beat_i  (beat),
      .passed_o(passed)
  );

  logic started_q = 1'b0;
  logic [3:0] rows_q;
  logic [6:0] beats_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!started_q) assume (!rst_ni);
    if (!rst_ni) begin
      {rows_q, beats_q} <= {4'd12, 7'd96};
    end else if (clear) begin
      {rows_q, beats_q} <= {3'd0, row, 7'd0};
    end else begin
      if (row && rows_q != 4'd12) rows_q <= rows_q + 4'd1;
      if (beat && rows_q == 4'd12 && beats_q != 7'd96) beats_q <= beats_q + 7'd1;
    end
    if (started_q && rst_ni) assert (passed == (beats_q == 7'd96));
  end

  // What holds inside, so that a proof needs less search: both count the same, but from a reset on.
  (* hierconn *) wire [3:0] \dut.rows_q ;
  (* hierconn *) wire [6:0] \dut.beats_q ;
  always_ff @(posedge clk_i) begin
    if (started_q && rst_ni) begin
      assert (\dut.rows_q == rows_q || (&\dut.rows_q && rows_q == 4'd12));
      assert (\dut.beats_q == beats_q || (&\dut.beats_q && beats_q == 7'd96));
      assert (rows_q <= 4'd12 && (rows_q == 4'd12 || beats_q == '0));
    end
  end
endmodule
