#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkFillHolesFilter.
#
# Guess: the triangles that fill a hole are oriented as their neighbours are.
# What happens: they are oriented the other way round. A dumbbell without the fan of faces at one end is closed, has
# every face once, and each edge of the filled hole is run through twice in the same direction; the volume that the
# faces enclose comes out wrong, 0.221 for 0.337. A single missing triangle of a torus comes back turned over.
#
# Why it matters: filling holes is what one does to give an open scan to a program for closed surfaces. A halfedge
# structure refuses the file as not orientable or tears it at the rim of the patch; areas, volumes and the side on which
# a curve chokes come from the orientation. The program here turns faces of a file to one orientation (test
# Mesh_file.faces_of_another_orientation_are_turned); on such a dumbbell it finds the same neck as on the whole one.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/fill.py" << 'END'
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter


def fill(points, faces):
    data, coordinates, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetDataTypeToDouble()
    for p in points:
        coordinates.InsertNextPoint(p)
    for f in faces:
        polygons.InsertNextCell(3, f)
    data.SetPoints(coordinates)
    data.SetPolys(polygons)
    holes = vtkFillHolesFilter()
    holes.SetInputData(data)
    holes.SetHoleSize(1e9)
    holes.Update()
    out = holes.GetOutput()
    return [tuple(out.GetCell(i).GetPointId(k) for k in range(3)) for i in range(out.GetNumberOfCells())]


def twice(faces):
    runs = [e for f in faces for e in zip(f, f[1:] + f[:1])]
    return len(runs) - len(set(runs))


points, faces = meshes.dumbbell(0.05, 16, 20)
for name, rest in (("fan of 16", [f for f in faces if 0 not in f]), ("one face", faces[:40] + faces[41:])):
    filled = fill(points, rest)
    print("%s missing: %s" % (name, meshes.describe(filled)))
    print("  edges run through twice in one direction: %d; volume %.3f, of the whole body %.3f" % (
        twice(filled), meshes.volume(points, filled), meshes.volume(points, faces)))
END
verdict "$(python3 "$work/fill.py")" \
"fan of 16 missing: V 305, F 606, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  edges run through twice in one direction: 16; volume 0.221, of the whole body 0.337
one face missing: V 306, F 608, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  edges run through twice in one direction: 3; volume 0.334, of the whole body 0.337"
