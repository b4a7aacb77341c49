#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Area and timing of one view in the OSU standard cells of 0.18, 0.35 and 0.5 um: Yosys maps it, OpenSTA
# times it before layout, without wires. usage: asic.sh [OUT_DIR] [WIDTH] [NODE ...]
#   default: build/synth 1920 osu018 osu035 osu050
# Line memories and FIFOs are SRAM macros and left outside: their pins become ports of the netlist, read data
# arrive SRAM_NS (a third of the period aimed at) after the clock edge. Area counts cells only, in NAND2.
set -eu
cd "$(dirname "$0")/../.."
out=${1:-build/synth}
width=${2:-1920}
[ $# -gt 2 ] && shift 2 || set -- osu018 osu035 osu050
mkdir -p "$out"
tech=${QFLOW_TECH:-/usr/share/qflow/tech}
sources="rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v trihedron_registers | tr '\n' ' ')"
yosys -V
echo "OpenSTA $(sta -version)"
for node in "$@"; do
  case $node in
    osu018) library=osu018_stdcells.lib period=5.0 ;;
    osu035) library=osu035_stdcells.lib period=10.0 ;;
    osu050) library=osu05_stdcells.lib period=14.0 ;;
    *) echo "asic.sh: $node is none of osu018 osu035 osu050" >&2; exit 2 ;;
  esac
  library=$tech/$node/$library
  name=$out/$node-$width
  sram=$(awk "BEGIN { print $period / 3 }")
  printf 'set_driving_cell BUFX2\nset_load 0.05 [all_outputs]\n' >"$name.constr"
  yosys -q -l "$name.log" -p "read_verilog -noassert -sv $sources
    chparam -set MaxWidthPx $width view_pipeline
    hierarchy -top view_pipeline
    blackbox *line_memory*
    synth -flatten -top view_pipeline
    expose -evert t:*line_memory*
    dfflibmap -liberty $library
    abc -liberty $library -constr $name.constr -D $(awk "BEGIN { print $period * 800 }")
    splitnets -ports
    opt_clean -purge
    tee -q -o $name.stat stat -liberty $library
    write_verilog -noattr -noexpr -nohex $name.v" >/dev/null 2>&1 || { tail -3 "$name.log"; exit 1; }
  cat >"$name.tcl" <<STA
read_liberty $library
read_verilog $name.v
link_design view_pipeline
create_clock -name clk -period $period [get_ports clk_i]
set_input_delay 0 -clock clk [get_ports {s_axis_tvalid m_axis_*_tready rst_ni}]
set_input_delay $sram -clock clk [get_ports *rdata_o*]
set_output_delay 0 -clock clk [all_outputs]
report_checks -path_delay max -fields {slew cap fanout} -digits 3
exit
STA
  sta -no_splash -exit "$name.tcl" >"$name.sta" 2>&1
  if grep -m3 '^Error' "$name.sta" || ! grep -q ' slack (' "$name.sta"; then
    echo "asic.sh: OpenSTA has no answer, see $name.sta" >&2
    exit 1
  fi
  nand=$(awk '/cell \(NAND2X1\)/ { inside = 1 } inside && /area/ { gsub(/[;:]/, " "); print $2; exit }' "$library")
  awk -v nand="$nand" -v node="$node" -v period="$period" -v width="$width" '
    FILENAME ~ /stat$/ && /Chip area/ { area = $NF }
    FILENAME ~ /stat$/ && / DFF/ { ffs += $2 }
    FILENAME ~ /sta$/ && / slack \(/ { slack = $1 }
    END { printf "%s, %d px: %d gates (NAND2), %d flip-flops, %.0f MHz\n", node, width, area / nand, ffs,
          1000 / (period - slack) }' "$name.stat" "$name.sta"
done
