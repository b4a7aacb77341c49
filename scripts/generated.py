# SPDX-License-Identifier: Apache-2.0
"""Files that scripts generate and the repository keeps: write them, or check that they are up to date."""
import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def write_or_check(description, files, strangers=()):
    """Brings the repository's copies up to date, or with --check on the command line only compares.

    files      {path below ROOT: its text}
    strangers  paths that the source no longer has; removed
    Exit code 1 and one line with the stale paths and the script to run, where --check finds any.
    """
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--check", action="store_true", help="compare with the files, write nothing")
    stale = [p for p, text in files.items() if not p.exists() or p.read_text() != text]
    if parser.parse_args().check:
        names = ", ".join(str(p.relative_to(ROOT)) for p in [*stale, *strangers])
        if names:
            sys.exit(f"{names}: out of date against the source; run scripts/{Path(sys.argv[0]).name}")
        return
    for path in stale:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(files[path])
    for path in strangers:
        path.unlink()
