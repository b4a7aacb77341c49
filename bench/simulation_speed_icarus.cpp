// SPDX-License-Identifier: Apache-2.0
#include "bench/simulation_speed_icarus.hpp"

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "golden/error.hpp"
#include "golden/front_end.hpp"
#include "sim/beats.hpp"

namespace trihedron::bench {
namespace {

namespace fs = std::filesystem;

std::string hex(std::uint64_t value) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx\n", static_cast<unsigned long long>(value));
  return text;
}

/// Writes what goes in and what must come out; returns how many records a view sends.
std::size_t write_vectors(const fs::path& folder, const sim::GreyImage& image) {
  const ViewFeatures golden =
      golden::run_front_end(image.pixels.data(), image.width, image.height, image.width);
  std::ofstream pixels(folder / "pixels.hex"), beats(folder / "beats.hex"),
      records(folder / "records.hex");
  for (const std::uint8_t grey : image.pixels) pixels << hex(grey).substr(14);
  for (const ContourBeat& beat : golden.contour) beats << hex(sim::pack(beat));
  for (const Vertex& vertex : golden.vertices) records << hex(sim::pack(vertex));
  records << hex(sim::kEndKind | std::uint64_t{golden.vertices.size()} << 16);
  return golden.vertices.size() + 1;
}

double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string output_of(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw Error("cannot run " + command);
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  if (pclose(pipe) != 0) throw Error("failed: " + command.substr(0, 200));
  return text;
}

}  // namespace

double icarus_clocks_per_second(const sim::GreyImage& image) {
  const fs::path folder = fs::temp_directory_path() / "trihedron_icarus";
  fs::create_directories(folder);
  const std::size_t records = write_vectors(folder, image);
  const std::string top = "simulation_speed_icarus";
  const auto parameter = [&](const char* name, std::size_t value) {
    return " -P" + top + "." + name + "=" + std::to_string(value);
  };
  output_of("iverilog -g2012 -o " + (folder / "sim").string() + " -s " + top +
            parameter("Width", static_cast<std::size_t>(image.width)) +
            parameter("Height", static_cast<std::size_t>(image.height)) +
            parameter("Records", records) + " " TRIHEDRON_RTL "/trihedron_registers.sv $(ls " +
            TRIHEDRON_RTL "/*.sv | grep -v trihedron_registers) " TRIHEDRON_BENCH_DIR "/" + top +
            ".sv 2>" + (folder / "iverilog.log").string());
  const double start = seconds_of_children();
  const std::string said = output_of("cd " + folder.string() + " && vvp -n sim");
  const double seconds = seconds_of_children() - start;
  if (said.find("equal") == std::string::npos)
    throw Error("Icarus: the device differs from the golden model: " + said);
  return std::atof(said.substr(said.find_first_of("0123456789")).c_str()) / seconds;
}

}  // namespace trihedron::bench
