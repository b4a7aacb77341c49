#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# trihedron_top with the parameters given, or with some at the ends of their ranges, in Verilator against the
# golden model: random frames of all its sizes, idles and stalls on every view, each beat and record.
# usage: parameters.sh [VIEWS WIDTH HEIGHT FRACTION_BITS]   (RUNS=N: so many random runs, default 5)
set -euo pipefail
cd "$(dirname "$0")/../.."
here=tests/parameters
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
compiler=g++
if command -v ccache >/dev/null; then compiler="ccache g++"; fi

check() {  # check VIEWS WIDTH HEIGHT FRACTION_BITS
  # The golden model for these fraction bits; it adds 25 magnitudes of 6 bits more in 16 bits.
  if [ "$4" -gt 4 ]; then echo "parameters: the golden model has 0 to 4 fraction bits" >&2; exit 2; fi
  rm -rf "${scratch:?}"/*
  cp -r sw/golden "$scratch"
  sed -i "s/\(kGradientFractionBits = \)3/\1$4/" "$scratch/golden/features.hpp"
  verilator --cc --exe --build --assert -O3 --x-assign fast --x-initial fast -Wno-fatal \
    -GViews="$1" -GMaxWidthPx="$2" -GMaxHeightPx="$3" -GFractionBits="$4" -Mdir "$scratch/device" \
    -CFLAGS "-std=c++17 -O1 -I$scratch -I$PWD/$here -I$PWD" -MAKEFLAGS "OPT_SLOW=-O0 CXX='$compiler'" \
    rtl/trihedron_registers.sv rtl/trihedron_top.sv -y rtl --top trihedron_top \
    "$PWD/$here/bench.cpp" "$scratch"/golden/*.cpp >"$scratch/log" 2>&1 ||
    { grep -m5 -i error "$scratch/log" >&2; exit 1; }
  "$scratch/device/Vtrihedron_top" "$@" "${RUNS:-5}"
}

if [ $# -eq 4 ]; then
  check "$@"
elif [ $# -eq 0 ]; then
  check 1 5 5 3
  check 4 33 4095 0
  check 1 4080 9 4
else
  sed -n '5s/^# //p' "$0" >&2
  exit 2
fi
