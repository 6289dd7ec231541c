#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A plain way to narrow places, for comparison: sections with parallel planes, and where their length is least.

    plane_sections.py MESH.off OUT.polylines.txt [--planes N]

For each of 16 directions, those of the coordinates, the principal axes, and the bisectors of two and of three of these,
N planes cut the mesh. A closed curve of one plane goes on in the next plane as the curve with the nearest centroid, if
that is within half of the diameter of a circle of the length of the longer one. Curves that are shorter than those that
they go on in on both sides are written, of a row of curves of one length the middle one; of curves with nearly the same
centroid only the shortest. Needs numpy.
"""
import argparse
import math
import sys

import numpy as np

from surfaces import Mesh, length, positions, sections

SAME = 1e-5  # of a length
ONE_PLACE = 0.25  # of the diameter of a circle of the curve's length


def read_off(path):
    """A mesh of triangles."""
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    if words[0] != "OFF":
        raise ValueError(f"{path}: not an OFF file")
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], float).reshape(n, 3)
    faces = np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], np.int64).reshape(m, 4)
    if (faces[:, 0] != 3).any():
        raise ValueError(f"{path}: not only triangles")
    return Mesh(points, faces[:, 1:])


def search_directions(points):
    """Those of the coordinates, principal axes of the points, and bisectors of these."""
    centred = points - points.mean(axis=0)
    axes = np.linalg.eigh(centred.T @ centred)[1].T
    signs = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1),
             (1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)]
    directions = np.concatenate([np.eye(3), np.array(signs, float) @ axes])
    return directions / np.sqrt((directions * directions).sum(axis=1))[:, None]


class Curve:
    def __init__(self, points):
        self.points = points
        self.length = length(points)
        self.centroid = points.mean(axis=0)

    def next_in(self, plane):
        """The curve that this one goes on in, or None."""
        least, nearest = math.inf, None
        for other in plane:
            away = math.sqrt(((other.centroid - self.centroid) ** 2).sum())
            if away <= max(self.length, other.length) / (2 * math.pi) and away < least:
                least, nearest = away, other
        return nearest


def curves_of_planes(mesh, direction, number):
    heights = (mesh.points * direction).sum(axis=1)
    low, high = heights.min(), heights.max()
    result = []
    for k in range(number):
        at = low + (high - low) * (k + 0.5) / number
        loops = sections(mesh, None, None, heights - at)
        result.append([Curve(positions(mesh, loop)) for loop in loops])
    return result


def least_curves(planes):
    """Curves that are shorter than their neighbours; of a row of one length the middle one."""
    found = []
    for k, plane in enumerate(planes):
        for curve in plane:
            before = curve.next_in(planes[k - 1]) if k else None
            if before is None or before.length <= curve.length * (1 + SAME):
                continue  # not the first one of a row that is shorter than what is before it
            row, j = [curve], k + 1
            while j < len(planes):
                after = row[-1].next_in(planes[j])
                if after is None or after.length < curve.length * (1 - SAME):
                    row = []
                    break
                if after.length > curve.length * (1 + SAME):
                    break
                row.append(after)
                j += 1
            if row and j < len(planes):
                found.append(row[len(row) // 2])
    return found


def find(mesh, number):
    """Closed polylines of shape (n, 3), the shortest first."""
    found = [curve for direction in search_directions(mesh.points)
             for curve in least_curves(curves_of_planes(mesh, direction, number))]
    kept = []
    for curve in sorted(found, key=lambda c: c.length):
        reach = ONE_PLACE * curve.length / math.pi
        if all(math.sqrt(((curve.centroid - k.centroid) ** 2).sum()) > reach for k in kept):
            kept.append(curve)
    return [curve.points for curve in kept]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("out")
    parser.add_argument("--planes", type=int, default=32, metavar="N", help="32 by default")
    arguments = parser.parse_args()
    curves = find(read_off(arguments.mesh), arguments.planes)
    with open(arguments.out, "w", encoding="ascii") as file:
        for points in curves:
            numbers = np.concatenate([points, points[:1]]).ravel()
            file.write(f"{len(points) + 1} " + " ".join("%.17g" % x for x in numbers) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
