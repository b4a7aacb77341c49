# SPDX-License-Identifier: Apache-2.0
"""Renders the sets of sets.py and recognises them; what exists already is kept."""
import os
import shutil
import subprocess

import sets


def run(arguments):
    subprocess.run([str(a) for a in arguments], check=True, stdout=subprocess.DEVNULL)


def render(program, folder, models, options, scenes, first_id, seed, extra=()):
    if os.path.isdir(folder):
        return
    partial = folder + ".partial"
    shutil.rmtree(partial, ignore_errors=True)
    run([program, "render", partial, "--models", models, "--scenes", scenes, "--first-id", first_id,
         "--seed", seed, *options.split(), *extra])
    os.rename(partial, folder)


def mixed_library(program, models, folder):
    """The library and its variants in one folder; variants have ids from 900001 on."""
    if os.path.isdir(folder):
        return
    variants, scratch, partial = folder + ".variants", folder + ".scratch", folder + ".partial"
    run([program, "render", scratch, "--models", models, "--scenes", 1, "--seed", sets.MIXED_SEED,
         "--variant", "both", "--write-models", variants])
    os.makedirs(partial, exist_ok=True)
    for source in (models, variants):
        for name in os.listdir(source):
            if name.endswith(".ply"):
                shutil.copy(os.path.join(source, name), partial)
    shutil.rmtree(scratch)
    os.rename(partial, folder)


def variants_of(root, name):
    """The folder with the models of an unknown set."""
    return os.path.join(root, name + "-models")


def render_all(program, models, root):
    """All sets of one library below `root`: (name, folder) pairs."""
    os.makedirs(root, exist_ok=True)
    out, first = [], 1
    for name, options, seed in sets.KINDS + sets.UNKNOWN:
        extra = []
        if name.startswith("unknown"):
            extra = ["--write-models", variants_of(root, name)]
        folder = os.path.join(root, name)
        render(program, folder, models, options, sets.SCENES_PER_SET, first, seed, extra)
        out.append((name, folder))
        first += sets.SCENES_PER_SET
    first = 1001
    for condition, _, option, values in sets.SWEEPS:
        for value in values:
            name = f"{condition}-{value}"
            folder = os.path.join(root, name)
            render(program, folder, models, sets.SWEEP_OPTIONS, sets.SCENES_PER_POINT, first,
                   sets.SWEEP_SEED, [option, value])
            out.append((name, folder))
            first += sets.SCENES_PER_POINT
    library = os.path.join(root, "mixed-models")
    mixed_library(program, models, library)
    folder = os.path.join(root, "mixed")
    render(program, folder, library, sets.MIXED_OPTIONS, sets.SCENES_PER_SET, 2001, sets.MIXED_SEED)
    out.append(("mixed", folder))
    return out


def recognize(program, models, folder, csv, jobs):
    if not os.path.isfile(csv):
        subprocess.run([program, "evaluate", folder, "--models", models, "--frontend", "golden",
                        "--csv", csv, "--jobs", str(jobs)], stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, check=False)  # 1: nothing found
