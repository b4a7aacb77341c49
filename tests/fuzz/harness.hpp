// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "golden/error.hpp"

/// Called with one input by libFuzzer, or by replay.cpp with each file of the kept corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace trihedron::fuzz {

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "fuzz: %s\n", what.c_str());
  std::abort();
}

/// The first byte of an input chooses among `kinds` of it; none counts as 0.
inline unsigned kind_of(const std::uint8_t* data, std::size_t size, unsigned kinds) {
  return size == 0 ? 0 : data[0] % kinds;
}
/// What follows that byte.
inline std::string rest_of(const std::uint8_t* data, std::size_t size) {
  return size <= 1 ? std::string() : std::string(data + 1, data + size);
}

/// Whatever the input, `action` takes it or refuses it with an Error of one line; anything else is
/// a finding.
template <typename Action>
void take_or_refuse(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    const std::string message = error.what();
    if (message.empty() || message.find_first_of("\n\r") != std::string::npos)
      fail("an Error that is not one line: \"" + message + "\"");
  }
}

}  // namespace trihedron::fuzz
