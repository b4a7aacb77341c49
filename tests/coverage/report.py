#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the coverage report: lines and toggles of the RTL from Verilator's data, functional bins from
`trihedron verify --coverage`. Exit code 1 when a goal is missed or an exclusion excludes nothing."""

import argparse
import collections
import json
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINE_GOAL, TOGGLE_GOAL = 1.0, 0.95


def read_points(folder):
    """{(kind, module, line, what): hits}; the instances of a module are one."""
    points = collections.Counter()
    for file in sorted(folder.glob("*.dat")):
        for text in file.read_text(encoding="latin-1").splitlines():
            match = re.match(r"C '(.*)' (\d+)$", text)
            if not match:
                continue
            fields = dict(f.split("\x02", 1) for f in match[1].split("\x01") if f)
            kind = fields["page"].split("/")[0].removeprefix("v_")
            module = pathlib.Path(fields["f"]).stem
            points[(kind, module, int(fields["l"]), fields["o"], fields.get("n", ""))] += int(match[2])
    return points


def bits_of(text):
    """'[2-7,17 of 64]' as a test of a bit number: those bits, and the same of every further 64."""
    match = re.fullmatch(r"\[([\d,-]+)(?: of (\d+))?\]", text)
    ranges = [[int(n) for n in part.split("-")] for part in match[1].split(",")]
    every = int(match[2]) if match[2] else 1 << 30
    return lambda bit: any(r[0] <= bit % every <= r[-1] for r in ranges)


class Exclusions:
    """Lines of exclusions.txt: KIND MODULE PATTERN: reason. For a line PATTERN is a regular expression
    for part of its text, for a toggle one for the signal's whole name, behind it the bits that are
    meant, all if none are named."""

    def __init__(self, path):
        self.rules = []
        for text in path.read_text().splitlines():
            if not text or text.startswith("#"):
                continue
            rule, reason = text.split(": ", 1)
            kind, module, pattern = rule.split(None, 2)
            name, bits = re.fullmatch(r"(.*?)(\[[\d, of-]+\])?", pattern).groups()
            self.rules.append({"kind": kind, "module": module, "pattern": re.compile(name),
                               "bits": bits_of(bits) if bits else lambda bit: True,
                               "text": rule, "reason": reason, "used": 0})
        self.sources = {}

    def source(self, module, line):
        if module not in self.sources:
            self.sources[module] = (ROOT / f"rtl/{module}.sv").read_text().splitlines()
        return self.sources[module][line - 1]

    def excludes(self, kind, module, line, what):
        for rule in self.rules:
            if rule["kind"] != ("toggle" if kind == "toggle" else "line"):
                continue
            if not re.fullmatch(rule["module"].replace("*", ".*"), module):
                continue
            if kind == "toggle":
                name, bit = re.fullmatch(r"(.*?)(?:\[(\d+)\])?", what).groups()
                found = rule["pattern"].fullmatch(name) and rule["bits"](int(bit or 0))
            else:
                found = rule["pattern"].search(self.source(module, line))
            if found:
                rule["used"] += 1
                return True
        return False


def percent(hit, total):
    return f"{100 * hit / total:.1f} %" if total else "-"


def code_tables(points, exclusions):
    modules = collections.defaultdict(lambda: collections.Counter())
    missed = []
    for (kind, module, line, what, column), hits in sorted(points.items()):
        group = "toggle" if kind == "toggle" else "line"
        if exclusions.excludes(kind, module, line, what):
            modules[module][group + "_excluded"] += hits == 0
            continue
        modules[module][group] += 1
        modules[module][group + "_hit"] += hits > 0
        if hits == 0:
            missed.append(f"{module}:{line} {kind} {what}")
    total = sum((counts for counts in modules.values()), collections.Counter())
    rows = ["| module | line and branch points | hit | excluded | toggles | hit | excluded |",
            "|---|---|---|---|---|---|---|"]
    for module, c in sorted(modules.items()) + [("**all**", total)]:
        name = module if module.startswith("*") else f"`{module}`"
        rows.append(f"| {name} | {c['line']} | {percent(c['line_hit'], c['line'])} | "
                    f"{c['line_excluded']} | {c['toggle']} | {percent(c['toggle_hit'], c['toggle'])} | "
                    f"{c['toggle_excluded']} |")
    return rows, missed, total


def functional_tables(functional):
    rows = ["| group | bins | hit | never hit |", "|---|---|---|---|"]
    total = [0, 0]
    for group, bins in sorted(functional["groups"].items()):
        missing = [name for name, hits in bins.items() if hits == 0]
        total = [total[0] + len(bins), total[1] + len(bins) - len(missing)]
        rows.append(f"| {group} | {len(bins)} | {len(bins) - len(missing)} | "
                    f"{'; '.join(n.replace('|', 'x') for n in missing)} |")
    rows.append(f"| **all** | **{total[0]}** | **{total[1]}** | {percent(total[1], total[0])} |")
    return rows, total


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", type=pathlib.Path, help="folder of Verilator's .dat files")
    parser.add_argument("functional", type=pathlib.Path, help="JSON of verify --coverage")
    parser.add_argument("--out", type=pathlib.Path, help="Markdown report")
    parser.add_argument("--missed", type=pathlib.Path, help="list of what was never hit")
    arguments = parser.parse_args()
    exclusions = Exclusions(ROOT / "tests/coverage/exclusions.txt")
    functional = json.loads(arguments.functional.read_text())
    code, missed, total = code_tables(read_points(arguments.data), exclusions)
    bins, bins_total = functional_tables(functional)
    page = ["# Coverage of the regression", "",
            f"<!-- Written by tests/coverage/report.py -->", "",
            f"`tests/coverage/coverage.sh`: {functional['frames']} frames, seeds "
            f"{functional['first_seed']} to {functional['first_seed'] + functional['cases'] - 1}, "
            "held against the golden model bit for bit.", "", "## Functional", "",
            "Bins are declared in `sim/functional_coverage.cpp`; only cases that passed count.", "",
            *bins, "", "## Lines, branches and toggles of the RTL", "",
            "Verilator's points; instances of a module count as one, both directions of a bit as two.", "",
            *code, "", "Left out, each with its reason (`tests/coverage/exclusions.txt`):", "",
            "| what | points | why |", "|---|---|---|",
            *[f"| {r['text'].replace('|', chr(92) + '|')} | {r['used']} | {r['reason']} |" for r in exclusions.rules], ""]
    if arguments.out:
        arguments.out.write_text("\n".join(page))
    if arguments.missed:
        arguments.missed.write_text("\n".join(missed) + "\n")
    line, toggle = total["line_hit"] / total["line"], total["toggle_hit"] / total["toggle"]
    print(f"lines and branches {100 * line:.2f} % of {total['line']}, toggles {100 * toggle:.2f} % of "
          f"{total['toggle']}, functional bins {bins_total[1]} of {bins_total[0]}")
    unused = [r["text"] for r in exclusions.rules if r["used"] == 0]
    for rule in unused:
        print(f"excludes nothing: {rule}")
    raise SystemExit(0 if line >= LINE_GOAL and toggle >= TOGGLE_GOAL and not unused else 1)


if __name__ == "__main__":
    main()
