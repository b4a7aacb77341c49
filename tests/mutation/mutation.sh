#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Mutates the RTL, builds the regression and the unit tests around one netlist that holds all mutants, and
# looks for what kills each.
# usage: mutation.sh [OPTIONS OF run.py]
set -eu
cd "$(dirname "$0")/../.."
out=build/mutation
tests/mutation/mutants.py $out
cmake -S . -B build/mutated -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRIHEDRON_RTL_DIR="$PWD/$out/rtl" \
  >$out/configure.log
cmake --build build/mutated --target trihedron trihedron_sim_tests trihedron_driver_tests trihedron_fuzz_stream
exec tests/mutation/run.py $out build/mutated "$@"
