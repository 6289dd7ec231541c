#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rgl 1.0.1 for R (r-cran-rgl 1.0.1-1): readOBJ(), and writeOBJ() and writePLY() of what was read.
#
# Guess: a closed torus that is read from OBJ and written again is the same torus in OBJ and PLY, which have numbers for
# vertices, and loses them in STL only. Coordinates keep their digits in the text formats.
# What happens: it is read with 288 vertices, and written as 576 triangles that share none, 1728 vertices with a border
# around every triangle, in OBJ and in PLY as well. What is written is the scene as it is drawn, and drawing also makes
# floats of the coordinates: in map coordinates they move by up to a quarter of a metre in OBJ, and by half a metre in
# PLY as text, which has seven digits. There is no message.
#
# Why it matters: a mesh that went through R has no edge with two faces, and no closed curve but around a triangle. A
# reader that takes vertices by their numbers, which is what the formats say, finds 576 bodies.
. "$(dirname "$0")/lib/packages.sh"
debian r-cran-rgl=1.0.1-1
for folder in R/lib "$triplet/blas" "$triplet/lapack"; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$folder"
done
export R_HOME="$work/root/usr/lib/R" R_LIBS="$work/root/usr/lib/R/site-library" EDITOR=vi PAGER=cat

cd "$work"
cat > through.R << 'END'
options(rgl.useNULL = TRUE)
library(rgl)
for (name in c("near", "map")) {
  mesh <- readOBJ(paste0(name, ".obj"))
  cat(name, ": read with ", ncol(mesh$vb), " vertices and ", ncol(mesh$it), " triangles\n", sep = "")
  open3d()
  shade3d(mesh)
  writeOBJ(paste0(name, "_out.obj"))
  writePLY(paste0(name, "_out.ply"), format = "ascii")
}
END
cat > through.py << 'END'
import subprocess
import meshes


def read_ply(name):
    lines = open(name).read().split("\n")
    n, m = (int(line.split()[2]) for line in lines if line.startswith("element"))
    body = lines[lines.index("end_header") + 1:]
    return [tuple(map(float, line.split()[:3])) for line in body[:n]], [
        tuple(map(int, line.split()[1:4])) for line in body[n:n + m]]


places = {}
for name, (x, y) in (("near", (0, 0)), ("map", (500000, 5400000))):
    points, faces = meshes.torus()
    places[name] = [(p[0] + x, p[1] + y, p[2]) for p in points]
    meshes.write_obj(name + ".obj", places[name], faces)
run = subprocess.run([subprocess.os.environ["R_HOME"] + "/bin/exec/R", "--vanilla", "--slave", "-f", "through.R"],
                     stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
print("\n".join(line for line in run.stdout.split("\n") if "read with" in line))
for name in places:
    for kind, (points, faces) in (("OBJ", meshes.read_obj(name + "_out.obj")), ("PLY", read_ply(name + "_out.ply"))):
        moved = max(min(max(abs(a - b) for a, b in zip(p, q)) for q in places[name]) for p in points)
        print("%s, %s: %s; moved by up to %.2g" % (name, kind, meshes.describe(faces), moved))
END
verdict "$(python3 through.py)" \
"near: read with 288 vertices and 576 triangles
map: read with 288 vertices and 576 triangles
near, OBJ: V 1728, F 576, components 576, Euler characteristic 576, border edges 1728, non-manifold edges 0; moved by up to 1.1e-07
near, PLY: V 1728, F 576, components 576, Euler characteristic 576, border edges 1728, non-manifold edges 0; moved by up to 5.7e-07
map, OBJ: V 1728, F 576, components 576, Euler characteristic 576, border edges 1728, non-manifold edges 0; moved by up to 0.25
map, PLY: V 1728, F 576, components 576, Euler characteristic 576, border edges 1728, non-manifold edges 0; moved by up to 0.5"
