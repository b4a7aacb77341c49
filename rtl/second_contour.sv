// SPDX-License-Identifier: Apache-2.0
//
// Stage 3, second window: the ridge, linked into contours one pixel wide.
//
// The links of a pixel are its ridge neighbours among the 8.
//   A ridge pixel stays when it has a link.
//   A pixel off the ridge with floor set closes a gap when its links fall into two or more groups
//   that do not touch and one of the links is an end (has one link itself).
//
//   slot in, out   see slot_tracker; data_i = {floor, first} of the pixel two rows above and ridge, one
//                  clock behind its slot; data_o = {first, contour} of the centre pixel, eol_o its
//                  last column, in_row_o a column of its row
//
// Latency 2 rows + 2 columns + 6 clocks, 1 beat per clock. Border: no contour.
module second_contour #(
    parameter int MaxWidthPx = 1920  // longest line, 5 .. 4080 px
) (
    input  logic                            clk_i,
    input  logic                            rst_ni,
    input  logic                            valid_i,
    input  logic                            sol_i,
    input  logic                            sof_i,
    input  logic                            real_i,
    input  logic [                     1:0] fault_i,
    input  logic [2*$clog2(MaxWidthPx)-1:0] before_last_i,
    input  logic [                     2:0] data_i,
    output logic                            valid_o,
    output logic                            sol_o,
    output logic                            eol_o,
    output logic                            sof_o,
    output logic                            real_o,
    output logic [                     1:0] fault_o,
    output logic                            in_row_o,
    output logic [                     1:0] data_o
);
  localparam int Latency = 4;

  logic [24:0] window;
  logic valid, sol, eol, sof, is_real, in_row, in_frame, floor, first;
  logic [1:0] fault;
  line_window #(
      .Width     (1),
      .SideWidth (2),
      .SideRows  (0),
      .MaxWidthPx(MaxWidthPx),
      .Limited   (1'b1)
  ) i_window (
      .clk_i,
      .rst_ni,
      .valid_i,
      .sol_i,
      .sof_i,
      .real_i,
      .fault_i,
      .within_i(1'b1),
      .before_last_i(before_last_i),
      .data_i(data_i[0]),
      .side_i(data_i[2:1]),
      .column_valid_o(),
      .column_o(),
      .window_o(window),
      .side_o({floor, first}),
      .valid_o(valid),
      .sol_o(sol),
      .eol_o(eol),
      .sof_o(sof),
      .real_o(is_real),
      .fault_o(fault),
      .in_row_o(in_row),
      .inside_o(in_frame),
      .tail_sol_o(),
      .tail_sof_o(),
      .tail_real_o(),
      .tail_fault_o(),
      .end_o(),
      .end_fault_o()
  );

  // Window bit of neighbour k, in turn around a pixel: right, lower right, below, and so on.
  function automatic int around(input int pixel, input int k);
    case (k)
      0: around = pixel + 5;
      1: around = pixel + 6;
      2: around = pixel + 1;
      3: around = pixel - 4;
      4: around = pixel - 5;
      5: around = pixel - 6;
      6: around = pixel - 1;
      default: around = pixel + 4;
    endcase
  endfunction

  // Clock 1: links; of each neighbour, none and one among four of its links and the other four.
  logic [7:0] links, links_q, none_a_q, one_a_q, none_b_q, one_b_q, filled_q;
  logic ridge_q, closes_q;
  function automatic logic one_of(input logic [3:0] bits);
    one_of = bits == 4'd1 || bits == 4'd2 || bits == 4'd4 || bits == 4'd8;
  endfunction
  always_comb begin
    for (int k = 0; k < 8; k++) links[k] = window[around(12, k)];
  end
  always_ff @(posedge clk_i) begin
    links_q  <= links;
    ridge_q  <= window[12] && in_frame;
    closes_q <= !window[12] && floor && in_frame;
    for (int k = 0; k < 8; k++) begin
      none_a_q[k] <= !(window[around(around(12, k), 0)] || window[around(around(12, k), 1)] ||
                       window[around(around(12, k), 2)] || window[around(around(12, k), 3)]);
      none_b_q[k] <= !(window[around(around(12, k), 4)] || window[around(around(12, k), 5)] ||
                       window[around(around(12, k), 6)] || window[around(around(12, k), 7)]);
      one_a_q[k] <= one_of({window[around(around(12, k), 0)], window[around(around(12, k), 1)],
                            window[around(around(12, k), 2)], window[around(around(12, k), 3)]});
      one_b_q[k] <= one_of({window[around(around(12, k), 4)], window[around(around(12, k), 5)],
                            window[around(around(12, k), 6)], window[around(around(12, k), 7)]});
      // A corner between two side neighbours does not part them: it counts as set.
      filled_q[k] <= links[k] || (k % 2 == 1 && links[(k+7)%8] && links[(k+1)%8]);
    end
  end

  // Clocks 2-4: ends among the links; runs of set neighbours, two or more of them.
  logic [7:0] end_q, starts_q;
  logic linked_q, ridge2_q, closes2_q, stays_q, closes3_q, any_end_q, two_a_q, two_b_q, some_a_q,
        some_b_q, contour_q;
  always_ff @(posedge clk_i) begin
    end_q     <= links_q & ((one_a_q & none_b_q) | (none_a_q & one_b_q));
    starts_q  <= filled_q & ~{filled_q[6:0], filled_q[7]};
    linked_q  <= links_q != '0;
    ridge2_q  <= ridge_q;
    closes2_q <= closes_q;

    stays_q   <= ridge2_q && linked_q;
    closes3_q <= closes2_q;
    any_end_q <= end_q != '0;
    some_a_q  <= starts_q[3:0] != '0;
    some_b_q  <= starts_q[7:4] != '0;
    two_a_q   <= starts_q[3:0] != '0 && !one_of(starts_q[3:0]);
    two_b_q   <= starts_q[7:4] != '0 && !one_of(starts_q[7:4]);

    contour_q <= stays_q || (closes3_q && any_end_q &&
                             (two_a_q || two_b_q || (some_a_q && some_b_q)));
  end

  logic first_late;
  assign data_o = {first_late, contour_q};
  payload_delay #(
      .Width (3),
      .Clocks(Latency)
  ) i_first (
      .clk_i,
      .data_i({in_row, eol, first}),
      .data_o({in_row_o, eol_o, first_late})
  );
  slot_delay #(
      .Clocks(Latency)
  ) i_slot (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .sol_i(sol),
      .sof_i(sof),
      .real_i(is_real),
      .fault_i(fault),
      .valid_o,
      .sol_o,
      .sof_o,
      .real_o,
      .fault_o
  );
endmodule
