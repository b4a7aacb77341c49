#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Proves the properties of this folder for all time with PDR (yosys-abc), those of frame_guard for
# the first 30 clocks, then breaks the RTL on purpose and requires that each proof fails.
# usage: prove.sh [MODULE ...]
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# prove NAME MODULE_FILE: prints what PDR concludes.
prove() {
  yosys -q -p "read_verilog -formal -sv rtl/line_memory.sv $2 \
      tests/formal/queue_properties.sv tests/formal/$1_properties.sv
    hierarchy -check -top $1_properties; proc; flatten; memory -nomap; memory_map -formal; opt
    async2sync; formalff -clk2ff -ff2anyinit; setundef -undriven -anyseq; opt_clean
    techmap; simplemap; dffunmap; abc -g AND -fast; opt_clean
    write_aiger -I -B -zinit $work/$1.aig"
  yosys-abc -q "read_aiger $work/$1.aig; fold; strash; pdr -T 300; print_status" 2>&1 |
    grep -oE 'Status = +-?[0-9]+' | grep -oE -- '-?[0-9]+$'
}

# bounded NAME MODULE_FILE GOOD: 1 if no property fails in 30 clocks, 0 if one does.
bounded() {
  yosys -q -p "read_verilog -formal -sv tests/formal/wire_skid_buffer.sv $2 \
      tests/formal/$1_properties.sv
    hierarchy -check -top $1_properties -chparam Good $3; proc; flatten; opt
    async2sync; formalff -clk2ff -ff2anyinit; setundef -undriven -anyseq; opt_clean
    techmap; simplemap; dffunmap; abc -g AND -fast; opt_clean
    write_aiger -I -B -zinit $work/$1.aig"
  log=$(yosys-abc -q "read_aiger $work/$1.aig; fold; strash; scorr; bmc3 -F 30" 2>&1)
  case $log in
    *"was asserted"*) echo 0 ;;
    *"No output asserted in 30 frames"*) echo 1 ;;
    frame_guard) check_bounded frame_guard 's/\? col_is_width_q \&\& !rows_is_max_q/? !rows_is_max_q/' ;;
    *) echo -1 ;;
  esac
}

# check_bounded NAME SED_EXPRESSION: any input and good input; the broken one with any input.
check_bounded() {
  any=$(bounded "$1" "rtl/$1.sv" 0)
  good=$(bounded "$1" "rtl/$1.sv" 1)
  sed -E "$2" "rtl/$1.sv" >"$work/$1.sv"
  cmp -s "rtl/$1.sv" "$work/$1.sv" && { echo "$1: the break changes nothing"; status=1; }
  broken=$(bounded "$1" "$work/$1.sv" 0)
  if [ "$any$good$broken" = 110 ]; then
    echo "$1: holds for 30 clocks; broken on purpose: refuted"
  else
    echo "$1: FAILED (any input $any, good input $good, broken $broken)"
    status=1
  fi
}

# check NAME SED_EXPRESSION: proof of the module, counterexample for the broken one.
check() {
  result=$(prove "$1" "rtl/$1.sv")
  sed -E "$2" "rtl/$1.sv" >"$work/$1.sv"
  cmp -s "rtl/$1.sv" "$work/$1.sv" && { echo "$1: the break changes nothing"; status=1; }
  broken=$(prove "$1" "$work/$1.sv")
  if [ "$result" = 1 ] && [ "$broken" = 0 ]; then
    echo "$1: proved; broken on purpose: refuted"
  else
    echo "$1: FAILED (status $result, broken $broken; 1 proved, 0 refuted, -1 undecided)"
    status=1
  fi
}

for module in ${*:-skid_buffer shift_fifo stream_fifo stream_merge axil_slave frame_guard}; do
  case $module in
    skid_buffer) check skid_buffer 's/if \(!spare_valid_q\) spare_q/spare_q/' ;;
    shift_fifo) check shift_fifo 's/used_after_pop\[i\] \?/used_q[i] ?/' ;;
    stream_merge) check stream_merge 's/above_q <= ~\(grant \| .*/above_q <= above_q;/' ;;
    axil_slave) check axil_slave 's/ else if \(s_axil_rready_i\) s_axil_rvalid_o/ else s_axil_rvalid_o/' ;;
    stream_fifo) check stream_fifo 's/m_tvalid_o <= write_q != read_d/m_tvalid_o <= write_q != read_q/' ;;
    frame_guard) check_bounded frame_guard 's/\? col_is_width_q \&\& !rows_is_max_q/? !rows_is_max_q/' ;;
    *) echo "$module: no properties"; status=1 ;;
  esac
done
exit $status
