// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace trihedron {

/// Bad input or misuse. The message is one line for a person: what is wrong, where (file and
/// field), and what would be right.
class Error : public std::runtime_error {
 public:
  /// Control characters that bad input brought into the message become '?'.
  explicit Error(std::string message) : std::runtime_error(printable(std::move(message))) {}

 private:
  static std::string printable(std::string text) {
    for (char& c : text)
      if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
    return text;
  }
};

}  // namespace trihedron
