# SPDX-License-Identifier: Apache-2.0
"""Holds results against the truth, object by object."""
import csv
import glob
import json
import os

import numpy as np

RIGHT = 0.2  # of the diameter: largest vertex distance of a right pose, symmetries taken


def read_mesh(folder, model_id):
    """Vertices (n x 3, mm) and faces (lists of vertex indices) of a model's ASCII PLY file."""
    lines = open(os.path.join(folder, f"obj_{model_id:06d}.ply")).read().split("\n")
    counts = {l.split()[1]: int(l.split()[2]) for l in lines if l.startswith("element")}
    start = lines.index("end_header") + 1
    faces = start + counts["vertex"]
    return (np.array([[float(x) for x in l.split()[:3]] for l in lines[start:faces]]),
            [[int(x) for x in l.split()[1:]] for l in lines[faces:faces + counts["face"]]])


def read_models(folder):
    """Per id: vertices (n x 3, mm), diameter (mm), symmetries (4 x 4)."""
    info = json.load(open(os.path.join(folder, "models_info.json")))
    models = {}
    for key, entry in info.items():
        vertices, _ = read_mesh(folder, int(key))
        symmetries = [np.eye(4)] + [np.array(s).reshape(4, 4)
                                    for s in entry.get("symmetries_discrete", [])]
        models[int(key)] = (vertices, entry["diameter"], symmetries)
    return models


def largest_distance(model, a, b):
    vertices, _, symmetries = model
    moved = vertices @ a[0].T + a[1]
    return min(np.linalg.norm((vertices @ s[:3, :3].T + s[:3, 3]) @ b[0].T + b[1] - moved,
                              axis=1).max() for s in symmetries)


def read_results(path):
    rows = {}
    if not os.path.isfile(path):
        return rows
    for row in csv.DictReader(open(path)):
        pose = (np.array(row["R"].split(), float).reshape(3, 3), np.array(row["t"].split(), float))
        rows.setdefault(int(row["scene_id"]), []).append(
            (float(row["score"]), int(row["obj_id"]), pose))
    return rows


def truth_of(scene):
    """Objects of a scene folder: (model id, pose in the first camera's frame, mean visible share)."""
    truth = json.load(open(os.path.join(scene, "scene_gt.json")))["0"]
    info = json.load(open(os.path.join(scene, "scene_gt_info.json")))
    return [(t["obj_id"], (np.array(t["cam_R_m2c"]).reshape(3, 3), np.array(t["cam_t_m2c"])),
             np.mean([view[i]["visib_fract"] for view in info.values()])) for i, t in enumerate(truth)]


def match(results, truth, models):
    """({object: result}, wrong results): each result, best score first, takes the nearest free
    object of its model; it is right within RIGHT diameters."""
    taken, wrong = {}, []
    for result in sorted(results, key=lambda r: -r[0]):
        _, model_id, pose = result
        near = [(largest_distance(models[model_id], pose, at), i)
                for i, (true_id, at, _) in enumerate(truth) if true_id == model_id and i not in taken]
        if near and min(near)[0] < RIGHT * models[model_id][1]:
            taken[min(near)[1]] = result
        else:
            wrong.append(result)
    return taken, wrong


def scenes_of(folder):
    return sorted(glob.glob(os.path.join(folder, "[0-9]*")))


def score_set(folder, results_csv, models):
    """(objects, wrong, scenes): per object of the library (right, visible share); wrong results."""
    results, objects, wrong = read_results(results_csv), [], 0
    for scene in scenes_of(folder):
        truth = truth_of(scene)
        taken, bad = match(results.get(int(os.path.basename(scene)), []), truth, models)
        wrong += len(bad)
        objects += [(i in taken, seen) for i, (model_id, _, seen) in enumerate(truth) if model_id in models]
    return objects, wrong, len(scenes_of(folder))


def wilson(right, count, z=1.96):
    """The 95 % interval of a share (Wilson)."""
    if count == 0:
        return 0.0, 1.0
    p = right / count
    centre = (p + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * np.sqrt(p * (1 - p) / count + z * z / (4 * count * count))
    return max(0.0, centre - half), min(1.0, centre + half)
