// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

namespace trihedron {

/// While it lives, keeps the lines that libpng, libjpeg and FFmpeg print by themselves off standard
/// error: the caller reports in one line. Not for use beside other threads that print there.
class QuietDecoders {
 public:
  QuietDecoders() : kept_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere < 0) return;
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
  ~QuietDecoders() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  QuietDecoders(const QuietDecoders&) = delete;
  QuietDecoders& operator=(const QuietDecoders&) = delete;

 private:
  int kept_;
};

}  // namespace trihedron
