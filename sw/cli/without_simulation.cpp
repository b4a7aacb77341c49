// SPDX-License-Identifier: Apache-2.0
// Stands in for the simulation's commands in a build without it.
#include "cli/commands.hpp"
#include "cli/rtl_front_end.hpp"
#include "golden/error.hpp"

namespace trihedron::cli {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw Error(std::string(what) +
              ": not in this build; configure with TRIHEDRON_SIM=ON (needs Verilator and SystemC)");
}

void add_refusal(CLI::App& program, const char* name) {
  CLI::App* command = program.add_subcommand(name, "Not in this build");
  command->allow_extras();
  command->callback([name] { refuse(name); });
}

}  // namespace

void add_simulate(CLI::App& program, int&) { add_refusal(program, "simulate"); }
void add_verify(CLI::App& program, int&) { add_refusal(program, "verify"); }

FrontEnd rtl_front_end(report::HardwareActivity*) { refuse("--frontend rtl"); }
std::string default_front_end() { return "golden"; }

}  // namespace trihedron::cli
