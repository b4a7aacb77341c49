#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Area of one view (view_pipeline) for an AMD 7-series and a Lattice ECP5 part: cells per line width.
# usage: area.sh [OUT_DIR] [WIDTH ...]      default: build/synth 640 1280 1920
set -eu
cd "$(dirname "$0")/../.."
out=${1:-build/synth}
[ $# -gt 0 ] && shift
widths=${*:-640 1280 1920}
mkdir -p "$out"
sources="rtl/trihedron_registers.sv $(ls rtl/*.sv | grep -v trihedron_registers | tr '\n' ' ')"
yosys -V
for width in $widths; do
  for family in xilinx ecp5; do
    case $family in
      xilinx) synth="synth_xilinx -nodsp -flatten -top view_pipeline" ;;
      ecp5) synth="synth_ecp5 -nodsp -top view_pipeline" ;;
    esac
    yosys -q -l "$out/$family-$width.log" -p "read_verilog -noassert -sv $sources
      chparam -set MaxWidthPx $width view_pipeline
      $synth
      tee -q -o $out/$family-$width.stat stat" 2>/dev/null
    echo "== $family, $width px"
    awk '/ (LUT|SRL|RAM|FD|CARRY4|DSP|CCU2C|TRELLIS_FF|DP16KD|TRELLIS_DPR|MULT|PFUMX|L6MUX)/ {
      cells[$1] += $2
      if ($1 ~ /^LUT/) luts += $2
      if ($1 ~ /^SRL/) luts += $2
      if ($1 == "RAM64M" || $1 == "RAM32M" || $1 == "TRELLIS_DPR16X4") luts += 4 * $2
      if ($1 == "RAM64X1D" || $1 == "RAM32X1D") luts += 2 * $2
      if ($1 ~ /^FD|_FF$/) ffs += $2
      if ($1 == "RAMB18E1") bram += $2
      if ($1 == "RAMB36E1") bram += 2 * $2
      if ($1 == "DP16KD") bram += $2
      if ($1 ~ /DSP|MULT/) dsp += $2
    } END { printf "LUT %d  FF %d  block RAM %d  DSP %d\n", luts, ffs, bram, dsp }' \
      "$out/$family-$width.stat" 2>/dev/null
  done
done
