#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Area of one view (view_pipeline) for an AMD 7-series and a Lattice ECP5 part: the whole for each line
# width, then its modules for the last width, synthesized apart.
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

# area FAMILY WIDTH DEPTH: the whole view (DEPTH 0, flattened) or its modules.
area() {
  name=$out/$1-$2-$3
  flatten=-flatten
  [ "$3" = 0 ] || flatten=
  case $1 in
    xilinx)
      synth="synth_xilinx -nodsp $flatten -top view_pipeline"
      memories=map_memory
      in_luts='setattr -set ram_style "distributed" t:$mem_v2 c:*i_second_contour.* %i'
      [ "$3" = 0 ] || in_luts='setattr -set ram_style "distributed" t:$mem_v2 r:WIDTH=4 %i'
      ;;
    ecp5)
      synth="synth_ecp5 -nodsp $([ "$3" = 0 ] || echo -noflatten) -top view_pipeline"
      memories=map_ram
      in_luts=
      ;;
  esac
  yosys -q -l "$name.log" -p "read_verilog -noassert -sv $sources
    chparam -set MaxWidthPx $2 view_pipeline
    $synth -run begin:$memories
    $in_luts
    $synth -run $memories:
    tee -q -o $name.stat stat" >/dev/null 2>&1 || { tail -3 "$name.log"; exit 1; }
  echo "== $1, $2 px"
  bench/synth/cells.py "$name.stat" view_pipeline "$3"
}

yosys -V
for width in $widths; do
  area xilinx "$width" 0
  area ecp5 "$width" 0
done
area xilinx "$width" 2
area ecp5 "$width" 2
