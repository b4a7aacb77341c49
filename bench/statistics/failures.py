# SPDX-License-Identifier: Apache-2.0
"""Where recognition fails: why each missed object was missed, and pictures of some.

usage: failures.py TRIHEDRON MODELS SET [SET...] [--out PICTURE.png] [--examples N]
Each SET is a folder of scenes with its results in SET.csv (`evaluate`). Every scene with a missed
object or a wrong result is recognised again for its rejections. A missed object counts under the
first word of the reason that its own model was refused for in about its own pose, as "no pose"
where no hypothesis there reached the judges, as "other" where it was refused in other poses only.
"""
import argparse
import collections
import json
import os
import subprocess
import tempfile

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import score

CREASE_DEG = 1.0  # faces that differ by less are one surface


def creases(vertices, faces):
    """Edges (vertex index pairs) between faces of different planes."""
    normals = collections.defaultdict(list)
    for face in faces:
        a, b, c = (vertices[i] for i in face[:3])
        normal = np.cross(b - a, c - a)
        for edge in zip(face, face[1:] + face[:1]):
            normals[tuple(sorted(edge))].append(normal / np.linalg.norm(normal))
    limit = np.cos(np.radians(CREASE_DEG))
    return [edge for edge, (n, m) in ((e, ns[:2]) for e, ns in normals.items() if len(ns) > 1) if n @ m < limit]


def cameras_of(scene):
    """Per view: K, R and t of the camera from the world, mm."""
    return [(np.array(c["cam_K"]).reshape(3, 3), np.array(c["cam_R_w2c"]).reshape(3, 3), np.array(c["cam_t_w2c"]))
            for c in json.load(open(os.path.join(scene, "scene_camera.json"))).values()]


def to_world(pose, camera):
    _, R, t = camera
    return R.T @ pose[0], R.T @ (pose[1] - t)


def rejections(program, models, scene):
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "recognize", scene, "--models", models, "--frontend", "golden", "--out", out],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        return json.load(open(os.path.join(out, "report.json")))["rejections"]


def why_missed(model_id, world_pose, refused, models):
    own = [r for r in refused if r["model_id"] == model_id]
    for r in own:
        at = (np.array(r["world_from_model"]["R"]).reshape(3, 3), np.array(r["world_from_model"]["t_mm"]))
        if score.largest_distance(models[model_id], at, world_pose) < score.RIGHT * models[model_id][1]:
            return r["reason"]
    return "other: refused in other poses only" if own else "no pose: none reached the judges"


def draw(axes, scene, mesh, world_pose):
    """The object's surroundings in three views, plain and with its true edges (hidden ones too)."""
    vertices, faces = mesh
    world = vertices @ world_pose[0].T + world_pose[1]
    for view, (K, R, t) in enumerate(cameras_of(scene)[:3]):
        image = (world @ R.T + t) @ K.T
        points = image[:, :2] / image[:, 2:]
        middle, half = (points.min(0) + points.max(0)) / 2, 0.65 * np.ptp(points, 0).max()
        for axis in axes[2 * view:2 * view + 2]:
            axis.imshow(plt.imread(os.path.join(scene, "gray", f"{view:06d}.png")), cmap="gray", vmin=0, vmax=1)
            axis.set_xlim(middle[0] - half, middle[0] + half)
            axis.set_ylim(middle[1] + half, middle[1] - half)
            axis.set_axis_off()
        for a, b in creases(vertices, faces):
            axes[2 * view + 1].plot(*points[[a, b]].T, color="red", linewidth=0.8)


def draw_examples(misses, models_folder, out):
    figure, axes = plt.subplots(len(misses), 6, figsize=(13, 2.4 * len(misses)), squeeze=False)
    for row, (scene, model_id, world, seen, reason) in zip(axes, misses):
        draw(row, scene, score.read_mesh(models_folder, model_id), world)
        kind = os.path.basename(os.path.dirname(scene))
        row[0].set_title(f"{kind}, {100 * seen:.0f} % visible. {reason}", loc="left", fontsize=9)
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.01, top=0.97, wspace=0.03, hspace=0.13)
    figure.savefig(out, dpi=70)


def misses_of(program, models_folder, folder, models):
    """(scene, model id, world pose, visible share, reason) of each missed object of a set."""
    results, out = score.read_results(folder + ".csv"), []
    for scene in score.scenes_of(folder):
        truth = score.truth_of(scene)
        taken, _ = score.match(results.get(int(os.path.basename(scene)), []), truth, models)
        missed = [t for i, t in enumerate(truth) if i not in taken and t[0] in models]
        refused = rejections(program, models_folder, scene) if missed else []
        for model_id, pose, seen in missed:
            world = to_world(pose, cameras_of(scene)[0])
            out.append((scene, model_id, world, seen, why_missed(model_id, world, refused, models)))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("models")
    parser.add_argument("sets", nargs="+")
    parser.add_argument("--out", default="recognition_failures.png")
    parser.add_argument("--examples", type=int, default=6, help="pictures, spread over the reasons")
    arguments = parser.parse_args()
    models = score.read_models(arguments.models)
    by_reason = collections.defaultdict(list)
    for folder in arguments.sets:
        for miss in misses_of(arguments.program, arguments.models, folder.rstrip("/"), models):
            by_reason[miss[-1].split(":")[0]].append(miss)
    print("| reason | objects missed | visible share, median |\n| --- | --- | --- |")
    for reason, misses in sorted(by_reason.items(), key=lambda r: -len(r[1])):
        print(f"| {reason} | {len(misses)} | {100 * np.median([m[3] for m in misses]):.0f} % |")
    turns = [m for rank in range(arguments.examples) for r in sorted(by_reason) for m in by_reason[r][rank:rank + 1]]
    if turns:
        draw_examples(turns[:arguments.examples], arguments.models, arguments.out)


if __name__ == "__main__":
    main()
