#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every relative link of the project's Markdown pages leads to a file.

usage: check_links.py [FOLDER]   exit code 1 and one line per dead link
"""
import re
import sys
from pathlib import Path

root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
skipped = {"build", "out", ".git"}
pages = [p for p in root.rglob("*.md") if not skipped & set(p.relative_to(root).parts)]
links = dead = 0
for page in pages:
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            continue
        links += 1
        if not (page.parent / target.split("#")[0]).exists():
            dead += 1
            print(f"{page.relative_to(root)}: no such file: {target}")
print(f"{links} links in {len(pages)} pages, {dead} dead")
sys.exit(1 if dead or not links else 0)
