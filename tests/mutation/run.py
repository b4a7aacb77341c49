#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Looks for what kills each mutant, cheapest first: some frames of the regression, the proofs, the directed
tests, more frames; behind the first equivalence.py tries to prove that it is the same design. What is
left must stand in equivalent.txt. Writes answers.jsonl, stage by stage, and a Markdown table per module;
exit code 1 when others are left. Interrupted, it goes on with --continue."""

import argparse
import collections
import concurrent.futures
import functools
import json
import os
import pathlib
import threading

import equivalence
import killers
import proofs
import rtl_place

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAME = "same design"


class Answers:
    """What each stage said of each mutant, kept in a file as soon as it is known."""

    def __init__(self, path, keep):
        self.known, self.lock = {}, threading.Lock()
        if keep and path.exists():
            for line in map(json.loads, path.read_text().splitlines()):
                self.known[line["mutant"], line["stage"]] = line["by"]
        self.file = path.open("a" if keep else "w")

    def ask(self, stage, kill, mutant):
        by = self.known.get((mutant["command"], stage))
        if by is None:
            by = kill(mutant)
            with self.lock:
                self.file.write(json.dumps({"mutant": mutant["command"], "stage": stage, "by": by}) + "\n")
                self.file.flush()
        return by


def judge_all(mutants, stages, jobs, answers, explained):
    """Stage by stage those that are left; the first that kills one or finds the same design decides. What
    cannot be killed for a known reason is put before the first stage only, which holds the reason to it."""
    results = {m["id"]: {**m, "stage": "", "by": ""} for m in mutants}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for stage, kill in stages:
            left = [m for m in mutants if not results[m["id"]]["stage"] and
                    (stage == stages[0][0] or rtl_place.key(m) not in explained)]
            for mutant, by in zip(left, pool.map(lambda m: answers.ask(stage, kill, m), left)):
                if by:
                    results[mutant["id"]].update(stage=stage, by=by)
            print(f"{stage}: {len(left)} asked, "
                  f"{sum(r['stage'] == stage for r in results.values())} decided", flush=True)
    return [*results.values()]


def state(result, explained):
    """What the table counts a mutant as."""
    return result["stage"] or (SAME if rtl_place.key(result) in explained else "open")


def table(results, names, explained):
    counts = collections.defaultdict(collections.Counter)
    for result in results:
        for module in (result["module"], "**all**"):
            counts[module][state(result, explained)] += 1
    columns = [*(name for name in names if name != SAME), SAME, "open"]
    lines = ["| module | mutants | " + " | ".join(columns) + " |", "|---" * (len(columns) + 2) + "|"]
    for module in [*sorted(m for m in counts if m[0] != "*"), "**all**"]:
        count = counts[module]
        row = [sum(count.values()), *(count[column] for column in columns)]
        lines.append(f"| {module if module[0] == '*' else f'`{module}`'} | " + " | ".join(map(str, row)) + " |")
    return "\n".join(lines) + "\n"


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="of mutants.py")
    parser.add_argument("build", type=pathlib.Path, help="of CMake, with the mutated device")
    parser.add_argument("--frames", type=int, default=60, help="first, seeds from 1")
    parser.add_argument("--more-frames", type=int, default=600, help="of survivors, seeds from 100001")
    parser.add_argument("--every", type=int, default=1, help="take each N-th mutant only")
    parser.add_argument("--only", type=int, nargs="+", help="take the mutants of these numbers only")
    parser.add_argument("--continue", dest="resume", action="store_true",
                        help="keep what answers.jsonl says already")
    parser.add_argument("--no-proofs", action="store_true", help="simulate only")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    return parser.parse_args()


def main():
    arguments = parse()
    mutants = json.loads((arguments.folder / "mutants.json").read_text())[::arguments.every]
    if arguments.only:
        mutants = [m for m in mutants if m["id"] in arguments.only]
    stages = [("frames", killers.regression(arguments.build, arguments.frames, 1)),
              ("tests", killers.tests(arguments.build)),
              ("more frames", killers.regression(arguments.build, arguments.more_frames, 100001))]
    answers = Answers(arguments.folder / "answers.jsonl", arguments.resume)
    for name, kill in stages:
        if how := answers.ask(name, kill, {"id": 0, "command": "none"}):
            raise SystemExit(f"the design without a mutant already fails in {name}: {how}")
    if not arguments.no_proofs:
        stages[1:1] = [(SAME, functools.partial(equivalence.proved, arguments.folder)),
                       ("proofs", functools.partial(proofs.broken, arguments.folder))]
    explained = rtl_place.read_list(ROOT / "tests/mutation/equivalent.txt")
    results = judge_all(mutants, stages, arguments.jobs, answers, explained)
    report = table(results, [name for name, _ in stages], explained)
    (arguments.folder / "results.md").write_text(report)
    print(report)
    raise SystemExit(conclude(results, explained))


def conclude(results, explained):
    """Prints the survivors and the closing line; the exit code."""
    for result in results:
        if state(result, explained) in (SAME, "open"):
            reason = f"the same {result['by']}" if result["stage"] else explained.get(rtl_place.key(result), "OPEN")
            print(f"mutant {result['id']}: {rtl_place.key(result)}: {reason}")
    count = collections.Counter(state(result, explained) for result in results)
    different = len(results) - count[SAME]
    killed = different - count["open"]
    print(f"{killed} of {different} mutants that differ are killed ({100 * killed / different:.1f} %); "
          f"{count[SAME]} are the same design")
    return 0 if killed == different else 1


if __name__ == "__main__":
    main()
