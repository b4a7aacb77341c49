#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes testvectors/models20: twenty polyhedral parts of 50-120 mm in the BOP layout.

usage: make_models20.py FOLDER      (Debian: python3-numpy python3-scipy)

Parts are drawn in three ways: cells of a rectangular grid, prisms over a polygon, convex hulls.
Meshes are closed, triangles counter-clockwise seen from outside, mm, centred on their box.
"""
import json, os, sys
from itertools import product

import numpy as np
from scipy.spatial import ConvexHull


def cells(x, y, z, full):
    """The solid of the grid cells (i, j, k) in `full`; x, y, z are the grid lines in mm."""
    index, triangles = {}, []

    def vertex(corner):
        return index.setdefault(corner, len(index))

    for cell in full:
        for axis, side in product(range(3), (0, 1)):
            neighbour = list(cell)
            neighbour[axis] += 2 * side - 1
            if tuple(neighbour) in full:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            quad = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[u] += du
                corner[v] += dv
                quad.append(vertex(tuple(corner)))
            if side == 0:
                quad.reverse()
            triangles += [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]
    corners = np.array(sorted(index, key=index.get))
    lines = [np.array(a, float) for a in (x, y, z)]
    return np.stack([lines[a][corners[:, a]] for a in range(3)], 1), np.array(triangles)


def grid(x, y, layers):
    """Cells from a drawing: per layer (bottom first) its height and rows of text, '#' is solid;
    the first row is the largest y."""
    z, full = [0], set()
    for k, (height, rows) in enumerate(layers):
        z.append(z[-1] + height)
        for j, row in enumerate(reversed(rows.split())):
            full |= {(i, j, k) for i, c in enumerate(row) if c == "#"}
    return cells(np.cumsum([0] + x), np.cumsum([0] + y), z, full)


def ears(polygon):
    """Triangles of a simple counter-clockwise polygon."""
    p, rest, out = np.array(polygon, float), list(range(len(polygon))), []

    def area(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    while len(rest) > 3:
        for n in range(len(rest)):
            i, j, k = rest[n - 1], rest[n], rest[(n + 1) % len(rest)]
            blocked = any(area(p[i], p[j], p[m]) >= 0 and area(p[j], p[k], p[m]) >= 0
                          and area(p[k], p[i], p[m]) >= 0 for m in rest if m not in (i, j, k))
            if area(p[i], p[j], p[k]) > 0 and not blocked:
                out.append([i, j, k])
                rest.remove(j)
                break
    return out + [rest]


def prism(polygon, height):
    n = len(polygon)
    v = [[x, y, z] for z in (0, height) for x, y in polygon]
    t = [[a, c, b] for a, b, c in ears(polygon)] + [[n + a, n + b, n + c] for a, b, c in ears(polygon)]
    for i in range(n):
        j = (i + 1) % n
        t += [[i, j, n + j], [i, n + j, n + i]]
    return np.array(v, float), np.array(t)


def ring(n, outer, inner, height):
    """A regular prism of n sides with a hole of the same shape; radii in mm."""
    angles = 2 * np.pi * np.arange(n) / n
    v = [[r * np.cos(a), r * np.sin(a), z] for z in (0, height) for r in (outer, inner) for a in angles]
    t = []
    for i in range(n):
        j = (i + 1) % n
        for a, b, c, d in ((i, n + i, n + j, j), (2 * n + i, 2 * n + j, 3 * n + j, 3 * n + i),
                           (i, j, 2 * n + j, 2 * n + i), (n + i, 3 * n + i, 3 * n + j, n + j)):
            t += [[a, b, c], [a, c, d]]
    return np.array(v), np.array(t)


def hull(points):
    v = np.array(points, float)
    h = ConvexHull(v)
    used = sorted(h.vertices)
    v, back = v[used], {old: new for new, old in enumerate(used)}
    t = np.array([[back[i] for i in s] for s in h.simplices])
    for s in t:
        n = np.cross(v[s[1]] - v[s[0]], v[s[2]] - v[s[0]])
        if n @ (v[s[0]] - v.mean(0)) < 0:
            s[1], s[2] = s[2], s[1]
    return v, t


def regular(n, radius):
    return [(radius * np.cos(2 * np.pi * i / n), radius * np.sin(2 * np.pi * i / n)) for i in range(n)]


def box(x, y, z):
    return list(product((0, x), (0, y), (0, z)))


PARTS = [
    ("h_block", grid([25, 40, 25], [22, 24, 22], [(36, "#.# ### #.#")])),
    ("z_block", grid([30, 28, 42], [24, 30], [(44, "##. .##")])),
    ("j_hook", grid([20, 38, 24], [26, 20, 30], [(40, "#.. #.# ###")])),
    ("cross", grid([22, 26, 38], [20, 24, 30], [(32, ".#. ### .#.")])),
    ("window_block", grid([24, 26, 44], [20, 22, 28], [(34, "### #.# ###")])),
    ("pocket_block", grid([16, 44, 28], [18, 32, 14], [(26, "### ### ###"), (30, "### #.# ###")])),
    ("missing_corner", grid([36, 40], [30, 34], [(28, "## ##"), (32, "## #.")])),
    ("notched_bracket", grid([18, 52, 20], [20, 26, 26], [(20, "##. ### ##."), (46, "#.. #.. #..")])),
    ("twin_pillars", grid([24, 36, 34], [30, 32], [(20, "### ###"), (26, "#.# ..#"), (24, "... ..#")])),
    ("chiral_tower", grid([34, 34], [34, 34], [(30, "## .#"), (34, "#. ..")])),
    ("rail", grid([20, 28, 20], [88], [(18, "###"), (26, ".#."), (16, "##.")])),
    ("v_block", prism([(0, 0), (84, 0), (84, 56), (66, 56), (42, 26), (18, 56), (0, 56)], 60)),
    ("dovetail", prism([(0, 0), (90, 0), (90, 24), (62, 24), (72, 52), (18, 52), (28, 24), (0, 24)], 50)),
    ("arrow", prism([(0, 18), (52, 18), (52, 0), (104, 34), (52, 68), (52, 50), (0, 50)], 34)),
    ("keystone", prism([(0, 0), (96, 0), (78, 58), (12, 58)], 46)),
    ("pentagon_prism", prism(regular(5, 42), 56)),
    ("hex_ring", ring(6, 50, 27, 36)),
    ("chamfered_block", hull([p for p in box(92, 62, 54) if p not in ((92, 62, 54), (0, 0, 54), (0, 62, 54))]
                             + [(66, 62, 54), (92, 40, 54), (92, 62, 32), (22, 0, 54), (0, 0, 34), (22, 62, 54), (0, 62, 34)])),
    ("skew_frustum", hull([(0, 0, 0), (86, 0, 0), (86, 70, 0), (0, 70, 0), (14, 10, 62), (54, 10, 62), (54, 44, 62), (14, 44, 62)])),
    ("oblique_prism", hull([(0, 0, 0), (80, 0, 0), (26, 64, 0), (0, 0, 72), (80, 0, 48), (26, 64, 60)])),
]


def corners(v, t):
    """Indices of the vertices whose triangles lie in three planes or more."""
    n = np.cross(v[t[:, 1]] - v[t[:, 0]], v[t[:, 2]] - v[t[:, 0]])
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    return [i for i in range(len(v)) if np.linalg.matrix_rank(n[(t == i).any(1)], tol=1e-6) == 3]


def by_surface(v, t):
    """The triangles, those of one planar face together: programs that number faces by their triangles agree."""
    n = np.cross(v[t[:, 1]] - v[t[:, 0]], v[t[:, 2]] - v[t[:, 0]])
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    edges = [{frozenset((a, b)) for a, b in zip(f, np.roll(f, 1))} for f in t.tolist()]
    order, rest = [], list(range(len(t)))
    while rest:
        face = [rest.pop(0)]
        for i in face:
            same = [j for j in rest if edges[i] & edges[j] and n[i] @ n[j] > 0.9999]
            face += same
            rest = [j for j in rest if j not in same]
        order += face
    return t[order]


def symmetries(p, tolerance):
    """Proper rotations about the mean of `p` that map the points onto themselves."""
    c = p.mean(0)
    q = p - c
    d = np.linalg.norm(q[:, None] - q[None], axis=2)
    a = int(np.argmax(np.linalg.norm(q, axis=1)))
    b = int(np.argmax(np.linalg.norm(np.cross(q[a], q), axis=1)))
    frame = np.stack([q[a], q[b], np.cross(q[a], q[b])], 1)
    found = []
    for i, j in product(range(len(q)), repeat=2):
        same = (abs(np.linalg.norm(q[i]) - np.linalg.norm(q[a])) < tolerance
                and abs(np.linalg.norm(q[j]) - np.linalg.norm(q[b])) < tolerance
                and abs(d[i, j] - d[a, b]) < tolerance)
        if not same:
            continue
        r = np.stack([q[i], q[j], np.cross(q[i], q[j])], 1) @ np.linalg.inv(frame)
        nearest = np.linalg.norm((q @ r.T)[:, None] - q[None], axis=2).min(1)
        if nearest.max() < tolerance and np.abs(r - np.eye(3)).max() > 1e-6:
            found.append((r, c - r @ c))
    return found


def write_ply(path, v, t):
    head = ["ply", "format ascii 1.0", "comment units: mm", f"element vertex {len(v)}",
            "property float x", "property float y", "property float z", f"element face {len(t)}",
            "property list uchar int vertex_indices", "end_header"]
    lines = [" ".join(f"{c + 0.0:.9g}" for c in p) for p in v] + [f"3 {a} {b} {c}" for a, b, c in t]
    with open(path, "w") as f:
        f.write("\n".join(head + lines) + "\n")


def main(folder):
    os.makedirs(folder, exist_ok=True)
    info, names = {}, {}
    for number, (name, (v, t)) in enumerate(PARTS, 1):
        v = v - (v.min(0) + v.max(0)) / 2
        p = v[corners(v, t)]
        diameter = np.linalg.norm(p[:, None] - p[None], axis=2).max()
        low, size = v.min(0), v.max(0) - v.min(0)
        entry = {"diameter": round(float(diameter), 4)}
        entry.update({f"min_{a}": round(float(x), 4) for a, x in zip("xyz", low)})
        entry.update({f"size_{a}": round(float(x), 4) for a, x in zip("xyz", size)})
        motions = symmetries(p, 1e-3 * diameter)
        if motions:
            entry["symmetries_discrete"] = [
                [round(float(x), 6) + 0.0 for x in np.vstack([np.column_stack(m), [0, 0, 0, 1]]).ravel()]
                for m in motions]
        write_ply(os.path.join(folder, f"obj_{number:06d}.ply"), v, by_surface(v, np.asarray(t)))
        info[str(number)], names[str(number)] = entry, name
        print(f"{number:2d} {name:16s} {size.round(1)} diameter {diameter:.1f} symmetries {len(motions)}")
    for file, content in (("models_info.json", info), ("models_names.json", names)):
        with open(os.path.join(folder, file), "w") as f:
            json.dump(content, f, indent=1)
            f.write("\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
