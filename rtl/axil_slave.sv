// SPDX-License-Identifier: Apache-2.0
//
// AXI4-Lite slave that turns accesses into single strobes on a simple register bus.
//
//   s_axil_*                     AXI4-Lite, 32-bit data; one write and one read at a time
//   write_o, write_address_o, write_data_o, write_strobe_o   one clock per write
//   read_address_o, read_data_i  data of the address, one clock later
//
// A write is answered 2 clocks, a read 3 clocks after its last channel has arrived; always OKAY.
module axil_slave #(
    parameter int AddressBits = 12  // byte addresses
) (
    input  logic                   clk_i,
    input  logic                   rst_ni,
    input  logic                   s_axil_awvalid_i,
    output logic                   s_axil_awready_o,
    input  logic [AddressBits-1:0] s_axil_awaddr_i,
    input  logic                   s_axil_wvalid_i,
    output logic                   s_axil_wready_o,
    input  logic [           31:0] s_axil_wdata_i,
    input  logic [            3:0] s_axil_wstrb_i,
    output logic                   s_axil_bvalid_o,
    input  logic                   s_axil_bready_i,
    output logic [            1:0] s_axil_bresp_o,
    input  logic                   s_axil_arvalid_i,
    output logic                   s_axil_arready_o,
    input  logic [AddressBits-1:0] s_axil_araddr_i,
    output logic                   s_axil_rvalid_o,
    input  logic                   s_axil_rready_i,
    output logic [           31:0] s_axil_rdata_o,
    output logic [            1:0] s_axil_rresp_o,
    output logic                   write_o,
    output logic [AddressBits-3:0] write_address_o,
    output logic [           31:0] write_data_o,
    output logic [            3:0] write_strobe_o,
    output logic [AddressBits-3:0] read_address_o,
    input  logic [           31:0] read_data_i
);
  if (AddressBits < 4 || AddressBits > 32) begin : gen_illegal
    illegal_AddressBits_must_be_4_to_32 stop ();
  end

  // Both write channels are taken together, when both are there and no answer is pending.
  assign write_o = s_axil_awvalid_i && s_axil_wvalid_i && s_axil_awready_o;
  assign s_axil_wready_o = s_axil_awready_o;
  assign write_address_o = s_axil_awaddr_i[AddressBits-1:2];
  assign write_data_o = s_axil_wdata_i;
  assign write_strobe_o = s_axil_wstrb_i;
  assign s_axil_bresp_o = 2'b00;
  assign s_axil_rresp_o = 2'b00;

  logic read_pending_q, read_address_valid_q, read_data_valid_q;
  assign s_axil_arready_o = !read_pending_q;

  always_ff @(posedge clk_i) begin
    if (s_axil_arvalid_i && s_axil_arready_o) read_address_o <= s_axil_araddr_i[AddressBits-1:2];
    if (read_data_valid_q) s_axil_rdata_o <= read_data_i;
    if (!rst_ni) begin
      {s_axil_awready_o, s_axil_bvalid_o} <= '0;
      {read_pending_q, read_address_valid_q, read_data_valid_q, s_axil_rvalid_o} <= '0;
    end else begin
      s_axil_awready_o <= s_axil_awvalid_i && s_axil_wvalid_i && !s_axil_awready_o &&
                          !(s_axil_bvalid_o && !s_axil_bready_i);
      if (write_o) s_axil_bvalid_o <= 1'b1;
      else if (s_axil_bready_i) s_axil_bvalid_o <= 1'b0;
      read_address_valid_q <= s_axil_arvalid_i && s_axil_arready_o;
      read_data_valid_q    <= read_address_valid_q;
      // From the acceptance to the answer's, known from what is on its way: nothing else can block reads.
      read_pending_q <= (s_axil_arvalid_i && s_axil_arready_o) || read_address_valid_q ||
                        read_data_valid_q || (s_axil_rvalid_o && !s_axil_rready_i);
      if (read_data_valid_q) s_axil_rvalid_o <= 1'b1;
      else if (s_axil_rready_i) s_axil_rvalid_o <= 1'b0;
    end
  end

  // Handshake: answers stay, unchanged, until they are taken.
  logic b_held_q, r_held_q;
  logic [31:0] r_data_q;
  always_ff @(posedge clk_i) begin
    b_held_q <= rst_ni && s_axil_bvalid_o && !s_axil_bready_i;
    r_held_q <= rst_ni && s_axil_rvalid_o && !s_axil_rready_i;
    r_data_q <= s_axil_rdata_o;
    if (rst_ni) begin
      assert (!b_held_q || s_axil_bvalid_o);
      assert (!r_held_q || (s_axil_rvalid_o && s_axil_rdata_o == r_data_q));
    end
  end
endmodule
