// SPDX-License-Identifier: Apache-2.0
//
// contour_packer behind any pipeline that keeps to ready_o: each pixel comes out once, in order,
// gradient and flags of the same pixel, marked as it came in; an offered beat stays; nothing overruns.
//
// Gradients may be pushed only Clocks clocks after ready_o said so; a pixel's flags follow, at most
// Lead pixels later. Gradient and flags carry the pixel's number.
module contour_packer_properties (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       slope_valid,
    input logic       flags_valid,
    input logic       first,
    input logic       begins,
    input logic       tready
);
  localparam int Depth = 8;
  localparam int Reserve = 5;
  localparam int Clocks = 2;
  localparam int Lead = 2;

  logic started_q = 1'b0;
  logic ready, tvalid, tuser, tlast;
  logic [63:0] tdata;
  logic [Clocks-1:0] may_q;  // told so, in the last clocks

  // Pixels whose flags are to come, oldest in the low bits: {first of a frame, number}.
  logic [2:0] in, oldest;
  logic [3*Lead-1:0] wait_q, waiting;
  logic [1:0] lead_q, lead, number_q;
  assign in = {first, number_q};
  assign oldest = wait_q[2:0];
  assign lead = lead_q - 2'(flags_valid);
  assign waiting = flags_valid ? wait_q >> 3 : wait_q;

  contour_packer #(
      .FractionBits(0),
      .Depth  (Depth),
      .Reserve(Reserve)
  ) dut (
      .clk_i,
      .rst_ni,
      .slope_valid_i(slope_valid),
      .slope_first_i(first),
      .slope_begins_i(begins),
      .slope_data_i({20'b0, number_q}),
      .flags_valid_i(flags_valid),
      .flags_sol_i(1'b1),
      .flags_eol_i(oldest[0]),
      .flags_sof_i(oldest[2]),
      .flags_data_i(oldest[1:0]),
      .ready_o(ready),
      .m_axis_tvalid_o(tvalid),
      .m_axis_tready_i(tready),
      .m_axis_tdata_o(tdata),
      .m_axis_tuser_o(tuser),
      .m_axis_tlast_o(tlast)
  );

  logic held_q, was_reset_q;
  logic [65:0] held_data_q;
  logic [1:0] expected_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    was_reset_q <= !rst_ni;
    if (!started_q) assume (!rst_ni);
    assume (!slope_valid || (rst_ni && may_q[Clocks-1] && lead_q != 2'(Lead)));
    assume (!flags_valid || (rst_ni && lead_q != '0));
    may_q <= rst_ni ? Clocks'({may_q, ready}) : '0;
    for (int i = 0; i < Lead; i++) begin
      wait_q[3*i+:3] <= slope_valid && lead == 2'(i) ? in : waiting[3*i+:3];
    end
    if (!rst_ni) begin
      {lead_q, number_q, expected_q} <= '0;
    end else begin
      lead_q     <= lead + 2'(slope_valid);
      number_q   <= number_q + 2'(slope_valid);
      expected_q <= expected_q + 2'(tvalid && tready);
    end
    held_q <= rst_ni && tvalid && !tready;
    held_data_q <= {tuser, tlast, tdata};
    if (started_q && rst_ni) begin
      assert (!was_reset_q || !tvalid);
      assert (!held_q || (tvalid && {tuser, tlast, tdata} == held_data_q));
      if (tvalid) begin
        assert (tdata[25:24] == expected_q && tdata[1:0] == expected_q && tlast == expected_q[0]);
      end
    end
  end
endmodule
