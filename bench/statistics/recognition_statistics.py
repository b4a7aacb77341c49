# SPDX-License-Identifier: Apache-2.0
"""Recognition rate with 95 % intervals against occlusion, noise, contrast, views and calibration.

usage: recognition_statistics.py TRIHEDRON MODELS WORK_DIR [--out PICTURE.png] [--jobs N]
Renders what WORK_DIR lacks (sets.py), recognises it with the golden front end, which gives the
same features as the RTL, prints tables in Markdown and draws the curves.
"""
import argparse
import os

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import render
import score
import sets

VISIBLE = [0, 0.3, 0.5, 0.7, 0.85, 0.95, 1.01]  # bounds of the visible share, mean over the views


def row(name, objects, wrong="", scenes=""):
    right = sum(r for r, _ in objects)
    low, high = score.wilson(right, len(objects))
    share = f"{100 * right / len(objects):.1f} % ({100 * low:.1f} to {100 * high:.1f})" if objects else "-"
    print(f"| {name} | {scenes} | {len(objects)} | {share} | {wrong} |")


def curve(axis, places, groups, label):
    right = [sum(r for r, _ in g) for g in groups]
    rates = [100 * r / max(1, len(g)) for r, g in zip(right, groups)]
    bounds = [score.wilson(r, len(g)) for r, g in zip(right, groups)]
    low = [max(0, rate - 100 * b[0]) for rate, b in zip(rates, bounds)]
    high = [max(0, 100 * b[1] - rate) for rate, b in zip(rates, bounds)]
    axis.errorbar(places, rates, yerr=[low, high], marker="o", capsize=3)
    axis.set_xlabel(label)
    axis.set_ylim(0, 102)
    axis.grid(alpha=0.3)


def by_visibility(objects):
    return [[o for o in objects if low <= o[1] < high] for low, high in zip(VISIBLE, VISIBLE[1:])]


def draw(scored, out):
    figure, axes = plt.subplots(1, 1 + len(sets.SWEEPS), figsize=(16, 3.4), sharey=True)
    known = [o for name, _, _ in sets.KINDS for o in scored[name][0]]
    middles = [100 * (a + min(b, 1)) / 2 for a, b in zip(VISIBLE, VISIBLE[1:])]
    curve(axes[0], middles, by_visibility(known), "visible, % (mean of the views)")
    axes[0].set_ylabel("objects right, %")
    for axis, (condition, label, _, values) in zip(axes[1:], sets.SWEEPS):
        done = [v for v in values if f"{condition}-{v}" in scored]
        curve(axis, done, [scored[f"{condition}-{v}"][0] for v in done], label)
    figure.tight_layout()
    figure.savefig(out, dpi=80)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("models")
    parser.add_argument("work")
    parser.add_argument("--out", default="recognition_statistics.png")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    scored = {}

    def measure(name, folder, library):
        results = os.path.join(arguments.work, name + ".csv")
        render.recognize(arguments.program, library, folder, results, arguments.jobs)
        scored[name] = score.score_set(folder, results, score.read_models(library))

    folders = dict(render.render_all(arguments.program, arguments.models, arguments.work))
    for name, folder in folders.items():
        measure(name, folder, arguments.models)
    for name, scenes, unknown in sets.IMPOSTORS:
        measure(name, folders[scenes], render.variants_of(arguments.work, unknown))
    print("| scenes | scenes | objects of the library | right (95 % interval) | wrong |")
    print("| --- | --- | --- | --- | --- |")
    for name, (objects, wrong, scenes) in scored.items():
        row(name, objects, wrong, scenes)
    row("all", [o for s in scored.values() for o in s[0]], sum(s[1] for s in scored.values()),
        sum(s[2] for s in scored.values()))
    known = [o for name, _, _ in sets.KINDS for o in scored[name][0]]
    for (low, high), group in zip(zip(VISIBLE, VISIBLE[1:]), by_visibility(known)):
        row(f"kinds, {100 * low:.0f} to {min(100, 100 * high):.0f} % visible", group)
    draw(scored, arguments.out)


if __name__ == "__main__":
    main()
