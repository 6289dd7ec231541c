#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): vtkPlatonicSolidSource, and vtkLinearExtrusionFilter with
# capping.
#
# Guess: the faces of a ready-made solid are oriented outwards, for one solid as for another, and a polygon that is
# extruded along its normal gives a body with faces that fit to each other.
# What happens: cube, octahedron and dodecahedron are oriented outwards, tetrahedron and icosahedron inwards. Of the
# extruded body the polygon itself is the one end and a copy of it the other, both facing the same way: the polygon does
# not fit to the sides, and along its edges two faces run in the same direction. Extruded against the normal the sides
# and the copy face inwards besides. For a unit cube at height 1/3 the faces enclose a volume of 1.222 or -0.778.
#
# Why it matters: an icosahedron is what a sphere is made of by subdivision. The side of a curve on which the surface
# chokes, and convex and concave, change places on a body inside out; a halfedge structure does not take the extruded
# one at all. The program here turns the faces of a file to one orientation (test
# Mesh_file.faces_of_another_orientation_are_turned), and goes by the sign of the volume.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/solids.py" << 'END'
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource


def report(name, source):
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    out, faces = triangles.GetOutput(), []
    for i in range(out.GetNumberOfCells()):
        cell = out.GetCell(i)
        faces.append(tuple(cell.GetPointId(k) for k in range(3)))
    points = [out.GetPoint(i) for i in range(out.GetNumberOfPoints())]
    directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
    print("%s: volume %.3f, edges run through twice in one direction %d" % (
        name, meshes.volume(points, faces), len(directed) - len(set(directed))))


for solid, name in enumerate(("tetrahedron", "cube", "octahedron", "icosahedron", "dodecahedron")):
    source = vtkPlatonicSolidSource()
    source.SetSolidType(solid)
    report(name, source)
data, coordinates, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
    coordinates.InsertNextPoint(x, y, 1 / 3)
polygons.InsertNextCell(4, (0, 1, 2, 3))
data.SetPoints(coordinates)
data.SetPolys(polygons)
for direction in (1, -1):
    extrusion = vtkLinearExtrusionFilter()
    extrusion.SetInputData(data)
    extrusion.SetExtrusionTypeToVectorExtrusion()
    extrusion.SetVector(0, 0, direction)
    extrusion.CappingOn()
    report("square, extruded " + ("along its normal" if direction == 1 else "against it"), extrusion)
END
verdict "$(python3 "$work/solids.py")" \
"tetrahedron: volume -0.513, edges run through twice in one direction 0
cube: volume 1.540, edges run through twice in one direction 0
octahedron: volume 1.333, edges run through twice in one direction 0
icosahedron: volume -2.536, edges run through twice in one direction 0
dodecahedron: volume 2.785, edges run through twice in one direction 0
square, extruded along its normal: volume 1.222, edges run through twice in one direction 4
square, extruded against it: volume -0.778, edges run through twice in one direction 4"
