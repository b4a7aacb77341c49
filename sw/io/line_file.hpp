// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace trihedron {

/// A text file that grows line by line beside its place and is moved there, whole, by close() or
/// the destructor: an interrupted program leaves no half-written file under the name.
class LineFile {
 public:
  /// Throws Error when the folder cannot be written.
  explicit LineFile(const std::filesystem::path& file);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Throws Error when the disk refuses.
  void write(const std::string& line);
  /// Throws Error when the disk refuses.
  void close();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path file_, beside_;
  std::ofstream out_;
};

}  // namespace trihedron
