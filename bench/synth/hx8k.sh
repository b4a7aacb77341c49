#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Places and routes one view with 512 px lines on an iCE40 HX8K (hx8k_view) and prints what it uses and
# how fast it is, for N placements: placement is luck, so one figure says little.
# usage: hx8k.sh [--seeds N] [OUT_DIR]      default: 1 build/synth
# Clock rate per seed and lowest, median, highest; then the slowest registers by module, of the first seed.
set -eu
cd "$(dirname "$0")/../.."
seeds=1
if [ "${1:-}" = --seeds ]; then
  seeds=${2:-}
  case $seeds in '' | *[!0-9]* | 0*) echo "hx8k.sh: --seeds needs a number from 1" >&2; exit 2 ;; esac
  shift 2
fi
out=${1:-build/synth}
mkdir -p "$out"
sources="rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v trihedron_registers | tr '\n' ' ')"
yosys -V
nextpnr-ice40 --version 2>&1
yosys -q -l "$out/hx8k.log" -p "read_verilog -noassert -sv $sources bench/synth/hx8k_view.sv
  synth_ice40 -dff -abc2 -top hx8k_view -json $out/hx8k.json
  tee -q -o $out/hx8k.stat stat" 2>/dev/null
grep -E 'SB_(LUT4|DFF|CARRY|RAM)' "$out/hx8k.stat"

: >"$out/hx8k.rates"
for seed in $(seq "$seeds"); do
  name=$out/hx8k-$seed
  # Some two minutes of processor time; a router that is still at it after half an hour never ends.
  timeout 1800 nextpnr-ice40 --hx8k --package ct256 --pcf-allow-unconstrained --json "$out/hx8k.json" \
    --freq 150 --seed "$seed" --timing-allow-fail --report "$name.json" --detailed-timing-report \
    >"$name.pnr" 2>&1 || { tail -3 "$name.pnr"; echo "hx8k.sh: seed $seed failed" >&2; exit 1; }
  [ "$seed" -ne 1 ] || grep -E 'ICESTORM_(LC|RAM)' "$name.pnr"
  rate=$(sed -n 's/.*Max frequency for clock.*: \([0-9.]*\) MHz.*/\1/p' "$name.pnr" | tail -1)
  echo "seed $seed: $rate MHz"
  echo "$rate" >>"$out/hx8k.rates"
done
sort -n "$out/hx8k.rates" | awk '{ rate[NR] = $1 }
  END { printf "%d placements: lowest %.0f, median %.0f, highest %.0f MHz\n", NR, rate[1],
               (rate[int((NR + 1) / 2)] + rate[int(NR / 2) + 1]) / 2, rate[NR] }'
bench/synth/slowest.py "$out/hx8k-1.json"
