#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Each illegal parameter of illegal_parameters.txt must stop Verilator, Icarus and Yosys with a
# message that names the parameter and its legal range; each parameter of each module is in the list.
# usage: illegal_parameters.sh [MODULE ...]   (default: all)
set -u
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../../rtl"
package=trihedron_registers.sv
sources="$package $(ls ./*.sv | grep -v $package | tr '\n' ' ')"
list=$here/illegal_parameters.txt
log=$(mktemp)
trap 'rm -f "$log"' EXIT
status=0
fail() {
  echo "illegal parameters: $*" >&2
  status=1
}

for file in *.sv; do
  for parameter in $(sed -n '/^module/,/^) (/s/.*parameter int *\([A-Za-z]*\) .*/\1/p' "$file"); do
    grep -q "^${file%.sv} $parameter=" "$list" || fail "${file%.sv}.$parameter is not tested"
  done
done

stops() {  # stops MODULE PARAMETER VALUE TOOL...
  module=$1 parameter=$2 value=$3
  shift 3
  if "$@" >"$log" 2>&1; then
    fail "$1 accepts $module with $parameter=$value"
  elif ! grep -q "illegal_.*$parameter" "$log"; then
    fail "$1 does not name the legal range of $module.$parameter: $(head -1 "$log")"
  fi
}

cases=0
while read -r module setting; do
  case " ${*:-$module} " in *" $module "*) ;; *) continue ;; esac
  parameter=${setting%%=*} value=${setting#*=}
  [ -f "$module.sv" ] || { fail "$module: no such module"; continue; }
  stops "$module" "$parameter" "$value" verilator --lint-only -Wno-fatal "-G$setting" $package \
    "$module.sv" -y . --top "$module"
  stops "$module" "$parameter" "$value" iverilog -g2012 -t null "-P$module.$setting" -s "$module" \
    $sources
  case $value in -*) ;; *)  # Yosys reads no negative number from its command line
    stops "$module" "$parameter" "$value" yosys -q -p "read_verilog -sv $sources
chparam -set $parameter $value $module; hierarchy -check -top $module"
  esac
  cases=$((cases + 1))
done <"$list"
[ $status -ne 0 ] || echo "illegal parameters: $cases values stop Verilator, Icarus and Yosys"
exit $status
