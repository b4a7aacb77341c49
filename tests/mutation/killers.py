# SPDX-License-Identifier: Apache-2.0
"""What may kill a mutant, cheapest first. Each killer takes (mutant) and says how it noticed, or ""."""

import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT_S = 1800
# Of the tests in tests/sim those that hold the device against something without whole scenes or the program.
LONG = ["every object*", "a sequence ten*", "the simulated RTL and*", "verify*", "simulate*", "merged*",
        "a failing regression*", "a video*", "statistics of*", "twelve random*"]


def run(program, arguments, mutant):
    environment = {**os.environ, "TRIHEDRON_MUTANT": str(mutant["id"])}
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True,
                          timeout=TIMEOUT_S, env=environment)


def regression(build, frames, seed):
    """Random frames, outputs and registers compared with the golden model."""
    def kill(mutant):
        try:
            end = run(build / "sw/cli/trihedron", ["verify", "--frames", frames, "--seed", seed], mutant)
        except subprocess.TimeoutExpired:
            return "hangs the simulation"
        if end.returncode == 0:
            return ""
        stage = re.search(r"FAILED: (.*?) differs: seed (\d+)", end.stdout)
        return (re.sub(r"^(register \w+).*", r"\1", stage[1]) if stage
                else f"simulation ends with code {end.returncode}")
    return kill


def tests(build):
    """The kept fuzzing inputs, the C driver's tests and the directed tests of tests/sim."""
    programs = [(build / "tests/fuzz/trihedron_fuzz_stream", [ROOT / "tests/fuzz/corpus/stream"]),
                (build / "tests/trihedron_driver_tests", ["-a"]),
                (build / "tests/trihedron_sim_tests", ["-a", *(f"~{name}" for name in LONG)])]

    def kill(mutant):
        for program, arguments in programs:
            try:
                end = run(program, arguments, mutant)
            except subprocess.TimeoutExpired:
                return f"hangs {program.name}"
            if end.returncode != 0:
                name = re.search(r"-{70,}\n(.*?)\n-{70,}", end.stdout, re.S)
                return " ".join(name[1].split()) if name else f"{program.name} ends with code {end.returncode}"
        return ""
    return kill

