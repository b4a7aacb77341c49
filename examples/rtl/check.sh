#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Verilator, Icarus and Yosys elaborate the instantiation example without a warning; Icarus runs a
# frame through it.
set -eu
cd "$(dirname "$0")/../.."
example=examples/rtl/three_cameras.sv
sources="rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v trihedron_registers | tr '\n' ' ')"
log=$(mktemp)
program=$(mktemp)
trap 'rm -f "$log" "$program"' EXIT

verilator --lint-only -Wall rtl/lint.vlt rtl/trihedron_registers.sv $example -y rtl --top three_cameras
iverilog -g2012 -o "$program" -Wall -Wno-timescale -s three_cameras_tb $sources $example \
  tests/rtl/three_cameras_tb.sv >"$log" 2>&1 ||
  { cat "$log"; exit 1; }
# Icarus 11 says of every assert that it "cannot be synthesized", which is right and intended.
if grep -v "cannot be synthesized in an always_ff process" "$log"; then exit 1; fi
yosys -q -p "read_verilog -sv $sources $example
  hierarchy -check -top three_cameras; proc; check -assert" >"$log" 2>&1 || { cat "$log"; exit 1; }
vvp -n "$program"
echo "three_cameras: elaborated by Verilator, Icarus and Yosys"
