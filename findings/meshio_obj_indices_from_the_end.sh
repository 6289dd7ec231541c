#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshio as packaged by Debian 12 (python3-meshio 7.0.0-3; meshio.__version__ says 5.0.0), reading OBJ.
#
# Guess: negative vertex numbers, which count from the last vertex as the format allows, are resolved or refused;
# colours behind the coordinates are left out or become point data.
# What happens: -1 becomes -2, since every number is lowered by one. The faces keep these numbers, and meshio writes
# them into OFF and PLY files without a word; writing OBJ raises them again, so that a round trip through OBJ looks
# right. "v x y z r g b" gives an array of points with six columns. From that the OFF writer prints three values too
# many a line, and meshio itself cannot read the file again.
#
# Why it matters: a converter between a modelling program and a mesh library hands on files that name no surface. The
# program here reads both spellings (for the numbers, test Mesh_file.obj_with_everything_else).
. "$(dirname "$0")/lib/packages.sh"
debian python3-meshio=7.0.0-3

cd "$work"
cat > convert.py << 'END'
import meshio
import meshes

points, faces = meshes.tetrahedron()
print("version:", meshio.__version__)
with open("negative.obj", "w") as out:
    out.writelines("v %g %g %g\n" % p for p in points)
    out.writelines("f %d %d %d\n" % tuple(i - len(points) for i in f) for f in faces)
mesh = meshio.read("negative.obj")
print("faces:", mesh.cells[0].data.tolist())
mesh.write("negative.off")
print("OFF:", meshes.read_off("negative.off")[1])
mesh.write("again.obj")
print("OBJ:", [line.strip() for line in open("again.obj") if line.startswith("f")])
with open("coloured.obj", "w") as out:
    out.writelines("v %g %g %g 1 0.5 0.25\n" % p for p in points)
    out.writelines("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces)
mesh = meshio.read("coloured.obj")
print("points with colours:", mesh.points.shape)
mesh.write("coloured.off")
try:
    meshio.read("coloured.off")
    print("read again")
except ValueError as error:
    print("reading what it wrote:", error)
END
verdict "$(python3 convert.py 2>&1)" \
"version: 5.0.0
faces: [[-5, -3, -4], [-5, -4, -2], [-4, -3, -2], [-3, -5, -2]]
OFF: [(-5, -3, -4), (-5, -4, -2), (-4, -3, -2), (-3, -5, -2)]
OBJ: ['f -4 -2 -3', 'f -4 -3 -1', 'f -3 -2 -1', 'f -2 -4 -1']
points with colours: (4, 6)
reading what it wrote: cannot reshape array of size 1 into shape (4,4)"
