#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the flip-flops of the RTL with Yosys and writes a Verilator configuration that makes them, and
nothing else, writable from outside. Line memories are block RAM and are left out."""

import argparse
import json
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def netlist(rtl, work):
    package = rtl / "trihedron_registers.sv"
    others = " ".join(str(f) for f in sorted(rtl.glob("*.sv")) if f != package)
    script = (f"read_verilog -sv {package} {others}\nhierarchy -check -top trihedron_top\nproc\n"
              f"chformal -remove\nopt_clean\nwrite_json {work}\n")
    subprocess.run(["yosys", "-q", "-"], input=script, text=True, check=True)
    return json.loads(work.read_text())["modules"]


def assigned_at_clock(source):
    """Names before a nonblocking assignment on its line; comparisons bring in a few others."""
    heads = re.findall(r"^(.*?)<=", source, re.MULTILINE)
    return {name for head in heads for name in re.findall(r"[a-zA-Z_]\w*", head)}


def flip_flops(module, assigned):
    """Names of the variables that hold the module's flip-flops, without aliases of them."""
    stored = {bit for cell in module["cells"].values() if cell["type"].startswith("$dff")
              for bit in cell["connections"]["Q"]}
    return {plain for name, net in module["netnames"].items()
            for plain in [name.split(".")[-1]]  # without the generate block it stands in
            if not net["hide_name"] and plain in assigned and stored & set(net["bits"])}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path, help="the configuration, upsets.vlt")
    parser.add_argument("--rtl", type=pathlib.Path, default=ROOT / "rtl")
    arguments = parser.parse_args()
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    found = {}
    for name, module in netlist(arguments.rtl, arguments.out.with_suffix(".json")).items():
        base = [p for p in name.split("\\") if p and not p.startswith("$paramod")][0]
        assigned = assigned_at_clock((arguments.rtl / f"{base}.sv").read_text())
        found.setdefault(base, set()).update(flip_flops(module, assigned))
    lines = [f'public_flat_rw -module "{module}" -var "{name}"'
             for module, names in sorted(found.items()) for name in sorted(names)]
    arguments.out.write_text("`verilator_config\n" + "\n".join(lines) + "\n")
    print(f"{len(lines)} registers in {len(found)} modules")


if __name__ == "__main__":
    main()
