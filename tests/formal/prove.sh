#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Proves the properties of this folder for all time, then breaks the RTL on purpose, once per line of
# breaks.txt, and requires a counterexample each time.
# usage: prove.sh [--quick] [PROOF ...]     --quick leaves out what takes longer than some seconds
#        prove.sh --mutant COMMANDS PROOF   whether Yosys's COMMANDS, given each module as it was read,
#                                           make a counterexample
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
mutate=
near=20 far=300
[ "${1:-}" = --mutant ] && { mutate="$2;" near=8 far=12; shift 2; }
trap 'rm -rf "$work"' EXIT
status=0
slots="tests/formal/slot_stream.sv tests/formal/assumed_slots.sv"  # streams of row slots at an input
stages="gradient first_contour ridge second_contour vertex_value"
long="view contour_packer vertex_packer vertex_peak slot_tracker line_window line_window_side line_window_11"
all="skid_buffer shift_fifo stream_fifo stream_merge axil_slave register_bank credit idle_timer drain_count \
  row_slots frame_guard \
  frame_guard_good $stages $long"
quick=
[ "${1:-}" = --quick ] && { quick=1; all=${all%"$long"}; shift; }

# The number of clocks behind $1 in the line on latency at the head of module $2.
clocks() {
  sed -nE "s#^// Latency 2 rows \\+ 2 .*$1([0-9]+).*#\1#p" "rtl/$2.sv"
}

# All RTL but module $1, the package first.
all_but() {
  echo "rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v -e trihedron_registers -e "/$1.sv" | tr '\n' ' ')"
}

# stage NAME NUMBER VOIDS: its clocks are those that its header states; arithmetic is cut out.
stage() {
  properties=stage others="$slots $(all_but "$1")"
  slot=$(clocks 'columns \+ ' "$1") data=$(clocks 'data_o ' "$1")
  parameters="chparam -set Stage $2 -set Voids $3 -set Clocks $slot -set DataClocks ${data:-$slot} stage_properties;"
  cut="cutpoint =*derivatives* =*scale5* =*neighbour_mean* =*vertex_ring* =*vertex_turn*;"
}

# Of each proof: the module it is about, what else it reads, its parameters, its engine, what is cut
# out of the netlist.
describe() {
  module=$1 parameters= steady= engine=pdr cut=
  others="tests/formal/queue_properties.sv rtl/line_memory.sv"
  properties=$1
  case $1 in
    frame_guard*)
      module=frame_guard properties=frame_guard engine=induction
      others="tests/formal/wire_skid_buffer.sv rtl/line_checks.sv rtl/idle_timer.sv rtl/pixel_ring.sv \
        rtl/line_memory.sv"
      parameters="chparam -set Good 0 frame_guard_properties;"
      if [ "$1" != frame_guard ]; then parameters="chparam -set Good 1 frame_guard_properties;"; fi
      ;;
    idle_timer) engine=induction others= ;;
    drain_count) engine=induction others= ;;
    row_slots)
      engine=induction
      steady="chparam -set Steady 1 row_slots_properties;"
      others="rtl/shift_fifo.sv rtl/drain_count.sv tests/formal/slot_stream.sv"
      ;;
    credit) module=stream_fifo others=rtl/line_memory.sv ;;
    slot_tracker) others="rtl/row_limit.sv $slots" ;;
    line_window*)
      module=line_window properties=line_window
      others="rtl/line_memory.sv rtl/row_limit.sv rtl/slot_tracker.sv $slots"
      case $1 in
        *_side) parameters="chparam -set SideRows 0 line_window_properties;" ;;
        *_11) parameters="chparam -set Rows 11 line_window_properties;" ;;
      esac
      ;;
    gradient) stage "$1" 0 11 ;;
    first_contour) stage "$1" 1 8 ;;
    ridge) stage "$1" 2 6 ;;
    second_contour) stage "$1" 3 4 ;;
    vertex_value) stage "$1" 4 2 ;;
    contour_packer) others="rtl/line_memory.sv rtl/stream_fifo.sv" ;;
    vertex_peak)  # that a vertex lies in its frame follows from its scores
      others="$slots $(all_but vertex_peak)"
      cut="chformal -assert -remove =*paramod*vertex_peak*; cutpoint =*vertex_ring* =*vertex_score*;"
      ;;
    vertex_packer)
      engine=induction
      others="tests/formal/open_memory.sv rtl/stream_fifo.sv"
      ;;
    view)
      module=trihedron_top others=$(all_but trihedron_top)
      cut="cutpoint =*contours* =*vertices* =*line_memory*; chformal -assert2assume =*stream_fifo*
        chformal -assert -remove =*packer* =*guard* =*slots* =*merge* =*axil* =*bank* =*ring* =*skid* =*shift* =*checks*;"
      ;;
  esac
  top=${properties}_properties
}

# Asserts hold where they are written, not one clock later (chformal), so that they help each other.
elaborate() {
  printf "%s\n" "read_verilog -formal -sv $others $1 tests/formal/$top.sv
    $parameters hierarchy -check -top $top; proc; $mutate $cut flatten; chformal -early
    memory -nomap; memory_map -formal; opt; async2sync"
}

aiger() {
  yosys -q -p "$(elaborate "$1")
    formalff -clk2ff -ff2anyinit; setundef -undriven -anyseq; opt_clean
    techmap; simplemap; dffunmap; abc -g AND -fast; opt_clean
    write_aiger -I -B -zinit $work/$top.aig" 2>/dev/null
}

# proved FILE: true when the properties hold for all time.
proved() {
  if [ $engine = induction ]; then
    yosys -p "$(elaborate "$1"); setundef -undriven -anyseq; opt_clean; dffunmap
      sat -prove-asserts -set-assumes -tempinduct -maxsteps 2" |
      grep -q "Induction step proven: SUCCESS"
  else
    aiger "$1"
    yosys-abc -q "read_aiger $work/$top.aig; fold; strash; scorr; orpos; pdr -T 900" 2>&1 |
      grep -q "Property proved"
  fi
}

# refuted FILE: true when there is a counterexample: far with inputs that follow a rule, near with any
# (BMC), far (PDR).
refuted() {
  [ -n "$steady" ] && (parameters=$steady && aiger "$1" && searched "bmc3 -F 300 -T $near") && return 0
  aiger "$1"
  searched "bmc3 -F 150 -T $near" || searched "pdr -T $far"
}

searched() {
  yosys-abc -q "read_aiger $work/$top.aig; fold; strash; scorr; orpos; $1" 2>&1 | grep -q "was asserted"
}

# The module's file and the others, with the broken one in its place.
in_place_of() {
  first=$(echo "rtl/$module.sv" | sed "s#rtl/$1.sv#$work/$1.sv#")
  others=$(echo "$others" | sed "s#rtl/$1.sv#$work/$1.sv#")
}

for proof in ${*:-$all}; do
  describe "$proof"
  [ -f "tests/formal/$top.sv" ] || { echo "$proof: no such proof; there are: $all"; exit 2; }
  if [ -n "$mutate" ]; then
    refuted "rtl/$module.sv" && { echo "$proof: refuted"; exit 0; }
    echo "$proof: no counterexample"
    exit 1
  fi
  if proved "rtl/$module.sv"; then
    echo "$proof: proved"
  else
    echo "$proof: NOT PROVED"
    status=1
  fi
  grep "^$proof;" tests/formal/breaks.txt >"$work/breaks" || { echo "$proof: no break"; status=1; }
  [ -z "$quick" ] || sed -i 1q "$work/breaks"
  while IFS=';' read -r _ what expression; do
    file=$module  # "what" may begin with another one that the proof reads
    case $what in *": "*) file=${what%%: *} ;; esac
    sed -E "$expression" "rtl/$file.sv" >"$work/$file.sv"
    describe "$proof"
    if cmp -s "rtl/$file.sv" "$work/$file.sv"; then
      echo "$proof, $what: THE BREAK CHANGES NOTHING"
      status=1
    elif in_place_of "$file" && refuted "$first"; then
      echo "$proof, $what: refuted"
    else
      echo "$proof, $what: NOT REFUTED"
      status=1
    fi
  done <"$work/breaks"
done
exit $status
