# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for the tests, as arrays."""

import os
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(os.environ.get("CONSTRICTIONS_MESH_DIR", Path(__file__).parents[2] / "data" / "meshes"))


def read_off(name):
    """The vertices and triangles of one of CGAL's example meshes."""
    path = FOLDER / name
    if not path.exists():
        pytest.skip(f"{path} is not there")
    lines = [line.split() for line in path.read_text().splitlines() if line.strip() and line[0] != "#"]
    assert lines[0][0] in ("OFF", "COFF")  # which has colours behind the coordinates
    n, m = int(lines[1][0]), int(lines[1][1])
    vertices = np.array([line[:3] for line in lines[2 : 2 + n]], dtype=float)
    faces = np.array([line[:4] for line in lines[2 + n : 2 + n + m]], dtype=int)
    assert (faces[:, 0] == 3).all()
    return vertices, faces[:, 1:]


def write_off(path, vertices, faces):
    """Writes what every program can read."""
    with open(path, "w") as file:
        print(f"OFF\n{len(vertices)} {len(faces)} 0", file=file)
        np.savetxt(file, vertices, "%.17g")
        np.savetxt(file, np.insert(faces, 0, 3, axis=1), "%d")


def write_ply(path, vertices, faces):
    """Writes what ParaView and PyVista read."""
    with open(path, "w") as file:
        print(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}", file=file)
        print("property double x\nproperty double y\nproperty double z", file=file)
        print(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header", file=file)
        np.savetxt(file, vertices, "%.17g")
        np.savetxt(file, np.insert(faces, 0, 3, axis=1), "%d")


def tube(radii, around=12, closed=True):
    """A tube along z with a ring of each of the radii, closed at both ends by a vertex on its axis."""
    radii = np.asarray(radii, dtype=float)
    angle = 2 * np.pi * np.arange(around) / around
    x, y = np.outer(radii, np.cos(angle)), np.outer(radii, np.sin(angle))
    z = np.repeat(np.arange(len(radii), dtype=float), around).reshape(x.shape)
    vertices = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    faces = []
    for z in range(len(radii) - 1):
        for i in range(around):
            a, b = z * around + i, z * around + (i + 1) % around
            faces += [(a, b, b + around), (a, b + around, a + around)]
    if closed:
        bottom, top = len(vertices), len(vertices) + 1
        vertices = np.concatenate([vertices, [(0, 0, -1), (0, 0, len(radii))]])
        last = (len(radii) - 1) * around
        for i in range(around):
            j = (i + 1) % around
            faces += [(bottom, j, i), (top, last + i, last + j)]
    return vertices, np.array(faces)


def hourglass(**options):
    """A tube with one waist, at z = 4."""
    return tube([1, 3, 3, 2, 1, 2, 3, 3, 1], **options)


TETRAHEDRON = (
    np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float),
    np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]),
)
