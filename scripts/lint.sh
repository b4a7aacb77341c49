#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every RTL module as its own top: Verilator with all warnings, then Icarus and Yosys must read it.
# Illegal parameters: tests/rtl/illegal_parameters.sh.
set -eu
cd "$(dirname "$0")/../rtl"
package=trihedron_registers.sv
modules=$(for file in *.sv; do [ "$file" = $package ] || echo "${file%.sv}"; done)
sources="$package $(for module in $modules; do printf '%s.sv ' "$module"; done)"
status=0

fail() {
  echo "lint: $*" >&2
  status=1
}

for module in $modules; do
  verilator --lint-only -Wall lint.vlt $package "$module.sv" -y . --top "$module" ||
    fail "$module: Verilator warns"
done

log=$(mktemp)
trap 'rm -f "$log"' EXIT
iverilog -g2012 -t null -Wall -Wno-timescale -s trihedron_top $sources >"$log" 2>&1 || status=1
# Icarus 11 says of every assert that it "cannot be synthesized", which is right and intended.
if grep -v "cannot be synthesized in an always_ff process" "$log"; then fail "Icarus warns"; fi
yosys -q -p "read_verilog -sv $sources; hierarchy -check -top trihedron_top; proc; check -assert" \
  >"$log" 2>&1 || { cat "$log"; fail "Yosys does not read it"; }

[ $status -ne 0 ] || echo "lint: $(echo "$modules" | wc -l) modules clean"
exit $status
