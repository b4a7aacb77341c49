// SPDX-License-Identifier: Apache-2.0
//
// A stage for any stream of row slots, any pauses, resets at any time: one beat in, one beat out, in
// order, at a fixed number of clocks, none lost or made up. Its slot out is the centre stream of a
// slot_tracker (proved alone: the same rows two rows and two columns later, well formed again), Clocks
// after the beat; its result, DataClocks after the beat, is 0 where the window leaves the frame.
//
// The stage's arithmetic does not reach what is asserted and falls away.
module stage_properties #(
    parameter int Stage      = 0,  // 0 gradient, 1 first_contour, 2 ridge, 3 second_contour, 4 vertex_value
    parameter int Voids      = 4,  // void rows that the stream before has at a change of width
    parameter int Clocks     = 10, // of the slot, of the data: as the module's header states them
    parameter int DataClocks = 10
) (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        valid,
    input logic        sol,
    input logic        sof,
    input logic        is_real,
    input logic [ 1:0] fault,
    input logic [ 1:0] change,
    input logic [ 2:0] new_width,
    input logic [19:0] data
);
  localparam int MaxWidthPx = 6;

  logic started, in_row;
  logic [5:0] before_last;
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
      .width_o(),
      .before_last_o(before_last),
      .kind_o(),
      .col_o(),
      .in_row_o(in_row)
  );

  logic out_valid, out_sol, out_eol, out_in_row, out_sof, out_real, result;  // result: any bit of it
  logic [1:0] out_fault;
  if (Stage == 0) begin : gen_gradient
    logic [5:0] magnitude;
    logic [1:0] step;
    assign result = magnitude != '0;
    assign {out_eol, out_in_row} = '0;
    gradient #(.MaxWidthPx(MaxWidthPx), .FractionBits(0)) dut (
        .clk_i, .rst_ni, .valid_i(valid), .sol_i(sol), .sof_i(sof), .real_i(is_real),
        .fault_i(fault), .in_row_i(in_row), .data_i(data[7:0]), .valid_o(out_valid), .sol_o(out_sol),
        .sof_o(out_sof),
        .real_o(out_real), .fault_o(out_fault), .data_o({step, magnitude}), .tail_column_valid_o(),
        .tail_column_o(), .tail_valid_o(), .tail_sol_o(), .tail_sof_o(), .tail_real_o(),
        .tail_fault_o()
    );
  end else if (Stage == 1) begin : gen_first_contour
    logic [17:0] magnitudes;
    logic [1:0] flags;
    assign result = flags != '0;
    assign {out_eol, out_in_row} = '0;
    first_contour #(.MaxWidthPx(MaxWidthPx), .MagnitudeBits(6)) dut (
        .clk_i, .rst_ni, .noise_floor_i(6'd1), .mean_limit_i(5'd21), .valid_i(valid), .sol_i(sol),
        .sof_i(sof), .real_i(is_real), .fault_i(fault), .data_i(data[7:0]), .valid_o(out_valid),
        .sol_o(out_sol), .sof_o(out_sof), .real_o(out_real), .fault_o(out_fault),
        .data_o({flags, magnitudes})
    );
  end else if (Stage == 2) begin : gen_ridge
    logic [1:0] above;
    assign {out_eol, out_in_row} = '0;
    ridge #(.MaxWidthPx(MaxWidthPx), .MagnitudeBits(6)) dut (
        .clk_i, .rst_ni, .support_i(11'd1), .noise_floor_i(6'd1), .valid_i(valid), .sol_i(sol),
        .sof_i(sof), .real_i(is_real), .fault_i(fault), .data_i(data), .valid_o(out_valid),
        .sol_o(out_sol), .sof_o(out_sof), .real_o(out_real), .fault_o(out_fault),
        .data_o({above, result})
    );
  end else if (Stage == 3) begin : gen_second_contour
    logic first;
    second_contour #(.MaxWidthPx(MaxWidthPx)) dut (
        .clk_i, .rst_ni, .valid_i(valid), .sol_i(sol), .sof_i(sof), .real_i(is_real),
        .fault_i(fault), .before_last_i(before_last), .data_i(data[2:0]), .valid_o(out_valid),
        .sol_o(out_sol), .eol_o(out_eol), .sof_o(out_sof), .real_o(out_real), .fault_o(out_fault),
        .in_row_o(out_in_row),
        .data_o({first, result})
    );
  end else begin : gen_vertex_value
    assign {out_eol, out_in_row} = '0;
    vertex_value #(.MaxWidthPx(MaxWidthPx)) dut (
        .clk_i, .rst_ni, .min_turn_i(5'd1), .valid_i(valid), .sol_i(sol), .sof_i(sof),
        .real_i(is_real), .fault_i(fault), .in_row_i(in_row), .data_i(data[6:0]), .valid_o(out_valid),
        .sol_o(out_sol), .sof_o(out_sof), .real_o(out_real), .fault_o(out_fault),
        .value_o(result), .above_o()
    );
  end

  // What is expected: the centre stream of a tracker, delayed.
  logic centre_valid, centre_sol, centre_eol, centre_in_row, centre_sof, centre_real, inside, in_row1_q;
  logic [1:0] centre_fault;
  always_ff @(posedge clk_i) in_row1_q <= in_row;
  slot_tracker #(
      .MaxWidthPx(MaxWidthPx),
      .Limited   (Stage == 3)
  ) expected (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(fault),
      .within_i(in_row1_q || Stage == 1 || Stage == 2),
      .before_last_i(before_last),
      .col_o(),
      .valid1_o(),
      .col1_o(),
      .valid_o(centre_valid),
      .sol_o(centre_sol),
      .eol_o(centre_eol),
      .sof_o(centre_sof),
      .real_o(centre_real),
      .fault_o(centre_fault),
      .in_row_o(centre_in_row),
      .inside_o(inside),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );
  // Bit or entry k: k clocks behind the centre.
  logic [DataClocks-2:0] valid_q, inside_q;
  logic [7*(DataClocks-1)-1:0] centre_q;
  logic [7:0] due;
  always_ff @(posedge clk_i) begin
    valid_q  <= rst_ni ? (DataClocks - 1)'({valid_q, centre_valid}) : '0;
    inside_q <= (DataClocks - 1)'({inside_q, inside});
    centre_q <= (7 * (DataClocks - 1))'(
        {centre_q, centre_in_row, centre_sol, centre_eol, centre_sof, centre_real, centre_fault});
  end
  assign due = {valid_q[Clocks-3], centre_q[7*(Clocks-3)+:7]};

  always_ff @(posedge clk_i) begin
    if (started && rst_ni) begin
      assert (out_valid == due[7]);
      if (due[7]) begin
        assert ({out_sol, out_sof, out_real, out_fault} == {due[5], due[3:0]});
        if (Stage == 3 && (out_real || out_sof)) begin  // a frame's row
          assert ({out_in_row, out_eol} == {due[6], due[4]});
        end
      end
      // A beat's result: where the window is not inside the frame, none.
      if (valid_q[DataClocks-3] && !inside_q[DataClocks-3]) assert (!result);
    end
  end
endmodule
