# SPDX-License-Identifier: Apache-2.0
"""Names a mutant by the text that it changes, which other lines that come and go leave alone."""

import pathlib
import re

RTL = pathlib.Path(__file__).resolve().parents[2] / "rtl"


def text_at(place):
    """What stands in the RTL at "file.sv:line.column-line.column"; of several lines the first."""
    match = re.fullmatch(r"(\w+\.sv):(\d+)\.(\d+)-(\d+)\.(\d+)", place)
    if not match or match[2] == "0":
        return "-"
    line, left, last, right = (int(match[i]) for i in (2, 3, 4, 5))
    text = (RTL / match[1]).read_text().splitlines()[line - 1]
    return " ".join((text[left - 1:right - 1] if last == line else text[left - 1:]).split())


def key(mutant):
    """What a line of equivalent.txt names: module, mutated expression, cell port and bit, kind of change."""
    text = text_at(mutant["sources"][-1]) if mutant["sources"] else "-"
    return f"{mutant['module']} `{text}` {mutant['port']}[{mutant['bit']}] {mutant['mode']}"


def read_list(path):
    """Reason by key."""
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return dict(re.fullmatch(r"(.*? `.*` \S+ \w+): (.*)", line).groups() for line in lines)
