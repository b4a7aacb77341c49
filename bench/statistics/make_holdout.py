# SPDX-License-Identifier: Apache-2.0
"""Writes a library of twelve parts on which nothing was developed: for proof only.

usage: make_holdout.py FOLDER      (Debian: python3-numpy python3-scipy)
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
import make_models20
from make_models20 import grid, hull, prism

PARTS = [
    ("gate", grid([28, 34, 20, 24], [30, 26], [(38, "##.# ####")])),
    ("stepped_hook", grid([22, 46], [26, 30, 22], [(24, "## #. ##"), (22, "#. #. ##")])),
    ("two_towers", grid([32, 28, 26], [34, 24], [(22, "### #.#"), (30, "#.. ..#")])),
    ("u_channel_tall", grid([18, 24, 30, 18], [24, 36], [(50, "#..# ####")])),
    ("twisted_stack", grid([40, 32], [28, 26, 20], [(30, "## ## #."), (28, ".# ## ..")])),
    ("bent_wall", prism([(0, 0), (70, 0), (88, 30), (60, 62), (30, 44), (0, 58)], 42)),
    ("s_profile", prism([(0, 0), (60, 0), (60, 20), (30, 20), (30, 44), (76, 44), (76, 66), (0, 66)], 38)),
    ("roof", hull([(0, 0, 0), (90, 0, 0), (70, 60, 0), (10, 66, 0), (20, 12, 48), (66, 16, 40)])),
    ("twisted_box", hull([(0, 0, 0), (84, 0, 0), (84, 54, 0), (0, 54, 0), (0, 0, 30), (84, 0, 52), (84, 54, 30), (0, 54, 52)])),
    ("keel", prism([(0, 0), (98, 0), (98, 26), (70, 26), (56, 60), (0, 40)], 34)),
    ("three_levels", grid([20, 20, 20, 34], [26, 40], [(18, "#### ####"), (24, "#.#. #..."), (16, ".... #...")])),
    ("spire", hull([(0, 0, 0), (64, 0, 0), (64, 64, 0), (0, 64, 0), (32, 20, 80), (12, 50, 60)])),
]

if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    make_models20.PARTS = PARTS
    make_models20.main(sys.argv[1])
