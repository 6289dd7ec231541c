#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Open3D 0.16.1 (python3-open3d 0.16.1+ds-2+b4), io.read_triangle_mesh() of PLY and OFF files with polygons.
#
# Guess: a flat convex quadrilateral becomes two triangles.
# What happens: the readers take some of them for polygons that cannot be cut into triangles. They warn, stop reading
# there, and return the mesh with the faces that came before: all vertices, a part of the surface. Which faces they
# refuse is a matter of rounding. Of the upright prisms over regular polygons of 3 to 12 corners, whose sides are plain
# rectangles, 5 of 10 come with holes from PLY and 3 from OFF, others if the prisms are turned; a prism over a triangle,
# turned by 0.1, keeps 2 of its 8 triangles. A torus of 288 quadrilaterals is complete.
#
# Why it matters: a program that does not look whether the result is closed goes on with half a body, and one that
# closes holes makes another body of it. The program here cuts polygons itself, of any number of corners (test
# Program_repair.polygons_through_all_commands).
. "$(dirname "$0")/lib/packages.sh"
debian python3-open3d=0.16.1+ds-2+b4

cd "$work"
cat > quadrilaterals.py << 'END'
import math
import meshes
import open3d

open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)


def write_ply(name, points, faces):
    with open(name, "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n"
                  "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(points), len(faces)))
        out.writelines("%r %r %r\n" % tuple(map(float, p)) for p in points)
        out.writelines("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)


def read(name):
    mesh = open3d.io.read_triangle_mesh(name)
    return [tuple(int(i) for i in t) for t in mesh.triangles]


def prism(corners, turned):
    angles = [turned + 2 * math.pi * i / corners for i in range(corners)]
    points = [(math.cos(a), math.sin(a), z) for z in (0, 1) for a in angles]
    faces = [tuple(range(corners))[::-1], tuple(range(corners, 2 * corners))]
    for i in range(corners):
        j = (i + 1) % corners
        faces.append((i, j, j + corners, i + corners))
    return points, faces


for turned in (0, 0.1):
    complete = {"ply": [], "off": []}
    for corners in range(3, 13):
        points, faces = prism(corners, turned)
        write_ply("prism.ply", points, faces)
        meshes.write_off("prism.off", points, faces)
        for kind in complete:
            if len(read("prism." + kind)) == 4 * corners - 4:
                complete[kind].append(corners)
    print("turned by %g, complete over: %s" % (turned, complete))
points, faces = prism(3, 0.1)
write_ply("prism.ply", points, faces)
print("prism over a triangle, turned by 0.1:", meshes.describe(read("prism.ply")))
points, faces = meshes.torus()
write_ply("torus.ply", points, [a + b[2:] for a, b in zip(faces[::2], faces[1::2])])
print("torus:", meshes.describe(read("torus.ply")))
END
verdict "$(/usr/bin/python3 quadrilaterals.py 2> /dev/null | grep -v RPly)" \
"turned by 0, complete over: {'ply': [3, 6, 7, 9, 10], 'off': [3, 5, 6, 7, 9, 10, 11]}
turned by 0.1, complete over: {'ply': [5, 8, 9, 12], 'off': [3, 4, 5, 6, 7, 8, 9, 10, 11, 12]}
prism over a triangle, turned by 0.1: V 6, F 2, components 2, Euler characteristic 2, border edges 6, non-manifold edges 0
torus: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0"
