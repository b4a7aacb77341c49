// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>

#include <atomic>
#include <cstddef>
#include <limits>
#include <new>

#include "golden/error.hpp"

namespace trihedron::cli {

/// The lowest number of an item that failed, shared with the processes forked after it was made:
/// items behind it need not be worked on, those before it must be, so that the first failure is the
/// same for any number of processes.
class FirstFailure {
 public:
  FirstFailure() {
    void* page =
        mmap(nullptr, sizeof *item_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw Error("no memory to share with worker processes");
    item_ = new (page) std::atomic<std::size_t>(std::numeric_limits<std::size_t>::max());
  }
  ~FirstFailure() { munmap(item_, sizeof *item_); }
  FirstFailure(const FirstFailure&) = delete;
  FirstFailure& operator=(const FirstFailure&) = delete;

  void note(std::size_t item) {
    std::size_t first = item_->load();
    while (item < first && !item_->compare_exchange_weak(first, item)) {
    }
  }
  bool any() const { return item_->load() != std::numeric_limits<std::size_t>::max(); }
  bool is_before(std::size_t item) const { return item_->load() < item; }

 private:
  std::atomic<std::size_t>* item_ = nullptr;
};

}  // namespace trihedron::cli
