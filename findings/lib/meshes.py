# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for the scripts of findings/, each a list of points and a list of faces: made, written, read and counted."""
import math
import struct


def tetrahedron(size=1.0):
    return ([(0, 0, 0), (size, 0, 0), (0, size, 0), (0, 0, size)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


def octahedron():
    return ([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
            [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])


def torus(around=24, across=12, radius=2.0, tube=1.0, scale=1.0):
    points = []
    for i in range(around):
        a = 2 * math.pi * i / around
        for j in range(across):
            b = 2 * math.pi * j / across
            ring = radius + tube * math.cos(b)
            points.append((scale * ring * math.cos(a), scale * ring * math.sin(a), scale * tube * math.sin(b)))
    faces = []
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            d, c = i * across + (j + 1) % across, (i + 1) % around * across + (j + 1) % across
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def dumbbell(neck, around=16, rings=60):
    """Two balls joined by a tube of radius neck, along the z-axis."""
    points, faces = [(0.0, 0.0, -1.0)], []
    for i in range(1, rings):
        z = -1 + 2 * i / rings
        ball = 0.35 ** 2 - (abs(z) - 0.65) ** 2
        r = max(neck, math.sqrt(ball)) if abs(z) >= 0.3 and ball > 0 else neck
        points += [(r * math.cos(2 * math.pi * j / around), r * math.sin(2 * math.pi * j / around), z)
                   for j in range(around)]
    points.append((0.0, 0.0, 1.0))
    last = 1 + (rings - 2) * around
    for j in range(around):
        k = (j + 1) % around
        faces += [(0, 1 + k, 1 + j), (len(points) - 1, last + j, last + k)]
        for i in range(rings - 2):
            a, b = 1 + i * around + j, 1 + i * around + k
            faces += [(a, b, b + around), (a, b + around, a + around)]
    return points, faces


def volume(points, faces):
    total = 0.0
    for f in faces:
        a, b, c = (points[i] for i in f)
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


def components(faces):
    parent = {}

    def root(i):
        parent.setdefault(i, i)
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for f in faces:
        for i in f:
            parent[root(i)] = root(f[0])
    return len({root(i) for i in parent})


def describe(faces):
    """Counts of a mesh given by its faces, as one line."""
    edges, directed = {}, {}
    for f in faces:
        for a, b in zip(f, f[1:] + f[:1]):
            edges[frozenset((a, b))] = edges.get(frozenset((a, b)), 0) + 1
            directed[a, b] = directed.get((a, b), 0) + 1
    vertices = {i for f in faces for i in f}
    return "V %d, F %d, components %d, Euler characteristic %d, border edges %d, non-manifold edges %d" % (
        len(vertices), len(faces), components(faces), len(vertices) - len(edges) + len(faces),
        sum(n == 1 for n in edges.values()), sum(n > 2 for n in edges.values()))


def write_off(name, points, faces):
    with open(name, "w") as out:
        out.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        out.writelines("%r %r %r\n" % tuple(map(float, p)) for p in points)
        out.writelines("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)


def read_off(name):
    with open(name) as file:
        words = [w for line in file for w in line.split("#")[0].split()][1:]
    n, m = int(words[0]), int(words[1])
    points = [tuple(map(float, words[3 + 3 * i:6 + 3 * i])) for i in range(n)]
    faces, at = [], 3 + 3 * n
    for _ in range(m):
        size = int(words[at])
        faces.append(tuple(map(int, words[at + 1:at + 1 + size])))
        at += 1 + size
    return points, faces


def write_obj(name, points, faces):
    with open(name, "w") as out:
        out.writelines("v %r %r %r\n" % tuple(map(float, p)) for p in points)
        out.writelines("f %s\n" % " ".join(str(i + 1) for i in f) for f in faces)


def read_obj(name):
    points, faces = [], []
    with open(name) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(map(float, words[1:4])))
            elif words[:1] == ["f"]:
                faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    return points, faces


def write_stl(name, triangles):
    """Binary STL of triangles given by their points."""
    with open(name, "wb") as out:
        out.write(b"\0" * 80 + struct.pack("<I", len(triangles)))
        for t in triangles:
            out.write(struct.pack("<12f", 0, 0, 0, *t[0], *t[1], *t[2]) + b"\0\0")


def up_to_turning(faces):
    """The faces, each beginning with its smallest vertex, sorted."""
    return sorted(min(f[i:] + f[:i] for i in range(len(f))) for f in faces)
