#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Mutates the RTL, builds one simulator that holds all mutants and runs the regression on each.
# usage: mutation.sh [OPTIONS OF run.py]
set -eu
cd "$(dirname "$0")/../.."
out=build/mutation
tests/mutation/mutants.py $out
cmake -S . -B $out/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRIHEDRON_TESTS=OFF \
  -DTRIHEDRON_RTL_DIR="$PWD/$out/rtl" >$out/configure.log
cmake --build $out/build --target trihedron
exec tests/mutation/run.py $out "$@"
