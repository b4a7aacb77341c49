#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands that README.md, CONTRIBUTING.md and docs/*.md show.

A block of commands (indented by four, or fenced as sh) carries a mark in the comment before it:
    <!-- run -->                 run it in CI; every command must end with exit code 0
    <!-- not run: REASON -->     why CI does not
A page's blocks run in order in one scratch folder that holds links to the repository's folders;
`trihedron` is the built program. A block of commands without a mark is an error.

usage: run_docs.py PROGRAM [PAGE...]   exit code 1 and what failed
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COMMAND = re.compile(
    r"(trihedron|images=|scene=|(scripts|build|tests|bench)/|python3|fusesoc|git|sudo|apt|cmake|ctest|gtkwave|export|mkdir|cp|cat|"
    r"SBATCH_OPTIONS=|source) ?\S*")
TIMEOUT_S = 600  # far above what any of them takes


def blocks(page):
    """(line, mark, commands) of each block of commands."""
    lines = page.read_text().split("\n") + [""]
    mark, i = "", 0
    while i < len(lines):
        line = lines[i]
        if re.fullmatch(r"<!-- (run|not run: .+) -->", line.strip()):
            mark = line.strip()[5:-4]
        elif line.startswith("```sh") or line.startswith("    ") and (i == 0 or not lines[i - 1].strip()):
            fenced, start = line.startswith("```"), i
            i += fenced
            body = []
            while i < len(lines) and (lines[i] != "```" if fenced else lines[i].startswith("    ") or
                                      not lines[i].strip() and lines[i + 1:i + 2] and lines[i + 1].startswith("    ")):
                body.append(lines[i] if fenced else lines[i][4:])
                i += 1
            if body and COMMAND.match(body[0]):
                yield start + 1, mark, "\n".join(body)
            mark = ""
        elif line.strip():
            mark = ""
        i += 1


def scratch_copy(folder, program):
    for name in os.listdir(ROOT):
        if name not in (".git", "out"):
            (folder / name).symlink_to(ROOT / name)
    binaries = folder / ".bin"
    binaries.mkdir()
    (binaries / "trihedron").symlink_to(Path(program).resolve())
    return dict(os.environ, PATH=f"{binaries}:{os.environ['PATH']}")


def main():
    program, *names = sys.argv[1:]
    pages = [ROOT / n for n in names] or [ROOT / "README.md", ROOT / "CONTRIBUTING.md",
                                          *sorted((ROOT / "docs").rglob("*.md"))]
    run = skipped = failed = 0
    for page in pages:
        with tempfile.TemporaryDirectory() as folder:
            environment = None
            for line, mark, commands in blocks(page):
                where = f"{page.relative_to(ROOT)}:{line}"
                if not mark:
                    print(f"{where}: no mark; expected <!-- run --> or <!-- not run: REASON -->")
                    failed += 1
                    continue
                if mark != "run":
                    skipped += 1
                    continue
                environment = environment or scratch_copy(Path(folder), program)
                done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, env=environment,
                                      capture_output=True, text=True, timeout=TIMEOUT_S)
                run += 1
                if done.returncode:
                    failed += 1
                    print(f"{where}: exit code {done.returncode}: {commands}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    print(f"{run} blocks run, {skipped} not run for a reason given, {failed} failed")
    sys.exit(1 if failed or not run else 0)


main()
