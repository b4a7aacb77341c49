#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves that a mutant is the same design: no input, from a reset on, makes the outputs of the module and of
its mutated copy differ. Once more inside the module that instantiates it, where some inputs are constants and
some outputs are not used. An instance whose port is mutated is looked into. What is proved cannot be killed.

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


def instantiated(design, module, name):
    """The module of which cell `name` is an instance; "" for a cell of Yosys's own."""
    for cell in netlist.cells(design):
        if cell.module.lstrip("\\") == module.lstrip("\\") and cell.name.lstrip("\\") == name.lstrip("\\"):
            kind = cell.origin[1]
            return kind if kind.startswith(("\\", "$paramod")) else ""
    return ""


def parents(design, module):
    """Modules that instantiate `module`."""
    found, current = [], ""
    for line in design.read_text().splitlines():
        if line.startswith("module "):
            current = line.split()[1]
        elif re.match(r"\s+cell ", line) and line.split()[1] == module and current not in found:
            found.append(current)
    return found


def proved(folder, mutant):
    """Where the mutant makes no difference: "in itself", "in PARENT", or "" when not proved."""
    design = folder / "design.il"
    module = mutant["command"].split("-module ")[1].split()[0]
    modules = f"{module} {instantiated(design, module, mutant['cell'])}"
    if same(design, modules, module, mutant["command"]):
        return "in itself"
    above = parents(design, module)
    if above and all(same(design, modules, top, mutant["command"]) for top in above):
        names = [re.sub(r".*\\", "", re.sub(r"\\[A-Za-z]+=.*", "", top)) for top in above]
        return "in " + " and ".join(sorted(set(names)))
    return ""


def main():
    folder = pathlib.Path(sys.argv[1])
    mutants = {m["id"]: m for m in json.loads((folder / "mutants.json").read_text())}
    for word in sys.argv[2:]:
        print(word, proved(folder, mutants[int(word)]) or "not proved", flush=True)


if __name__ == "__main__":
    main()
