#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the regression on every mutant and writes who was killed by what: results.json and a Markdown
table per module. A mutant that survives the first stage meets the longer second one; of one that
survives both, equivalence.py tries to prove that it is the same design. What is neither must stand in
equivalent.txt. Exit code 1 when others are left."""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess

import equivalence

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT_S = 1800


def verify(program, mutant, frames, seed):
    """(killed, by what) of one run of the regression."""
    command = [program, "verify", "--frames", str(frames), "--seed", str(seed),
               "--plusarg", f"mutant={mutant}"]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        return True, "hangs the simulation"
    if run.returncode == 0:
        return False, ""
    stage = re.search(r"FAILED: (.*?) differs: seed (\d+)", run.stdout)
    if stage:
        return True, re.sub(r"^(register \w+).*", r"\1", stage[1])
    return True, f"simulation ends with code {run.returncode}"


def judge(folder, program, mutant, stages, prove):
    for seed, frames in stages:
        killed, how = verify(program, mutant["id"], frames, seed)
        if killed:
            return {**mutant, "killed": True, "by": how, "seed": seed}
    return {**mutant, "killed": False,
            "same": equivalence.proved(folder, mutant) if prove else ""}


def table(results, explained):
    modules = collections.defaultdict(list)
    for result in results:
        modules[result["module"]].append(result)
    lines = ["| module | mutants | killed | equivalent | open |", "|---|---|---|---|---|"]
    total = [0, 0, 0, 0]
    for module, mutants in sorted(modules.items()):
        killed = sum(m["killed"] for m in mutants)
        equivalent = sum(is_equivalent(m, explained) for m in mutants)
        row = [len(mutants), killed, equivalent, len(mutants) - killed - equivalent]
        total = [a + b for a, b in zip(total, row)]
        lines.append(f"| `{module}` | " + " | ".join(map(str, row)) + " |")
    lines.append("| **all** | " + " | ".join(f"**{n}**" for n in total) + " |")
    return "\n".join(lines) + "\n"


def is_equivalent(mutant, explained):
    return not mutant["killed"] and bool(mutant["same"] or key(mutant) in explained)


def key(mutant):
    """What a line of equivalent.txt names: module, source place, cell port and bit, kind of change."""
    return " ".join([mutant["module"], mutant["sources"][-1] if mutant["sources"] else "-",
                     f"{mutant['port']}[{mutant['bit']}]", mutant["mode"]])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path, help="folder of mutants.json and build/")
    parser.add_argument("--frames", type=int, default=150, help="of the first stage")
    parser.add_argument("--more-frames", type=int, default=1200, help="of the second stage, other seeds")
    parser.add_argument("--every", type=int, default=1, help="take each N-th mutant only")
    parser.add_argument("--module", action="append", help="take this module's mutants only")
    parser.add_argument("--no-proofs", action="store_true", help="take no survivor for the same design")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    program = arguments.build / "build/sw/cli/trihedron"
    mutants = json.loads((arguments.build / "mutants.json").read_text())[::arguments.every]
    if arguments.module:
        mutants = [m for m in mutants if m["module"] in arguments.module]
    if verify(program, 0, 60, 1)[0]:
        raise SystemExit("the design without a mutant already differs from the golden model")
    stages = [(1, arguments.frames)]
    if arguments.more_frames > 0:
        stages.append((100001, arguments.more_frames))
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        prove = not arguments.no_proofs
        results = list(pool.map(lambda m: judge(arguments.build, program, m, stages, prove), mutants))
    text = (ROOT / "tests/mutation/equivalent.txt").read_text().splitlines()
    explained = {line.split(":")[0] for line in text if line and not line.startswith("#")}
    (arguments.build / "results.json").write_text(json.dumps(results, indent=1) + "\n")
    report = table(results, explained)
    (arguments.build / "results.md").write_text(report)
    print(report)
    survivors = [r for r in results if not r["killed"]]
    for survivor in survivors:
        note = (f"the same {survivor['same']}" if survivor["same"] else
                "equivalent" if key(survivor) in explained else "SURVIVES")
        print(f"{note}: mutant {survivor['id']}: {key(survivor)}  ({', '.join(survivor['sources'])})")
    killed = len(results) - len(survivors)
    different = len(results) - sum(is_equivalent(s, explained) for s in survivors)
    print(f"{killed} of {different} mutants that differ are killed ({100 * killed / different:.1f} %); "
          f"{len(results) - different} are the same design")
    raise SystemExit(0 if killed == different else 1)


if __name__ == "__main__":
    main()
