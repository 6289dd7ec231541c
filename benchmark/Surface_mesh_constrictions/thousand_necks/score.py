# SPDX-License-Identifier: GPL-3.0-or-later
"""Which of the known narrow places the curves of an answer find.

A curve *encircles* a place if all of its points are between the planes through the ends of the place's axis,
perpendicular to it, and it winds around the axis once. It *finds* the place if it is also on the surface and not longer
than the known loop, up to rounding. It is *near* it if it is longer, but not by more than half.

Each curve belongs to one place at most: of those that it finds or is near to, the one for which it is the shortest in
comparison with the known loop. Of the curves of one place the shortest counts, the others are *duplicates*. A curve
that belongs to no place is *extra*. That is no mistake in itself: the places of the set are those that are meant, and
for instance a way around three struts of a lattice can be a constriction, too.
"""
import json

import numpy as np

from bodies import known_length, winding
from surfaces import length

ROUNDING = 1e-5  # of a length, for polylines written with six digits
NEAR = 1.5
ON_SURFACE = 1e-4  # of the diagonal of the bounding box
SAMPLES = 24


def read_curves(path):
    """Closed polylines of a file, as arrays (n, 3) in which the first point is not repeated: the JSON of the format
    constrictions/1, or lines `n x1 y1 z1 ...` as CGAL writes them into .polylines.txt. Lines that do not come back to
    their start are left out. Throws ValueError for anything else."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if text.lstrip().startswith("{"):
        curves = [np.array(c["points"], float) for c in json.loads(text)["constrictions"]]
    else:
        curves = []
        for line in text.splitlines():
            words = line.split()
            if words:
                if len(words) != 1 + 3 * int(words[0]):
                    raise ValueError(f"{path}: a line with {words[0]} points has {len(words) - 1} coordinates")
                points = np.array(words[1:], float).reshape(-1, 3)
                if len(points) > 1 and np.abs(points[0] - points[-1]).max() <= ROUNDING * np.abs(points).max():
                    curves.append(points[:-1])
    return [c for c in curves if len(c) >= 3]


def distances(mesh, points, reach):
    """Of each point, the distance from the surface if it is at most `reach`; else infinity."""
    corners = [mesh.points[mesh.faces[:, i]] for i in range(3)]
    low, high = np.minimum.reduce(corners) - reach, np.maximum.reduce(corners) + reach
    result = []
    for p in points:
        near = np.flatnonzero(((low <= p) & (p <= high)).all(axis=1))
        a, b, c = (corner[near] for corner in corners)
        result.append(float(_to_triangles(p, a, b, c).min()) if len(near) else np.inf)
    return np.array(result)


def _to_triangles(p, a, b, c):
    """Distances of a point from triangles: from their planes above them, else from their sides."""
    def dot(x, y):
        return (x * y).sum(axis=-1)

    def to_side(start, end):
        d = end - start
        t = np.clip(dot(p - start, d) / np.maximum(dot(d, d), 1e-300), 0, 1)
        away = start + t[:, None] * d - p
        return np.sqrt(dot(away, away))

    normal = np.cross(b - a, c - a)
    size = np.maximum(np.sqrt(dot(normal, normal)), 1e-300)
    above = np.minimum.reduce([dot(np.cross(v - u, p - u), normal) for u, v in ((a, b), (b, c), (c, a))]) >= 0
    sides = np.minimum.reduce([to_side(a, b), to_side(b, c), to_side(c, a)])
    return np.where(above, np.abs(dot(p - a, normal)) / size, sides)


def is_on_surface(mesh, curve):
    """Looks at some points of the curve, and at the middle between each of them and the next point."""
    extent = mesh.points.max(axis=0) - mesh.points.min(axis=0)
    reach = ON_SURFACE * float(np.sqrt((extent * extent).sum()))
    some = np.unique(np.linspace(0, len(curve) - 1, min(SAMPLES, len(curve))).astype(int))
    samples = np.concatenate([curve[some], (curve[some] + np.roll(curve, -1, axis=0)[some]) / 2])
    return bool((distances(mesh, samples, reach) <= reach).all())


def encircles(curve, place):
    direction = place.axis[1] - place.axis[0]
    long = float(np.sqrt((direction * direction).sum()))
    direction = direction / long
    along = ((curve - place.axis[0]) * direction).sum(axis=1)
    return bool(along.min() >= 0 and along.max() <= long) and abs(winding(curve, place.axis[0], direction)) == 1


def score(body, curves):
    """Counts of an answer, as a dictionary. `missed` and `near_places` are numbers of places."""
    known = [known_length(body.mesh, place) for place in body.places]
    lengths = [length(c) for c in curves]
    best, duplicates, extras, off = {}, 0, 0, 0
    for curve, curve_length in zip(curves, lengths):
        ratios = [(curve_length / known[k], k) for k, place in enumerate(body.places)
                  if curve_length <= NEAR * known[k] and encircles(curve, place)]
        if ratios and not is_on_surface(body.mesh, curve):
            off += 1
            ratios = []
        if not ratios:
            extras += 1
            continue
        ratio, place = min(ratios)
        duplicates += place in best
        best[place] = min(ratio, best.get(place, ratio))
    found = [k for k, ratio in best.items() if ratio <= 1 + ROUNDING]
    return {
        "places": len(body.places),
        "found": len(found),
        "near": len(best) - len(found),
        "curves": len(curves),
        "duplicates": duplicates,
        "extras": extras,
        "off_surface": off,
        "near_places": sorted(set(best) - set(found)),
        "ratios": {str(k): round(best[k], 6) for k in sorted(best)},
        "missed": [k for k in range(len(known)) if k not in best],
    }
