#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""trihedron.core without FuseSoC: its fields are those of the CAPI2 schema that it uses, every file exists, the RTL list is
rtl/*.sv with the package first, every target's top and parameters are the RTL's with its defaults, and each tool takes the
target's files in the order FuseSoC would hand them over. usage: core_file.py"""

import pathlib
import re
import subprocess
import sys
import tempfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FIELDS = {
    "core": {"name", "description", "filesets", "targets", "parameters"},
    "fileset": {"files", "file_type", "depend"},
    "target": {"filesets", "toplevel", "parameters", "description", "default_tool", "tools"},
    "parameter": {"datatype", "default", "paramtype", "description"},
}


def fail(message):
    sys.exit(f"trihedron.core: {message}")


def known(kind, name, entry):
    unknown = set(entry) - FIELDS[kind]
    if unknown:
        fail(f"{name}: unknown field {', '.join(sorted(unknown))}; known are {', '.join(sorted(FIELDS[kind]))}")


def run(target, *command):
    with tempfile.TemporaryDirectory() as work:
        command = [word.replace("WORK", work) for word in command]
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
        if done.returncode:
            fail(f"target {target}: {command[0]} says {(done.stdout + done.stderr)[-500:]}")
        if command[0] == "iverilog":
            done = subprocess.run(["vvp", "-n", f"{work}/sim"], capture_output=True, text=True)
            if done.returncode:
                fail(f"target {target}: {done.stdout[-500:]}")


def main():
    text = (ROOT / "trihedron.core").read_text()
    if not text.startswith("CAPI=2:\n"):
        fail("the first line must be CAPI=2:")
    core = yaml.safe_load(text.split("\n", 1)[1])
    known("core", "core", core)
    if not re.fullmatch(r"\w+:\w+:\w+:\d+\.\d+\.\d+", core["name"]):
        fail(f"name {core['name']}: expected vendor:library:name:version")
    for name, fileset in core["filesets"].items():
        known("fileset", name, fileset)
        for file in fileset["files"]:
            if not (ROOT / file).is_file():
                fail(f"{name}: {file} does not exist")
    rtl = core["filesets"]["rtl"]["files"]
    if rtl[0] != "rtl/trihedron_registers.sv":
        fail("the package rtl/trihedron_registers.sv must come first")
    if sorted(rtl) != sorted(f"rtl/{f.name}" for f in (ROOT / "rtl").glob("*.sv")):
        fail("the list of the fileset rtl differs from rtl/*.sv")
    top = (ROOT / "rtl/trihedron_top.sv").read_text()
    for name, parameter in core["parameters"].items():
        known("parameter", name, parameter)
        if not re.search(rf"parameter int {name} *= {parameter['default']}\b", top):
            fail(f"parameter {name}: trihedron_top has another default or none")
    for name, target in core["targets"].items():
        known("target", name, target)
        files = [f for fileset in target["filesets"] for f in core["filesets"][fileset]["files"]]
        sources = [f for f in files if f.endswith(".sv")]
        if not any(re.search(rf"^module {target['toplevel']}\b", (ROOT / f).read_text(), re.M) for f in sources):
            fail(f"target {name}: no file of it holds the module {target['toplevel']}")
        missing = set(target.get("parameters", [])) - set(core["parameters"])
        if missing:
            fail(f"target {name}: parameter {', '.join(missing)} is not described")
        tool = target.get("default_tool")
        if tool and tool not in target["tools"]:
            fail(f"target {name}: no options for its default tool {tool}")
        if tool == "verilator":
            run(name, "verilator", "--lint-only", *target["tools"][tool]["verilator_options"], "--top-module",
                target["toplevel"], *files)
        elif tool == "icarus":
            run(name, "iverilog", *target["tools"][tool]["iverilog_options"], "-s", target["toplevel"], "-o",
                "WORK/sim", *sources)
        elif tool == "yosys":
            run(name, "yosys", "-q", "-p",
                f"read_verilog -sv {' '.join(sources)}; hierarchy -check -top {target['toplevel']}")
    print(f"trihedron.core: {len(rtl)} RTL files, targets {', '.join(core['targets'])}")


if __name__ == "__main__":
    main()
