#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every RTL module as its own top: Verilator with all warnings, then Icarus and Yosys must read it.
# Illegal parameters must stop each of the three with a message that names the legal range.
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

# module parameter=illegal_value
for case in line_window:MaxWidthPx=4 frame_guard:MaxHeightPx=4096 gradient:FractionBits=7 \
  stream_fifo:Depth=6 trihedron_top:Views=0; do
  module=${case%%:*}
  setting=${case#*:}
  parameter=${setting%%=*}
  value=${setting#*=}
  for tool in verilator iverilog yosys; do
    case $tool in
      verilator) set -- --lint-only "-G$setting" $package "$module.sv" -y . --top "$module" ;;
      iverilog) set -- -g2012 -t null "-P$module.$setting" -s "$module" $sources ;;
      yosys) set -- -q -p "read_verilog -sv $sources
hierarchy -check -top $module -chparam $parameter $value" ;;
    esac
    if $tool "$@" >"$log" 2>&1; then fail "$tool accepts $module with $setting"; fi
    grep -q "illegal_.*$parameter" "$log" ||
      fail "$tool does not name the legal range of $module.$parameter: $(head -1 "$log")"
  done
done
[ $status -ne 0 ] || echo "lint: $(echo "$modules" | wc -l) modules clean"
exit $status
