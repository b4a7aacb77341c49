// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace trihedron::cli {

/// From its construction on, the first SIGINT (Ctrl-C) or SIGTERM does not end the program but is
/// remembered, also by processes forked later, so that the work can stop between two frames with
/// its results written. A second one ends the program at once.
class Interruption {
 public:
  Interruption();
  /// Whether a signal came.
  static bool requested();
  /// What the program returns after it, as shells have it: 128 + the signal's number.
  static int exit_code();
};

}  // namespace trihedron::cli
