#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The coverage report on trial, with data made up for two real modules."""

import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import report  # noqa: E402


def point(page, file, line, what, hits):
    fields = {"f": f"rtl/{file}.sv", "l": line, "n": 1, "page": f"v_{page}/{file}", "o": what}
    return "C '" + "".join(f"\x01{k}\x02{v}" for k, v in fields.items()) + f"' {hits}\n"


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        first = point("line", "scale5", 20, "block", 0) + point("toggle", "scale5", 12, "a_i[3]", 0)
        second = point("line", "scale5", 20, "block", 5) + point("toggle", "scale5", 12, "a_i[4]", 2)
        (folder / "1.dat").write_text(first, encoding="latin-1")
        (folder / "2.dat").write_text(first + second, encoding="latin-1")
        points = report.read_points(folder)
        assert points[("line", "scale5", 20, "block", "1")] == 5, "hits of all files are added"

        rules = folder / "exclusions.txt"
        rules.write_text("toggle scale* a_i[3]: for this test\ntoggle scale5 b_i: never met\n")
        exclusions = report.Exclusions(rules)
        _, missed, total = report.code_tables(points, exclusions)
        assert not missed and total["toggle"] == 1 and total["toggle_excluded"] == 1
        assert [r["used"] for r in exclusions.rules] == [1, 0]
        _, missed, _ = report.code_tables(points, report.Exclusions(pathlib.Path("/dev/null")))
        assert missed == ["scale5:12 toggle a_i[3]"], missed

        assert report.bits_of("[2-4,7 of 8]")(12) and not report.bits_of("[2-4,7 of 8]")(13)

        functional = folder / "functional.json"
        functional.write_text(json.dumps({"frames": 9, "cases": 2, "first_seed": 1,
                                          "groups": {"g": {"hit": 3, "missed": 0}}}))
        run = subprocess.run([HERE / "report.py", folder, functional], capture_output=True, text=True)
        assert "functional bins 1 of 2" in run.stdout and run.returncode == 1, run.stdout + run.stderr


if __name__ == "__main__":
    main()
