#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A reset decides everything: reset_tb with unknown registers and memories in Icarus, with
# random ones in Verilator; no unknown leaves a port and all runs agree.
# Then a reset is taken out of the RTL, which must show.
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# All modules in FOLDER, the package first.
sources() {
  echo "$1/trihedron_registers.sv $(ls "$1"/*.sv | grep -v trihedron_registers | tr '\n' ' ')"
}

# icarus FOLDER: true when the run ends well; its output in $work/icarus.
icarus() {
  iverilog -g2012 -o "$work/reset" -s reset_tb $(sources "$1") tests/reset/reset_tb.sv 2>"$work/log" ||
    { cat "$work/log"; exit 1; }
  vvp -n "$work/reset" >"$work/icarus" && ! grep -q ERROR "$work/icarus"
}

cp -r rtl "$work/broken"
sed -i "s/rows_q <= '0;/rows_q <= rows_q;/" "$work/broken/slot_tracker.sv"
if cmp -s rtl/slot_tracker.sv "$work/broken/slot_tracker.sv" || icarus "$work/broken"; then
  echo "reset.sh: slot_tracker without its reset is not noticed"
  exit 1
fi
icarus rtl || { cat "$work/icarus"; exit 1; }

verilator --binary --timing --assert -Wno-fatal -Wno-lint --x-initial unique --x-assign unique \
  -CFLAGS -O0 --Mdir "$work/verilated" --top reset_tb $(sources rtl) tests/reset/reset_tb.sv \
  >"$work/log" 2>&1 || { tail -20 "$work/log"; exit 1; }
for seed in 1 2 3; do
  "$work/verilated/Vreset_tb" +verilator+rand+reset+2 +verilator+seed+$seed >"$work/random" ||
    { cat "$work/random"; exit 1; }
  grep '^reset:' "$work/random" | cmp - "$work/icarus" ||
    { echo "Icarus and Verilator (seed $seed) differ:"; cat "$work/icarus" "$work/random"; exit 1; }
done
cat "$work/icarus"
