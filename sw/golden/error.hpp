// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace trihedron {

/// Bad input or misuse. The message is one line for a person: what is wrong, where (file and
/// field), and what would be right.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace trihedron
