#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The slowest registers of nextpnr's detailed timing report, one line per module: path in ns, how many of the
module's register and memory inputs miss the limit, and which register ends the path.

usage: slowest.py REPORT_JSON [LIMIT_NS [LINES]]      default: 8.33 (120 MHz) 10
"""
import collections
import json
import re
import sys


def register(cell):
    """i_guard.rows_q of i_view.i_guard.rows_q_SB_DFF_Q_3_D_SB_LUT4_O_LC"""
    name = re.sub(r"_SB_(LUT4|DFF|CARRY).*", "", cell)
    return re.sub(r"\.memory\.\d.*|\[\d+\]$|_DFFLC$|\$.*", "", name).removeprefix("i_view.")


def main():
    report = json.load(open(sys.argv[1]))
    limit = float(sys.argv[2]) if len(sys.argv) > 2 else 1000 / 120
    lines = int(sys.argv[3]) if len(sys.argv) > 3 else 10
    delays = {}  # of each input of a clocked cell
    for net in report["detailed_net_timings"]:
        for end in net["endpoints"]:
            if end["event"].startswith("posedge"):
                key = (end["cell"], end["port"])
                delays[key] = max(delays.get(key, 0), end["delay"])
    modules = collections.defaultdict(list)
    for (cell, _), delay in delays.items():
        name = register(cell)
        modules[name.rpartition(".")[0] or "view_pipeline"].append((delay, name.rpartition(".")[2]))
    slowest = sorted(modules.items(), key=lambda item: -max(item[1])[0])
    for module, ends in slowest[:lines]:
        delay, name = max(ends)
        late = sum(d > limit for d, _ in ends)
        print(f"{delay:6.2f} ns  {late:4d} above {limit:.2f}  {module}: {name}")


main()
