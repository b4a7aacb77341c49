#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every signal of sim/trihedron.gtkw is in a waveform that the simulation writes.

usage: check_waves.py PROGRAM   needs fst2vcd of Debian's gtkwave; exit code 77 without it
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def names_in(fst):
    """Full names, with their range, of the signals in the waveform's header."""
    names, scopes = set(), []
    with subprocess.Popen(["fst2vcd", "-f", fst], stdout=subprocess.PIPE, text=True) as vcd:
        for line in vcd.stdout:
            words = line.split()
            if line.startswith("$scope"):
                scopes.append(words[2])
            elif line.startswith("$upscope"):
                scopes.pop()
            elif line.startswith("$var"):
                names.add(".".join(scopes + [words[4]]) + (words[5] if words[5] != "$end" else ""))
            elif line.startswith("$enddefinitions"):
                break
        vcd.kill()
    return names


def main():
    if not shutil.which("fst2vcd"):
        print("no fst2vcd (gtkwave is not installed): not checked")
        sys.exit(77)
    wanted = [line for line in (ROOT / "sim/trihedron.gtkw").read_text().split("\n")
              if re.match(r"[a-z_]+\.", line)]
    with tempfile.TemporaryDirectory() as folder:
        image, fst = Path(folder) / "image.pgm", Path(folder) / "waves.fst"
        image.write_text("P2 6 6 255\n" + "9 " * 36 + "\n")
        subprocess.run([sys.argv[1], "simulate", image, "--trace", fst, "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        there = names_in(fst)
    missing = [name for name in wanted if name not in there]
    for name in missing:
        print(f"sim/trihedron.gtkw: no signal {name} in the waveform")
    print(f"{len(wanted)} signals, {len(missing)} missing")
    sys.exit(1 if missing or not wanted else 0)


main()
