#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Gmsh 4.8.4 (gmsh 4.8.4+ds2-3) with Open CASCADE, and Netgen 6.2.1905 (python3-netgen
# 6.2.2006+really6.2.1905+dfsg-5.1+b1) with its own solids: the triangles on the surface of a solid.
#
# Guess: the triangles on the boundary of a solid are oriented outwards, all of them, as the solid knows its inside.
# What happens: in both that holds for a box, a dumbbell, and whatever has no wall that comes from the solid that was
# taken away. A triangle has the orientation of the surface it lies on, and a surface that bounds the solid from the
# other side is not turned. The wall of a pocket in a box and the inner wall of a pipe face into the material: along
# their rims two faces run in the same direction, and the volume by the faces of the pipe is 6.7 for 4.7. The cavity of
# a hollow box is oriented like the outside, so that it counts as filled twice: 1.125 for 0.875. Nothing is said; the
# surfaces are closed. The bore through a box is right in Gmsh, and not in Netgen.
#
# Why it matters: a pipe made by CAD is a plain test for a neck of the space around a body. A halfedge structure refuses
# such a file or tears it along the rims, and where it is taken inside and outside of the cavity are mixed up. The
# program here turns the faces (test Mesh_file.faces_of_another_orientation_are_turned); of a cavity it cannot know. In
# Netgen the descriptor of each face tells the two sides.
. "$(dirname "$0")/lib/packages.sh"
debian gmsh=4.8.4+ds2-3 python3-netgen=6.2.2006+really6.2.1905+dfsg-5.1+b1 python3-tk
export LD_LIBRARY_PATH="$LD_LIBRARY_PATH:$work/root/usr/lib/$triplet/netgen:$work/root/usr/lib"
export PYTHONPATH="$PYTHONPATH:$work/root/usr/lib/python3.11:$work/root/usr/lib/python3.11/lib-dynload"

cd "$work"
cat > solids.py << 'END'
import subprocess
import meshes
from netgen.csg import CSGeometry, Cylinder, OrthoBrick, Pnt, Sphere
from netgen.meshing import MeshingStep


def report(name, points, faces, volume):
    directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
    print("%s: closed %s, edges run through twice in one direction %d, volume by the faces %.2f for %s" % (
        name, "border edges 0, non-manifold edges 0" in meshes.describe(faces), len(directed) - len(set(directed)),
        meshes.volume(points, faces), volume))


def box(low, high):
    return OrthoBrick(Pnt(*low), Pnt(*high))


def tube(radius, low, high):
    cylinder = Cylinder(Pnt(0, 0, low), Pnt(0, 0, high), radius)
    return cylinder * box((-3, -3, low), (3, 3, high))


without = "BooleanDifference{ Volume{1}; Delete;}{ Volume{2}; Delete;}"
cases = {
    "box": ("Box(1) = {-1, -1, -1, 2, 2, 2};", box((-1, -1, -1), (1, 1, 1)), "8"),
    "dumbbell": ("Sphere(1) = {-1.5, 0, 0, 1}; Sphere(2) = {1.5, 0, 0, 1}; Cylinder(3) = {-1.5, 0, 0, 3, 0, 0, 0.3}; "
                 "BooleanUnion{ Volume{1}; Delete;}{ Volume{2, 3}; Delete;}",
                 Sphere(Pnt(0, 0, -1.5), 1) + Sphere(Pnt(0, 0, 1.5), 1) + tube(0.3, -1.5, 1.5), "8.67"),
    "bore": ("Box(1) = {-1, -1, -1, 2, 2, 2}; Cylinder(2) = {0, 0, -2, 0, 0, 4, 0.5}; " + without,
             box((-1, -1, -1), (1, 1, 1)) - tube(0.5, -2, 2), "6.43"),
    "pocket": ("Box(1) = {-1, -1, -1, 2, 2, 2}; Cylinder(2) = {0, 0, 0, 0, 0, 4, 0.5}; " + without,
               box((-1, -1, -1), (1, 1, 1)) - tube(0.5, 0, 4), "7.21"),
    "pipe": ("Cylinder(1) = {0, 0, 0, 0, 0, 2, 1}; Cylinder(2) = {0, 0, 0, 0, 0, 2, 0.5}; " + without,
             tube(1, 0, 2) - tube(0.5, -1, 3), "4.71"),
    "hollow box": ("Box(1) = {0, 0, 0, 1, 1, 1}; Box(2) = {0.25, 0.25, 0.25, 0.5, 0.5, 0.5}; " + without,
                   box((0, 0, 0), (1, 1, 1)) - box((0.25, 0.25, 0.25), (0.75, 0.75, 0.75)), "0.88"),
}
for name, (script, solid, volume) in cases.items():
    with open("solid.geo", "w") as out:
        out.write('SetFactory("OpenCASCADE");\n' + script.replace("; ", ";\n") + "\n")
    subprocess.run(["gmsh", "-2", "-v", "1", "-clmin", "0.3", "-clmax", "0.3", "-format", "stl", "-o", "solid.stl",
                    "solid.geo"], check=True, stdout=subprocess.DEVNULL)
    number = {}
    corners = [number.setdefault(tuple(map(float, line.split()[1:])), len(number))
               for line in open("solid.stl") if line.split()[:1] == ["vertex"]]
    report("Gmsh, " + name, list(number), [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)], volume)
    geometry = CSGeometry()
    geometry.Add(solid)
    mesh = geometry.GenerateMesh(maxh=0.3, perfstepsend=MeshingStep.MESHSURFACE)
    report("Netgen, " + name, [tuple(p.p) for p in mesh.Points()],
           [tuple(v.nr - 1 for v in element.vertices) for element in mesh.Elements2D()], volume)
END
verdict "$(/usr/bin/python3 solids.py | grep "closed")" \
"Gmsh, box: closed True, edges run through twice in one direction 0, volume by the faces 8.00 for 8
Netgen, box: closed True, edges run through twice in one direction 0, volume by the faces 8.00 for 8
Gmsh, dumbbell: closed True, edges run through twice in one direction 0, volume by the faces 8.45 for 8.67
Netgen, dumbbell: closed True, edges run through twice in one direction 0, volume by the faces 8.41 for 8.67
Gmsh, bore: closed True, edges run through twice in one direction 0, volume by the faces 6.49 for 6.43
Netgen, bore: closed True, edges run through twice in one direction 26, volume by the faces 8.52 for 6.43
Gmsh, pocket: closed True, edges run through twice in one direction 11, volume by the faces 7.24 for 7.21
Netgen, pocket: closed True, edges run through twice in one direction 13, volume by the faces 8.26 for 7.21
Gmsh, pipe: closed True, edges run through twice in one direction 22, volume by the faces 6.73 for 4.71
Netgen, pipe: closed True, edges run through twice in one direction 26, volume by the faces 6.73 for 4.71
Gmsh, hollow box: closed True, edges run through twice in one direction 0, volume by the faces 1.12 for 0.88
Netgen, hollow box: closed True, edges run through twice in one direction 0, volume by the faces 1.13 for 0.88"
