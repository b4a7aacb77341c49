#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cell counts of an AMD 7-series or Lattice ECP5 netlist from Yosys' `stat`, summed over the hierarchy.

usage: cells.py STAT_FILE TOP [DEPTH]    one line for TOP and each module down to DEPTH levels below it
Block RAM counts in units of 18 kbit (AMD) or 16 kbit (ECP5); LUTs used as memory, shift register or for
two bits of a carry chain count as LUTs.
"""
import collections
import re
import sys

LUTS = {
    **{f"LUT{inputs}": 1 for inputs in range(1, 7)},
    **{"SRL16E": 1, "SRLC32E": 1, "RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2},
    **{"RAM128X1D": 4, "CCU2C": 2, "TRELLIS_DPR16X4": 4},
}
BLOCK_RAMS = {"RAMB18E1": 1, "RAMB36E1": 2, "DP16KD": 1}


def plain(name):
    """view_pipeline of $paramod$0123abcd\\view_pipeline or $paramod\\view_pipeline\\MaxWidthPx=..."""
    parts = name.lstrip("\\").split("\\")
    return parts[0] if not parts[0].startswith("$paramod") else parts[1]


def read(path):
    """Cells of each module: {module: {type: number}}, sub-modules among the types."""
    modules, current = {}, None
    for line in open(path):
        if header := re.match(r"=== (.*) ===$", line):
            current = modules.setdefault(header[1], collections.Counter())
        elif current is not None and (row := re.match(r" {5,}(\S+) +(\d+)$", line)):
            current[row[1]] += int(row[2])
    return modules


def total(modules, name):
    """LUTs, flip-flops, block RAMs and DSPs of a module with all below it."""
    sums = collections.Counter()
    for cell, number in modules[name].items():
        if cell in modules:
            below = total(modules, cell)
        else:
            flip_flop = cell in ("FDRE", "FDSE", "FDCE", "FDPE", "TRELLIS_FF")
            below = {"LUT": LUTS.get(cell, 0), "FF": int(flip_flop),
                     "block RAM": BLOCK_RAMS.get(cell, 0), "DSP": int("DSP" in cell or "MULT" in cell)}
        for key, value in below.items():
            sums[key] += number * value
    return sums


def show(modules, name, depth, level=0):
    sums = total(modules, name)
    columns = "  ".join(f"{key} {sums[key]:5d}" for key in ("LUT", "FF", "block RAM", "DSP"))
    print(f"{'  ' * level + plain(name):28} {columns}")
    if level < depth:
        for cell in modules[name]:
            if cell in modules and total(modules, cell)["FF"] + total(modules, cell)["LUT"] > 0:
                show(modules, cell, depth, level + 1)


def main():
    path, top = sys.argv[1:3]
    modules = read(path)
    found = [name for name in modules if plain(name) == top]
    if not found:
        sys.exit(f"cells.py: {path} has no module {top}")
    show(modules, found[0], int(sys.argv[3]) if len(sys.argv) > 3 else 0)


main()
