#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves that a mutant is the same design: no input, from a reset on, makes the outputs of the module and of
its mutated copy differ. Else once more inside the modules that instantiate it, up to two levels above, where some
inputs are constants and some outputs are not used. An instance whose port is mutated is looked into. What is
proved cannot be killed.

usage: equivalence.py FOLDER ID...   FOLDER is that of mutants.py
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

import netlist

PDR_S, TIMEOUT_S = 15, 120


def prepare(design, modules, top, mutate, name):
    """The module `top` with `modules` flattened into it; all other instances become ports."""
    return (f"read_rtlil {design}\n{mutate}\nhierarchy -top {top}\n"
            f"setattr -mod -set keep_hierarchy 1 *\nsetattr -mod -unset keep_hierarchy {modules} {top}\n"
            f"flatten {top}\ncd {top}\nexpose -evert c:*\ncd ..\nselect -set rest * {top} %d\ndelete @rest\n"
            f"memory -nomap\nmemory_map\nopt_clean\n"
            f"rename {top} {name}\ndesign -stash {name}\ndesign -reset\n")


def same(design, modules, top, command):
    """Both begin with all registers 0 and see the same inputs, rst_ni among them."""
    with tempfile.TemporaryDirectory() as folder:
        aiger = f"{folder}/pair.aig"
        script = (prepare(design, modules, top, "", "gold") + prepare(design, modules, top, command, "gate") +
                  "design -copy-from gold -as gold gold\ndesign -copy-from gate -as gate gate\n"
                  "miter -equiv -flatten -make_assert gold gate pair\nhierarchy -top pair\n"
                  "setundef -undriven -init -zero\nsetundef -zero\nopt_clean\ndffunmap\ntechmap\nsimplemap\n"
                  f"abc -g AND -fast\nopt_clean\nwrite_aiger -zinit {aiger}\n")
        file = pathlib.Path(folder) / "pair.ys"
        file.write_text(script)
        prove = f"read_aiger {aiger}; strash; scorr; orpos; pdr -T {PDR_S}"
        try:
            subprocess.run(["yosys", "-q", file], capture_output=True, timeout=TIMEOUT_S, check=True)
            run = subprocess.run(["yosys-abc", "-q", prove], capture_output=True, text=True, timeout=TIMEOUT_S)
        except (subprocess.TimeoutExpired, subprocess.CalledProcessError):
            return False
        return "Property proved" in run.stdout


def plain(name):
    """Yosys writes names of the source with a backslash in front, but not everywhere."""
    return name.lstrip("\\")


def instantiated(design, module, name):
    """The module of which cell `name` is an instance; "" for a cell of Yosys's own."""
    for cell in netlist.cells(design):
        if (plain(cell.module), plain(cell.name)) == (plain(module), plain(name)):
            kind = cell.origin[1]
            return kind if kind.startswith(("\\", "$paramod")) else ""
    return ""


def parents(design, module):
    """Modules that instantiate `module`."""
    found, current = [], ""
    for line in design.read_text().splitlines():
        if line.startswith("module "):
            current = line.split()[1]
        elif re.match(r"\s+cell ", line) and plain(line.split()[1]) == plain(module) and current not in found:
            found.append(current)
    return found


def hidden(design, modules, top, command, levels):
    """The modules, `top` or those so many levels above it, that the mutant does not leave; [] if it does."""
    if same(design, modules, top, command):
        return [netlist.base_name(top)]
    found = []
    for parent in parents(design, top) if levels else []:
        here = hidden(design, f"{modules} {parent}", parent, command, levels - 1)
        if not here:
            return []
        found += here
    return found


def proved(folder, mutant):
    """Where the mutant makes no difference: "in MODULE", or "" when not proved."""
    design = folder / "design.il"
    module = mutant["command"].split("-module ")[1].split()[0]
    modules = f"{module} {instantiated(design, module, mutant['cell'])}"
    places = hidden(design, modules, module, mutant["command"], 2)
    return "in " + " and ".join(sorted(set(places))) if places else ""


def main():
    folder = pathlib.Path(sys.argv[1])
    mutants = {m["id"]: m for m in json.loads((folder / "mutants.json").read_text())}
    for word in sys.argv[2:]:
        print(word, proved(folder, mutants[int(word)]) or "not proved", flush=True)


if __name__ == "__main__":
    main()
