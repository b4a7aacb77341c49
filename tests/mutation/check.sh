#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# At least 200 mutants, some in every module that is not a package; the netlist that holds them is read by
# Verilator. usage: check.sh FOLDER
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
"$root/tests/mutation/mutants.py" "$1" >"$1.log"
cat "$1.log"
mutants=$(grep -oE '^[0-9]+' "$1.log")
modules=$(grep -oE 'in [0-9]+' "$1.log" | tr -dc 0-9)
want=$(($(ls "$root"/rtl/*.sv | wc -l) - 1))
[ "$mutants" -ge 200 ] || { echo "$mutants mutants; expected 200 or more"; exit 1; }
[ "$modules" -eq "$want" ] || { echo "mutants in $modules modules; expected all $want"; exit 1; }
verilator --lint-only -Wno-fatal "$1/rtl/trihedron_top.sv" --top trihedron_top >/dev/null 2>&1
