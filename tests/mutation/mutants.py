#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a copy of the RTL that holds many mutants at once, and the list of them.

Yosys chooses the mutants (an inverted, constant or copied bit at an input or output of a cell), spread
over all modules and their source lines, and puts each behind a comparison with a number. The number
comes from the environment variable TRIHEDRON_MUTANT, so one Verilated build serves all mutants and every
program that simulates; 0 and no variable are the RTL as it is.
Assertions are left out: mutants are to be found at the ports.
"""

import argparse
import json
import pathlib
import re
import subprocess

import netlist

ROOT = pathlib.Path(__file__).resolve().parents[2]
SELECT = "mutant_selected"
BITS = 12
VARIABLE = r'std::getenv(\"TRIHEDRON_MUTANT\")'
FROM_ENVIRONMENT = f"({VARIABLE} ? std::atoi({VARIABLE}) : 0)"
# Mutants of a module: one for so many cells, within these bounds.
CELLS_PER_MUTANT, FEWEST, MOST = 9, 6, 26
# Clocks are no data; a mutated one is another design style, not another design.
CLOCKS = {"CLK", "RD_CLK", "WR_CLK"}


def yosys(script, out):
    run = subprocess.run(["yosys", "-q", "-l", out / "yosys.log", "-"], input=script, text=True,
                         capture_output=True)
    if run.returncode != 0:
        raise SystemExit(f"yosys failed, see {out / 'yosys.log'}: {run.stderr.strip()}")


def elaborate(rtl, out):
    package = rtl / "trihedron_registers.sv"
    others = " ".join(str(f) for f in sorted(rtl.glob("*.sv")) if f != package)
    yosys(f"read_verilog -sv {package} {others}\n"
          "hierarchy -check -top trihedron_top\nproc\nchformal -remove\n"
          f"opt_expr\nopt_merge\nopt_clean\nwrite_rtlil {out}/design.il\n"
          f"tee -q -o {out}/stat.txt stat\n", out)
    largest = {}  # one elaboration of each module
    statistics = (out / "stat.txt").read_text().split("=== design hierarchy ===")[0]
    for name, cells in re.findall(r"=== (\S+) ===.*?Number of cells: +(\d+)", statistics, re.S):
        base, cells = netlist.base_name(name), int(cells)
        if base not in largest or cells > largest[base][1]:
            largest[base] = (name, cells)
    return largest


def choose(largest, seed, out):
    """Lists each module's mutants; returns [{id, module, ...}] and the commands that apply them."""
    mutants, commands, next_id = [], [], 1
    for base, (name, cells) in sorted(largest.items()):
        count = max(FEWEST, min(MOST, cells // CELLS_PER_MUTANT))
        listing = out / f"{base}.list"
        yosys(f"read_rtlil {out}/design.il\nmutate -list {count + 8} -seed {seed} "
              f"-module {escaped(name)} -o {listing} -cfg pick_cover_prcnt 80\n", out)
        taken = 0
        for line in listing.read_text().splitlines():
            words = line.split()
            options = dict(zip(words[1::2], words[2::2]))
            if taken == count or options["-port"] in CLOCKS:
                continue
            sources = [pathlib.Path(words[i + 1]).name for i, w in enumerate(words) if w == "-src"]
            mutants.append({"id": next_id, "module": base, "mode": options["-mode"],
                            "cell": options["-cell"], "port": options["-port"],
                            "bit": options["-portbit"], "sources": sources,
                            "command": line})
            commands.append(f"{line} -ctrl {SELECT} {BITS} {next_id}")
            next_id += 1
            taken += 1
    return mutants, commands


def escaped(name):
    return name if name.startswith("$") else "\\" + name


def install_select(verilog):
    """Turns the selecting port that Yosys gave the top into a variable that the environment sets."""
    start = verilog.index("module trihedron_top(")
    inside, top = verilog[:start], verilog[start:]
    top = top.replace(f", {SELECT})", ")", 1).replace(f", {SELECT},", ",", 1)
    port = f"  input [{BITS - 1}:0] {SELECT};\n  wire [{BITS - 1}:0] {SELECT};\n"
    if port not in top:
        raise SystemExit("the top's selecting port was not found in Yosys's Verilog")
    return inside + top.replace(
        port, f"  reg [{BITS - 1}:0] {SELECT};\n"
        f"  initial {SELECT} = $c32(\"{FROM_ENVIRONMENT}\");\n", 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path, help="folder for the RTL and mutants.json")
    parser.add_argument("--rtl", type=pathlib.Path, default=ROOT / "rtl")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    out = arguments.out
    (out / "rtl").mkdir(parents=True, exist_ok=True)
    mutants, commands = choose(elaborate(arguments.rtl, out), arguments.seed, out)
    yosys(f"read_rtlil {out}/design.il\n" + "\n".join(commands) +
          f"\nwrite_verilog -noattr {out}/mutated.v\n", out)
    verilog = install_select((out / "mutated.v").read_text())
    # The names that the simulation's build expects.
    (out / "rtl/trihedron_top.sv").write_text(verilog)
    (out / "rtl/trihedron_registers.sv").write_text("package trihedron_registers; endpackage\n")
    (out / "mutants.json").write_text(json.dumps(mutants, indent=1) + "\n")
    print(f"{len(mutants)} mutants in {len({m['module'] for m in mutants})} modules")


if __name__ == "__main__":
    main()
