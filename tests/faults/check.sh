#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every register of the RTL, by the naming rule, is among the flip-flops that Yosys finds, but those that
# only assertions read. usage: check.sh OUT.vlt
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
"$root/tests/faults/flip_flops.py" "$1"
status=0
for file in "$root"/rtl/*.sv; do
  module=$(basename "$file" .sv)
  for name in $(grep -oE '\b[a-z0-9_]+_q\b *(\[[^]]*\])? *<=' "$file" | grep -oE '^[a-z0-9_]+' | sort -u); do
    case $name in *held_q | *held_data_q | r_data_q | moved_q) continue ;; esac
    grep -q "module \"$module\" -var \"$name\"" "$1" || { echo "$module.$name: not found"; status=1; }
  done
done
exit $status
