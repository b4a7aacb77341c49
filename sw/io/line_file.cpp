// SPDX-License-Identifier: Apache-2.0
#include "io/line_file.hpp"

#include <unistd.h>

#include "golden/error.hpp"

namespace trihedron {

LineFile::LineFile(const std::filesystem::path& file) : file_(file), beside_(file) {
  beside_ += ".part" + std::to_string(getpid());
  out_.open(beside_, std::ios::binary);
  if (!out_) fail();
}

LineFile::~LineFile() {
  try {
    close();
  } catch (const Error&) {
    // Whoever wants to know calls close().
  }
}

void LineFile::write(const std::string& line) {
  out_ << line << '\n';
  out_.flush();
  if (!out_) fail();
}

void LineFile::close() {
  if (!out_.is_open()) return;
  out_.close();
  std::error_code error;
  if (out_) std::filesystem::rename(beside_, file_, error);
  if (!out_ || error) fail();
}

void LineFile::fail() const {
  throw Error(file_.string() + ": cannot be written; expected a writable folder with room");
}

}  // namespace trihedron
