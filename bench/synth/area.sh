#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Area for an AMD 7-series and a Lattice ECP5 part: one view (view_pipeline) for each line width, then
# its modules for the last width, each as its own top.
# usage: area.sh [OUT_DIR] [WIDTH ...]      default: build/synth 640 1280 1920
# The narrowest line memory, 4 bits in second_contour, goes into LUTs on AMD parts: a block RAM would be
# filled to two fifths.
set -eu
cd "$(dirname "$0")/../.."
out=${1:-build/synth}
[ $# -gt 0 ] && shift
widths=${*:-640 1280 1920}
mkdir -p "$out"
sources="rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v trihedron_registers | tr '\n' ' ')"

# area FAMILY WIDTH MODULE: one line of cell counts. Block RAM in units of 18 kbit (AMD) or 16 kbit (ECP5).
area() {
  name=$out/$1-$3-$2
  in_luts="setattr -set ram_style \"distributed\" t:\$mem_v2 c:*i_second_contour.* %i"
  [ "$3" = second_contour ] && in_luts="setattr -set ram_style \"distributed\" t:\$mem_v2"
  case $1 in
    xilinx) synth="synth_xilinx -nodsp -flatten -top $3" memories=map_memory ;;
    ecp5) synth="synth_ecp5 -nodsp -top $3" memories=map_ram in_luts= ;;
  esac
  width="chparam -set MaxWidthPx $2 $3"
  case $3 in contour_packer | vertex_packer) width= ;; esac
  yosys -q -l "$name.log" -p "read_verilog -noassert -sv $sources
    $width
    $synth -run begin:$memories
    $in_luts
    $synth -run $memories:
    tee -q -o $name.stat stat" >/dev/null 2>&1 || { tail -3 "$name.log"; exit 1; }
  awk -v label="$1 $2 px $3" '/^ +[A-Z]/ {
    if ($1 ~ /^(LUT[1-6]|LUT4|SRL.*)$/) luts += $2
    if ($1 == "CCU2C") luts += 2 * $2
    if ($1 == "RAM64M" || $1 == "RAM32M" || $1 == "TRELLIS_DPR16X4") luts += 4 * $2
    if ($1 == "RAM64X1D" || $1 == "RAM32X1D") luts += 2 * $2
    if ($1 == "RAM128X1D") luts += 4 * $2
    if ($1 ~ /^FD|^TRELLIS_FF$/) ffs += $2
    if ($1 == "RAMB18E1" || $1 == "DP16KD") bram += $2
    if ($1 == "RAMB36E1") bram += 2 * $2
    if ($1 ~ /DSP|MULT/) dsp += $2
  } END { printf "%-36s LUT %5d  FF %5d  block RAM %3d  DSP %d\n", label, luts, ffs, bram, dsp }' "$name.stat"
}

yosys -V
for width in $widths; do
  area xilinx "$width" view_pipeline
  area ecp5 "$width" view_pipeline
done
for module in frame_guard row_slots gradient slope first_contour ridge second_contour vertices \
  contour_packer vertex_packer; do
  area xilinx "$width" $module
  area ecp5 "$width" $module
done
