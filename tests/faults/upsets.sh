#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds a simulator whose flip-flops can be flipped, and flips them.
# usage: upsets.sh [OPTIONS OF trihedron_upsets]
set -eu
cd "$(dirname "$0")/../.."
out=build/upsets
tests/faults/flip_flops.py $out/upsets.vlt
cmake -S . -B $out/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRIHEDRON_TESTS=OFF \
  -DTRIHEDRON_UPSETS=ON -DTRIHEDRON_VERILATOR_ARGS="$PWD/$out/upsets.vlt" >$out/configure.log
cmake --build $out/build --target trihedron_upsets
exec $out/build/tests/faults/trihedron_upsets --json $out/upsets.json "$@"
