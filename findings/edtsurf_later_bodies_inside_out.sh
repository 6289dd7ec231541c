#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# EDTSurf 0.2009 (edtsurf 0.2009-10), surfaces of molecules in PLY, by the van der Waals spheres (-s 1) in 8 steps for
# an angstrom (-f 8).
#
# Guess: the surfaces of all molecules of a file face outwards, and the wall of a cavity faces into the cavity. The area
# and the volume that are printed are those of the surface in the file.
# What happens: only the body that comes first is right. Every later one is turned: of four atoms that are apart three
# face inwards, and the volume by the faces is that of -2 atoms instead of 4. The wall of the cavity in a hollow ball of
# atoms is turned as well, so that the cavity counts as filled twice. All surfaces are closed, and nothing is said. Of
# single atoms the area that is printed is 9% greater than that of the faces, and the volume by a fifth.
#
# Why it matters: chains, complexes and molecules with cavities are the usual input, and necks of their surfaces are
# looked for. Whatever tells the inside from the outside by the orientation takes a protein for a hole.
. "$(dirname "$0")/lib/packages.sh"
debian edtsurf=0.2009-10

cd "$work"
cat > surfaces.py << 'END'
import math
import re
import subprocess
import meshes


def read_ply(name):
    with open(name) as file:
        lines = file.read().split("\n")
    body = lines.index("end_header") + 1
    count = {w[1]: int(w[2]) for w in (line.split() for line in lines[:body]) if w[:1] == ["element"]}
    rows = [line.split() for line in lines[body:]]
    points = [tuple(map(float, r[:3])) for r in rows[:count["vertex"]]]
    return points, [tuple(map(int, r[1:4])) for r in rows[count["vertex"]:count["vertex"] + count["face"]]]


def parts(faces):
    """Lists of the faces of each connected component, in the order of the file."""
    parent = {i: i for f in faces for i in f}

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for f in faces:
        for i in f:
            parent[root(i)] = root(f[0])
    result = {}
    for f in faces:
        result.setdefault(root(f[0]), []).append(f)
    return list(result.values())


def area(points, faces):
    total = 0.0
    for f in faces:
        a, b, c = (points[i] for i in f)
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        total += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
    return total


ball = []
for i in range(150):
    z = 1 - (2 * i + 1) / 150
    a, r = math.pi * (3 - math.sqrt(5)) * i, math.sqrt(1 - z * z)
    ball.append((7 * r * math.cos(a), 7 * r * math.sin(a), 7 * z))
for name, atoms in [("one atom", [(0, 0, 0)]), ("two atoms that touch", [(0, 0, 0), (3, 0, 0)]),
                    ("four atoms apart", [(12 * i, 0, 0) for i in range(4)]), ("hollow ball", ball)]:
    with open("atoms.pdb", "w") as out:
        for i, place in enumerate(atoms):
            out.write("ATOM  %5d  CA  ALA A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n" % (i + 1, i + 1, *place))
        out.write("END\n")
    said = subprocess.run(["EDTSurf", "-i", "atoms.pdb", "-o", "atoms", "-s", "1", "-f", "8"], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    printed = re.search(r"Total area ([\d.]+) and volume ([\d.]+)", said)
    points, faces = read_ply("atoms.ply")
    print("%s: closed %s, volumes of the bodies by the faces %s; area printed %.1f, area %.1f, volume printed %.1f" % (
        name, "border edges 0, non-manifold edges 0" in meshes.describe(faces),
        " ".join("%.1f" % meshes.volume(points, p) for p in parts(faces)), float(printed[1]), area(points, faces),
        float(printed[2])))
END
verdict "$(python3 surfaces.py)" \
"one atom: closed True, volumes of the bodies by the faces 29.4; area printed 50.4, area 46.3, volume printed 35.7
two atoms that touch: closed True, volumes of the bodies by the faces 57.0; area printed 89.5, area 81.8, volume printed 68.0
four atoms apart: closed True, volumes of the bodies by the faces 29.3 -29.3 -29.3 -29.3; area printed 202.1, area 185.1, volume printed 143.3
hollow ball: closed True, volumes of the bodies by the faces 2747.8 602.3; area printed 1545.3, area 1399.2, volume printed 2333.5"
