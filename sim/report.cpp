// SPDX-License-Identifier: Apache-2.0
#include "sim/report.hpp"

#include <sstream>

namespace trihedron::sim {

std::string Mismatch::text() const {
  std::ostringstream line;
  line << stage << " differs: seed " << seed << ", view " << view << ", frame " << frame;
  if (x >= 0) line << ", x " << x;
  if (y >= 0) line << ", y " << y;
  line << ": expected " << expected << ", got " << got << " (clock " << clock << ")";
  return line.str();
}

}  // namespace trihedron::sim
