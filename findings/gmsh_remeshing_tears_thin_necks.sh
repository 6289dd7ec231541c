#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Gmsh 4.8.4 (gmsh 4.8.4+ds2-3), a closed surface in STL that is meshed again: ClassifySurfaces, CreateGeometry and Mesh
# 2, as its tutorial 13 does.
#
# Guess: what comes out is one closed surface as what went in, however coarse; a neck that is thinner than the size of
# the triangles is a small triangle, or there is an error.
# What happens: for a neck of radius 0.02 on a body 2 long and triangles of size 0.1 that holds. With a neck of radius
# 0.01 a triangle by itself hangs there, with no warning; with 0.007 there are two closed bodies, with 0.005 five pieces
# with borders, with 0.001 also edges of more than two faces. For these a warning says that elements of some patches
# remain invalid; the program ends well and writes the file. With triangles of 0.05 the neck of 0.01 stays whole.
#
# Why it matters: scans are meshed again before anything is computed on them. The place that is torn is the neck, and of
# two closed bodies no check of a mesh finds out that they were one with one constriction.
. "$(dirname "$0")/lib/packages.sh"
debian gmsh=4.8.4+ds2-3
for folder in blas lapack; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$triplet/$folder"
done

cd "$work"
cat > remesh.py << 'END'
import subprocess
import meshes

for neck, size in ((0.02, 0.1), (0.01, 0.05), (0.01, 0.1), (0.007, 0.1), (0.005, 0.1), (0.001, 0.1)):
    points, faces = meshes.dumbbell(neck)
    meshes.write_stl("body.stl", [[points[i] for i in f] for f in faces])
    with open("remesh.geo", "w") as out:
        out.write('Merge "body.stl"; ClassifySurfaces{Pi, 1, 1, Pi}; CreateGeometry; Mesh.MeshSizeMax = %g;\n' % size)
    run = subprocess.run(["gmsh", "remesh.geo", "-2", "-format", "msh22", "-o", "out.msh", "-v", "3"],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    warnings = sum(line.startswith(("Warning", "Error")) for line in run.stdout.split("\n"))
    with open("out.msh") as file:
        rows = [line.split() for line in file]
    triangles = [tuple(map(int, row[-3:])) for row in rows if len(row) == 8 and row[1] == "2"]
    counts = meshes.describe(triangles)
    closed = "border edges 0, non-manifold edges 0" in counts
    print("neck %g, size %g: closed %s, one body like a ball %s, warnings %s, exit code %d" % (
        neck, size, closed, closed and "components 1, Euler characteristic 2," in counts, warnings > 0, run.returncode))
END
verdict "$(python3 remesh.py)" \
"neck 0.02, size 0.1: closed True, one body like a ball True, warnings False, exit code 0
neck 0.01, size 0.05: closed True, one body like a ball True, warnings False, exit code 0
neck 0.01, size 0.1: closed False, one body like a ball False, warnings False, exit code 0
neck 0.007, size 0.1: closed True, one body like a ball False, warnings True, exit code 0
neck 0.005, size 0.1: closed False, one body like a ball False, warnings True, exit code 0
neck 0.001, size 0.1: closed False, one body like a ball False, warnings True, exit code 0"
