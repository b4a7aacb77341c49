#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Places and routes one view with 512 px lines on an iCE40 HX8K (hx8k_view) and prints what it uses and
# how fast it is, for N placements: placement is luck, so one figure says little.
# usage: hx8k.sh [--check] [--seeds N] [OUT_DIR]      default: 1 build/synth
#   --check  simulates the netlist beside the RTL first (netlist_tb), in Icarus
# Clock rate per seed and lowest, median, highest; then the slowest registers by module, of the first seed.
#
# The eight cells of a tile share clock enable and reset: each set of them that only a few registers have
# costs most of a tile, and a device as full as this one cannot be placed. So enables of less than 8 and
# resets of less than 10 registers become logic: docs/decisions.md has the figures. ABC9, which knows the delays
# of memories and carry chains, maps the rest.
set -eu
cd "$(dirname "$0")/../.."
seeds=1 check=
[ "${1:-}" != --check ] || { check=1; shift; }
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
  synth_ice40 -dff -abc9 -top hx8k_view -run begin:map_ffs
  dfflegalize -mince 8 -minsrst 10 -cell \$_DFF_?_ 0 -cell \$_DFFE_?P_ 0 -cell \$_SDFF_?P?_ 0 -cell \$_SDFFCE_?P?P_ 0
  synth_ice40 -dff -abc9 -run map_ffs: -json $out/hx8k.json
  tee -q -o $out/hx8k.stat stat
  rename hx8k_view hx8k_netlist
  write_verilog -noattr $out/hx8k.v" 2>/dev/null
grep -E 'SB_(LUT4|DFF|CARRY|RAM)' "$out/hx8k.stat"
if [ -n "$check" ]; then
  sed -i "s/256'hx*/256'h0/" "$out/hx8k.v"  # memories begin with 0, as registers do in cells_sim.v
  cells=$(dirname "$(command -v yosys)")/../share/yosys/ice40/cells_sim.v
  iverilog -g2012 -gno-assertions -DNO_ICE40_DEFAULT_ASSIGNMENTS -s netlist_tb -o "$out/hx8k.vvp" $sources \
    bench/synth/hx8k_view.sv bench/synth/netlist_tb.sv "$out/hx8k.v" "$cells" 2>"$out/hx8k.iverilog"
  vvp -n "$out/hx8k.vvp" | tee "$out/hx8k.equal"
  grep -q '^netlist equal' "$out/hx8k.equal"
fi

: >"$out/hx8k.rates"
for seed in $(seq "$seeds"); do
  name=$out/hx8k-$seed
  # Some two minutes of processor time; a router that is still at it after half an hour never ends.
  timeout 1800 nextpnr-ice40 --hx8k --package ct256 --pcf-allow-unconstrained --json "$out/hx8k.json" \
    --freq 150 --seed "$seed" --timing-allow-fail --report "$name.json" --detailed-timing-report \
    >"$name.pnr" 2>&1 || { tail -3 "$name.pnr"; echo "seed $seed: no placement"; continue; }
  [ "$seed" -ne 1 ] || grep -E 'ICESTORM_(LC|RAM)' "$name.pnr"
  rate=$(sed -n 's/.*Max frequency for clock.*: \([0-9.]*\) MHz.*/\1/p' "$name.pnr" | tail -1)
  echo "seed $seed: $rate MHz"
  echo "$rate" >>"$out/hx8k.rates"
done
sort -n "$out/hx8k.rates" | awk '{ rate[NR] = $1 }
  END { printf "%d placements: lowest %.0f, median %.0f, highest %.0f MHz\n", NR, rate[1],
               (rate[int((NR + 1) / 2)] + rate[int(NR / 2) + 1]) / 2, rate[NR] }'
[ -s "$out/hx8k.rates" ]
bench/synth/slowest.py "$(ls "$out"/hx8k-*.json | head -1)"
