// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/random.hpp"

namespace trihedron::sim {

/// AXI4-Lite master at the pins: one access at a time, its channels skewed by random stalls.
/// Call present() before the pins settle and accept() after.
class AxiLiteMaster {
 public:
  static constexpr unsigned kAllBytes = 15;
  static constexpr std::uint32_t kOtherWord = 0xffc;  ///< bits of an address above its bytes

  AxiLiteMaster(const StallProfile& stalls, std::uint64_t seed) : stall_(stalls, seed) {}

  void start(bool write, std::uint32_t address, std::uint32_t data, unsigned strobe = kAllBytes) {
    write_ = write;
    strobe_ = strobe;
    address_ = address;
    data_ = data;
    address_due_ = response_due_ = true;
    data_due_ = write;
  }
  bool busy() const { return response_due_; }
  std::uint32_t data() const { return data_; }
  unsigned response() const { return response_; }  ///< AXI RESP; 0 is OKAY

  template <typename Top>
  void present(Top& top) {
    if (busy()) {
      address_valid_ = address_due_ && (address_valid_ || !stall_.at_this_clock());
      data_valid_ = data_due_ && (data_valid_ || !stall_.at_this_clock());
      response_ready_ = !stall_.at_this_clock();
    }
    top.s_axil_awvalid = write_ && address_valid_;
    top.s_axil_arvalid = !write_ && address_valid_;
    // What is not valid means nothing, so it is something else.
    top.s_axil_awaddr = top.s_axil_awvalid ? address_ : address_ ^ kOtherWord;
    top.s_axil_araddr = top.s_axil_arvalid ? address_ : address_ ^ kOtherWord;
    top.s_axil_wvalid = data_valid_;
    top.s_axil_wdata = data_valid_ ? data_ : ~data_;
    top.s_axil_wstrb = strobe_;
    top.s_axil_bready = write_ && response_ready_;
    top.s_axil_rready = !write_ && response_ready_;
  }

  /// Returns true when the access ended at this clock.
  template <typename Top>
  bool accept(const Top& top) {
    if (!busy()) return false;
    if (address_valid_ && (write_ ? top.s_axil_awready : top.s_axil_arready)) {
      address_valid_ = address_due_ = false;
    }
    if (data_valid_ && top.s_axil_wready) data_valid_ = data_due_ = false;
    if (!response_ready_ || !(write_ ? top.s_axil_bvalid : top.s_axil_rvalid)) return false;
    if (!write_) data_ = top.s_axil_rdata;
    response_ = write_ ? top.s_axil_bresp : top.s_axil_rresp;
    response_due_ = response_ready_ = false;
    return true;
  }

 private:
  Stall stall_;
  bool write_ = false;
  unsigned strobe_ = kAllBytes;
  std::uint32_t address_ = 0;
  std::uint32_t data_ = 0;
  unsigned response_ = 0;
  bool address_due_ = false, data_due_ = false, response_due_ = false;
  bool address_valid_ = false, data_valid_ = false, response_ready_ = false;
};

}  // namespace trihedron::sim
