# SPDX-License-Identifier: Apache-2.0
"""Holds results against the truth, object by object."""
import csv
import glob
import json
import os

import numpy as np

RIGHT = 0.2  # of the diameter: largest vertex distance of a right pose, symmetries taken


def read_models(folder):
    """Per id: vertices (n x 3, mm), diameter (mm), symmetries (4 x 4)."""
    info = json.load(open(os.path.join(folder, "models_info.json")))
    models = {}
    for key, entry in info.items():
        lines = open(os.path.join(folder, f"obj_{int(key):06d}.ply")).read().split("\n")
        count = next(int(l.split()[2]) for l in lines if l.startswith("element vertex"))
        start = lines.index("end_header") + 1
        vertices = np.array([[float(x) for x in l.split()[:3]] for l in lines[start:start + count]])
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


def score_set(folder, results_csv, models):
    """(objects, wrong, scenes): per object of the library (right, visible share); wrong results."""
    results, objects, wrong, scenes = read_results(results_csv), [], 0, 0
    for scene in sorted(glob.glob(os.path.join(folder, "[0-9]*"))):
        scenes += 1
        truth = json.load(open(os.path.join(scene, "scene_gt.json")))["0"]
        info = json.load(open(os.path.join(scene, "scene_gt_info.json")))
        visible = [np.mean([view[i]["visib_fract"] for view in info.values()])
                   for i in range(len(truth))]
        taken = set()
        for _, model_id, pose in sorted(results.get(int(os.path.basename(scene)), []),
                                        key=lambda r: -r[0]):
            found = None
            for i, t in enumerate(truth):
                if i in taken or t["obj_id"] != model_id:
                    continue
                at = (np.array(t["cam_R_m2c"]).reshape(3, 3), np.array(t["cam_t_m2c"]))
                distance = largest_distance(models[model_id], pose, at)
                if found is None or distance < found[0]:
                    found = (distance, i)
            if found and found[0] < RIGHT * models[model_id][1]:
                taken.add(found[1])
            else:
                wrong += 1
        objects += [(i in taken, visible[i]) for i, t in enumerate(truth) if t["obj_id"] in models]
    return objects, wrong, scenes


def wilson(right, count, z=1.96):
    """The 95 % interval of a share (Wilson)."""
    if count == 0:
        return 0.0, 1.0
    p = right / count
    centre = (p + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * np.sqrt(p * (1 - p) / count + z * z / (4 * count * count))
    return max(0.0, centre - half), min(1.0, centre + half)
