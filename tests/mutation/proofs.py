#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds mutants against the proofs of tests/formal: the mutated cell is found again in what a proof
reads, by its place in the RTL, and changed there. A counterexample kills the mutant.

usage: proofs.py FOLDER ID...   FOLDER is that of mutants.py
"""

import functools
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import netlist

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROVE = ROOT / "tests/formal/prove.sh"
# As mutants.py leaves a module before it mutates it.
TIDY = "opt_expr; opt_merge; opt_clean"
# Shortest first; `view` and the window of 11 rows take minutes a mutant and add little.
PROOFS = ("skid_buffer shift_fifo stream_fifo stream_merge axil_slave register_bank credit idle_timer "
          "drain_count row_slots frame_guard frame_guard_good gradient first_contour ridge second_contour "
          "vertex_value contour_packer slot_tracker line_window line_window_side vertex_peak vertex_packer").split()


@functools.lru_cache(maxsize=None)
def cells_of(proof):
    """The cells that a proof reads, by origin; a module may be there with several parameters."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "netlist.il"
        subprocess.run([PROVE, "--mutant", f"{TIDY}; write_rtlil {path}; exit", proof], capture_output=True)
        found = {}
        for cell in netlist.cells(path):
            found.setdefault(cell.origin, []).append(cell)
        return found


@functools.lru_cache(maxsize=None)
def origins(design):
    return {(cell.module, cell.name): cell.origin for cell in netlist.cells(design)}


def commands(mutant, design, proof):
    """What mutates each copy of the mutant's cell in what `proof` reads."""
    module = re.search(r"-module (\S+)", mutant["command"])[1]
    module = module if module.startswith(("$", "\\")) else "\\" + module
    cell = mutant["cell"] if mutant["cell"].startswith(("$", "\\")) else "\\" + mutant["cell"]
    for copy in cells_of(proof).get(origins(design)[module, cell], []):
        to = re.sub(r"-module \S+", lambda _: f"-module {copy.module}", mutant["command"])
        yield re.sub(r"-cell \S+", lambda _: f"-cell {copy.name}", to)


def refuted(proof, mutate):
    return subprocess.run([PROVE, "--mutant", f"{TIDY}; {mutate}", proof], capture_output=True).returncode == 0


@functools.lru_cache(maxsize=None)
def sound(proof):
    """A proof that the RTL itself breaks kills no mutant."""
    return not refuted(proof, "")


def broken(folder, mutant):
    """The proof that a mutant breaks, or ""."""
    for proof in PROOFS:
        for command in commands(mutant, folder / "design.il", proof):
            if refuted(proof, command) and sound(proof):
                return proof
    return ""


def main():
    folder = pathlib.Path(sys.argv[1])
    mutants = {m["id"]: m for m in json.loads((folder / "mutants.json").read_text())}
    for word in sys.argv[2:]:
        print(word, broken(folder, mutants[int(word)]) or "no proof", flush=True)


if __name__ == "__main__":
    main()
