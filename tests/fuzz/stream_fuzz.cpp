// SPDX-License-Identifier: Apache-2.0
// Any bytes as beats, side signals, pauses, stalls and register values: the device and the models
// beside it must agree in every beat, record, counter and status bit, and nothing may hang.
#include "fuzz/stream_pair.hpp"

#include "fuzz/harness.hpp"

// SystemC's entry point, which its library refers to; the harness starts none.
extern "C" int sc_main(int, char**) { return 1; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trihedron::fuzz;
  const StreamCase stream_case = decode_case(data, size);
  const std::string difference = StreamPair(stream_case).run();
  if (!difference.empty()) fail(difference);
  return 0;
}
