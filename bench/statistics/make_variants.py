# SPDX-License-Identifier: Apache-2.0
"""Writes a library's models stretched along one axis, under new ids: what must not be claimed.

usage: make_variants.py MODELS FOLDER AXIS FACTOR      e.g. models20 shorter_x x 0.9
"""
import json
import os
import sys

FIRST_ID = 900000  # added to a model's own id


def stretched(text, axis, factor):
    """A model's ASCII PLY file with its vertices' coordinate scaled."""
    lines = text.split("\n")
    count = next(int(l.split()[2]) for l in lines if l.startswith("element vertex"))
    first = lines.index("end_header") + 1
    for i in range(first, first + count):
        values = [float(x) for x in lines[i].split()]
        values["xyz".index(axis)] *= factor
        lines[i] = " ".join(f"{x:.6g}" for x in values)
    return "\n".join(lines)


def main(models, folder, axis, factor):
    os.makedirs(folder, exist_ok=True)
    for name in sorted(n for n in os.listdir(models) if n.endswith(".ply")):
        variant = os.path.join(folder, f"obj_{int(name[4:10]) + FIRST_ID:06d}.ply")
        with open(os.path.join(models, name)) as source, open(variant, "w") as target:
            target.write(stretched(source.read(), axis, float(factor)))
    with open(os.path.join(models, "models_names.json")) as source:
        names = {int(i) + FIRST_ID: f"{name}_{axis}{factor}" for i, name in json.load(source).items()}
    with open(os.path.join(folder, "models_names.json"), "w") as target:
        json.dump(names, target, indent=1)


if __name__ == "__main__":
    if len(sys.argv) != 5 or sys.argv[3] not in ("x", "y", "z"):
        sys.exit(__doc__)
    main(*sys.argv[1:])
