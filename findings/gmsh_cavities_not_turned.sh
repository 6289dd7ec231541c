#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Gmsh 4.8.4 (gmsh 4.8.4+ds2-3) with Open CASCADE: the surface of a solid, meshed and written as STL.
#
# Guess: the triangles on the boundary of a solid are oriented outwards, all of them, as the solid knows its inside.
# What happens: that holds for a box, a dumbbell, and a box with a bore. A triangle has the orientation of the surface
# it lies on, and a surface that bounds the solid from the other side is not turned. The wall of a pocket in a box and
# the inner wall of a pipe face into the material: along their rims two faces run in the same direction, and the volume
# by the faces of the pipe is 6.7 for 4.7. The cavity of a hollow box is oriented like the outside, so that it counts as
# filled twice: 1.12 for 0.875. Nothing is said; the files are closed.
#
# Why it matters: a pipe made by CAD is a plain test for a neck of the space around a body. A halfedge structure refuses
# such a file or tears it along the rims, and where it is taken inside and outside of the cavity are mixed up. The
# program here turns the faces (test Mesh_file.faces_of_another_orientation_are_turned); of a cavity it cannot know.
. "$(dirname "$0")/lib/packages.sh"
debian gmsh=4.8.4+ds2-3

cd "$work"
cat > solids.py << 'END'
import subprocess
import meshes

cases = {
    "box": ("Box(1) = {-1, -1, -1, 2, 2, 2};", "8"),
    "dumbbell": ("Sphere(1) = {-1.5, 0, 0, 1}; Sphere(2) = {1.5, 0, 0, 1}; Cylinder(3) = {-1.5, 0, 0, 3, 0, 0, 0.3}; "
                 "BooleanUnion{ Volume{1}; Delete;}{ Volume{2, 3}; Delete;}", "8.673"),
    "bore": ("Box(1) = {-1, -1, -1, 2, 2, 2}; Cylinder(2) = {0, 0, -2, 0, 0, 4, 0.5}; "
             "BooleanDifference{ Volume{1}; Delete;}{ Volume{2}; Delete;}", "6.429"),
    "pocket": ("Box(1) = {-1, -1, -1, 2, 2, 2}; Cylinder(2) = {0, 0, 0, 0, 0, 4, 0.5}; "
               "BooleanDifference{ Volume{1}; Delete;}{ Volume{2}; Delete;}", "7.215"),
    "pipe": ("Cylinder(1) = {0, 0, 0, 0, 0, 2, 1}; Cylinder(2) = {0, 0, 0, 0, 0, 2, 0.5}; "
             "BooleanDifference{ Volume{1}; Delete;}{ Volume{2}; Delete;}", "4.712"),
    "hollow box": ("Box(1) = {0, 0, 0, 1, 1, 1}; Box(2) = {0.25, 0.25, 0.25, 0.5, 0.5, 0.5}; "
                   "BooleanDifference{ Volume{1}; Delete;}{ Volume{2}; Delete;}", "0.875"),
}
for name, (solid, volume) in cases.items():
    with open("solid.geo", "w") as out:
        out.write('SetFactory("OpenCASCADE");\n' + solid.replace("; ", ";\n") + "\n")
    subprocess.run(["gmsh", "-2", "-v", "1", "-clmin", "0.3", "-clmax", "0.3", "-format", "stl", "-o", "solid.stl",
                    "solid.geo"], check=True, stdout=subprocess.DEVNULL)
    number = {}
    corners = [number.setdefault(tuple(map(float, line.split()[1:])), len(number))
               for line in open("solid.stl") if line.split()[:1] == ["vertex"]]
    faces = [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
    directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
    print("%s: closed %s, edges run through twice in one direction %d, volume by the faces %.2f for %s" % (
        name, "border edges 0, non-manifold edges 0" in meshes.describe(faces), len(directed) - len(set(directed)),
        meshes.volume(list(number), faces), volume))
END
verdict "$(python3 solids.py)" \
"box: closed True, edges run through twice in one direction 0, volume by the faces 8.00 for 8
dumbbell: closed True, edges run through twice in one direction 0, volume by the faces 8.45 for 8.673
bore: closed True, edges run through twice in one direction 0, volume by the faces 6.49 for 6.429
pocket: closed True, edges run through twice in one direction 11, volume by the faces 7.24 for 7.215
pipe: closed True, edges run through twice in one direction 22, volume by the faces 6.73 for 4.712
hollow box: closed True, edges run through twice in one direction 0, volume by the faces 1.12 for 0.875"
