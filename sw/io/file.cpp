// SPDX-License-Identifier: Apache-2.0
#include "io/file.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>

#include "golden/error.hpp"

namespace trihedron {

namespace fs = std::filesystem;

void require_file(const fs::path& file, const std::string& what) {
  std::error_code error;
  if (!fs::exists(file, error)) throw Error(file.string() + ": no such file; expected " + what);
  if (!fs::is_regular_file(file, error))
    throw Error(file.string() + ": not a file; expected " + what);
  if (!std::ifstream(file)) throw Error(file.string() + ": cannot be opened; expected " + what);
}

void require_folder(const fs::path& folder, const std::string& what) {
  std::error_code error;
  if (!fs::exists(folder, error))
    throw Error(folder.string() + ": no such folder; expected " + what);
  if (!fs::is_directory(folder, error))
    throw Error(folder.string() + ": not a folder; expected " + what);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw Error(folder.string() + ": cannot make this folder (" + error.message() + ")");
}

std::string read_whole(const fs::path& file, const std::string& what) {
  require_file(file, what);
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) throw Error(file.string() + ": reading failed; expected " + what);
  return bytes;
}

namespace {

fs::path beside_of(const fs::path& file) {
  fs::path beside = file;
  return beside += ".part" + std::to_string(getpid());
}

}  // namespace

void require_writable(const fs::path& file) {
  const fs::path beside = beside_of(file);
  std::error_code error;
  const bool good = !fs::is_directory(file, error) && std::ofstream(beside).good();
  fs::remove(beside, error);
  if (!good)
    throw Error(file.string() + ": cannot be written; expected a file in a writable folder");
}

void write_whole(const fs::path& file, const std::string& bytes) {
  const fs::path beside = beside_of(file);
  std::ofstream out(beside, std::ios::binary);
  out << bytes;
  out.close();
  std::error_code error;
  if (out) fs::rename(beside, file, error);
  if (!out || error) {
    fs::remove(beside, error);
    throw Error(file.string() + ": cannot be written; expected a writable folder with room");
  }
}

}  // namespace trihedron
