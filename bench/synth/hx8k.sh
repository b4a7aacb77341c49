#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Places and routes one view with 512 px lines on an iCE40 HX8K (hx8k_view) and prints what it uses
# and how fast it is: cells, block RAMs, clock rate, worst path.
# usage: hx8k.sh [OUT_DIR] [SEED]      default: build/synth 1
set -eu
cd "$(dirname "$0")/../.."
out=${1:-build/synth}
seed=${2:-1}
mkdir -p "$out"
sources="rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v trihedron_registers | tr '\n' ' ')"
yosys -V
nextpnr-ice40 --version 2>&1
yosys -q -l "$out/hx8k.log" -p "read_verilog -noassert -sv $sources bench/synth/hx8k_view.sv
  synth_ice40 -dff -abc2 -top hx8k_view -json $out/hx8k.json
  tee -q -o $out/hx8k.stat stat" 2>/dev/null
grep -E 'SB_(LUT4|DFF|CARRY|RAM)' "$out/hx8k.stat"
nextpnr-ice40 --hx8k --package ct256 --pcf-allow-unconstrained --json "$out/hx8k.json" \
  --freq 150 --seed "$seed" --timing-allow-fail >"$out/hx8k.pnr" 2>&1 || { tail -3 "$out/hx8k.pnr"; exit 1; }
grep -E 'ICESTORM_(LC|RAM)' "$out/hx8k.pnr"
grep 'Max frequency' "$out/hx8k.pnr" | tail -1
# The worst path from register to register, as placed.
tac "$out/hx8k.pnr" | sed '/Critical path report for clock/q' | tac | sed '/Setup/q' | grep -E ' (Source|Setup) '
