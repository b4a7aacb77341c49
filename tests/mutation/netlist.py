# SPDX-License-Identifier: Apache-2.0
"""The cells of a netlist in Yosys's RTLIL, found again by where they come from in the RTL."""

import collections
import pathlib
import re

Cell = collections.namedtuple("Cell", "module name origin")


def base_name(module):
    """frame_guard of $paramod$<hash>\\frame_guard and $paramod\\frame_guard\\Width=..."""
    return [p for p in module.split("\\") if p and not p.startswith("$paramod")][0]


def cells(path):
    """All cells of the RTLIL file, in its order. An origin is the same in every elaboration of the same
    source: module, type, source places and how many such cells came before it in the module."""
    found, before = [], collections.Counter()
    module = source = ""
    for line in pathlib.Path(path).read_text().splitlines():
        if line.startswith("module "):
            module = line.split()[1]
            before.clear()
        elif match := re.match(r'\s*attribute \\src "(.*)"', line):
            source = re.sub(r"[^|]*/", "", match[1])
        elif match := re.match(r"\s+cell (\S+) (\S+)", line):
            kind = (match[1], source)
            found.append(Cell(module, match[2], (base_name(module), *kind, before[kind])))
            before[kind] += 1
            source = ""
        elif line.strip() and not line.lstrip().startswith("attribute"):
            source = ""
    return found
