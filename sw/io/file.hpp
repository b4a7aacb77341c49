// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace trihedron {

/// Throws Error unless `file` is a file that can be read; `what` names it ("a mesh").
void require_file(const std::filesystem::path& file, const std::string& what);

/// Throws Error unless `folder` is a folder; `what` names it ("the model library").
void require_folder(const std::filesystem::path& folder, const std::string& what);

/// Makes the folder and those above it. Throws Error when that is not possible.
void make_folder(const std::filesystem::path& folder);

/// The file's bytes. Throws Error when it cannot be read.
std::string read_whole(const std::filesystem::path& file, const std::string& what);

/// Throws Error where write_whole() would, but for a full disk; leaves an existing file as it is.
void require_writable(const std::filesystem::path& file);

/// Writes beside the file, then renames: the file is never seen half written. Throws Error
/// when the disk refuses.
void write_whole(const std::filesystem::path& file, const std::string& bytes);

}  // namespace trihedron
