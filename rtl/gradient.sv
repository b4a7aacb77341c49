// SPDX-License-Identifier: Apache-2.0
//
// Stage 1: the gradient's magnitude and the step across the contour.
//
//   magnitude = min((|H| + |V| + 2 |D| + 2 |E|) / 512, 64 - 1/scale), |D| + |E| = max(|A|, |B|)
//   step      = neighbour along the gradient: 0 horizontal (2 |gy| < |gx|), 1 vertical
//               (2 |gx| < |gy|), 2 falling diagonal (gx, gy of one sign), 3 rising diagonal
//
// in units of 1/scale grey level per px, scale = 2^FractionBits, rounded to nearest.
//
//   slot in, out  see line_window; data_o = {step, magnitude} of the centre pixel
//   tail_*        the pixels four rows later, for slope
//
// Latency 2 rows + 2 columns + 15 clocks, 1 beat per clock. Border: magnitude 0.
module gradient #(
    parameter int MaxWidthPx   = 1920,
    parameter int FractionBits = 3
) (
    input  logic                    clk_i,
    input  logic                    rst_ni,
    input  logic                    valid_i,
    input  logic                    sol_i,
    input  logic                    sof_i,
    input  logic                    real_i,
    input  logic [             1:0] fault_i,
    input  logic [             7:0] data_i,
    output logic                    valid_o,
    output logic                    sol_o,
    output logic                    sof_o,
    output logic                    real_o,
    output logic [             1:0] fault_o,
    output logic [FractionBits+7:0] data_o,
    output logic                    tail_valid_o,
    output logic                    tail_sol_o,
    output logic                    tail_sof_o,
    output logic                    tail_real_o,
    output logic [             1:0] tail_fault_o,
    output logic [             7:0] tail_data_o
);
  if (FractionBits < 0 || FractionBits > 6) begin : gen_illegal
    illegal_FractionBits_must_be_0_to_6 stop ();
  end
  localparam int MagnitudeBits = 6 + FractionBits;
  localparam int Shift = 9 - FractionBits;
  localparam int SlopeBits = 8 + FractionBits;
  localparam int Latency = 13;

  logic sol, sof, is_real, in_frame, in_frame_late;
  logic [1:0] fault;
  logic [39:0] column;
  line_window #(
      .Width(8),
      .Columns(1),
      .MaxWidthPx(MaxWidthPx)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .data_i,
      .window_o(column),
      .valid_o(tail_valid_o),
      .sol_o(sol),
      .eol_o(),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(fault),
      .inside_o(in_frame),
      .tail_sol_o,
      .tail_sof_o,
      .tail_real_o,
      .tail_fault_o,
      .tail_data_o,
      .end_o(),
      .end_fault_o()
  );

  logic signed [14:0] h, v;
  logic signed [13:0] a, b;
  derivatives i_derivatives (
      .clk_i,
      .valid_i (tail_valid_o),
      .column_i(column),
      .h_o(h),
      .v_o(v),
      .a_o(a),
      .b_o(b)
  );

  // Clocks 9-13.
  logic signed [SlopeBits-1:0] gx, gy;
  slope_rounding #(
      .FractionBits(FractionBits)
  ) i_slope (
      .clk_i,
      .h_i (h),
      .v_i (v),
      .a_i (a),
      .b_i (b),
      .gx_o(gx),
      .gy_o(gy)
  );

  logic [13:0] abs_h_q, abs_v_q;
  logic [12:0] abs_a_q, abs_b_q, diagonal_q;
  logic [14:0] straight_q;
  logic [15:0] sum_q;
  logic [15-Shift:0] rounded_q;
  logic [SlopeBits-2:0] ax_q, ay_q;
  logic same_sign_q, same_sign_late_q, horizontal_q, vertical_q;

  function automatic logic [13:0] absolute(input logic signed [14:0] value);
    absolute = value[14] ? 14'(-value) : value[13:0];
  endfunction

  always_ff @(posedge clk_i) begin
    abs_h_q    <= absolute(h);
    abs_v_q    <= absolute(v);
    abs_a_q    <= 13'(absolute(15'(a)));
    abs_b_q    <= 13'(absolute(15'(b)));
    straight_q <= 15'(abs_h_q) + 15'(abs_v_q);
    diagonal_q <= abs_a_q > abs_b_q ? abs_a_q : abs_b_q;
    sum_q      <= 16'(straight_q) + {2'b0, diagonal_q, 1'b0};
    rounded_q  <= (16 - Shift)'((sum_q + 16'(1 << (Shift - 1))) >> Shift);

    ax_q             <= gx[SlopeBits-1] ? (SlopeBits - 1)'(-gx) : gx[SlopeBits-2:0];
    ay_q             <= gy[SlopeBits-1] ? (SlopeBits - 1)'(-gy) : gy[SlopeBits-2:0];
    same_sign_q      <= gx[SlopeBits-1] == gy[SlopeBits-1];
    horizontal_q     <= {ay_q, 1'b0} < {1'b0, ax_q};
    vertical_q       <= {ax_q, 1'b0} < {1'b0, ay_q};
    same_sign_late_q <= same_sign_q;

    data_o[MagnitudeBits+:2] <= {!horizontal_q && !vertical_q,
                                 vertical_q || (!horizontal_q && !same_sign_late_q)};
    if (!in_frame_late) data_o[MagnitudeBits-1:0] <= '0;
    else if (rounded_q[15-Shift]) data_o[MagnitudeBits-1:0] <= '1;
    else data_o[MagnitudeBits-1:0] <= rounded_q[MagnitudeBits-1:0];
  end

  delay_line #(
      .Width (6),
      .Clocks(Latency)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .data_i({tail_valid_o, sol, sof, is_real, fault}),
      .data_o({valid_o, sol_o, sof_o, real_o, fault_o})
  );
  delay_line #(
      .Width (1),
      .Clocks(Latency - 1)
  ) i_inside (
      .clk_i,
      .rst_ni,
      .data_i(in_frame),
      .data_o(in_frame_late)
  );
endmodule
