// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace trihedron::cli {

/// The texts that `work(0)` .. `work(count - 1)` return, in that order whatever the number of
/// worker processes. `work` runs in forked processes where jobs > 1: what it changes in memory
/// stays there. Shows progress ("3/63 what") on a terminal.
///
/// Throws Error with the first item's message when work throws, or when a worker dies.
std::vector<std::string> run_workers(std::size_t count, int jobs, const std::string& what,
                                     const std::function<std::string(std::size_t)>& work);

}  // namespace trihedron::cli
