#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkWindowedSincPolyDataFilter.
#
# Guess: smoothing a mesh that was moved gives the smoothed mesh, moved; only rounding depends on the place.
# What happens: the whole mesh is drawn towards the origin, with pass band 0.1 and 20 iterations by 0.16% of its
# distance from it: a torus of radius 3 at x = 1000 ends 1.6 away from where it was, and one at 1e6, a body in map
# coordinates, 1610. The shape is smoothed as at the origin. NormalizeCoordinatesOn() changes this: the mesh then stays
# in its place.
#
# Why it matters: this is the usual filter after marching cubes, and it is praised since it does not shrink. Curves that
# were found on the smoothed surface lie beside the body that they are drawn on, and of two parts that were smoothed one
# by one the cuts no longer fit.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/smooth.py" << 'END'
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkWindowedSincPolyDataFilter

points, faces = meshes.torus()
for shift in (0, 1000, 1000000):
    data, coordinates, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetDataTypeToDouble()
    for x, y, z in points:
        coordinates.InsertNextPoint(x + shift, y, z)
    for f in faces:
        polygons.InsertNextCell(3, f)
    data.SetPoints(coordinates)
    data.SetPolys(polygons)
    for normalize in (False, True):
        smoothing = vtkWindowedSincPolyDataFilter()
        smoothing.SetInputData(data)
        smoothing.SetPassBand(0.1)
        smoothing.SetNumberOfIterations(20)
        smoothing.SetNormalizeCoordinates(normalize)
        smoothing.Update()
        out = smoothing.GetOutput()
        moved = [out.GetPoint(i) for i in range(out.GetNumberOfPoints())]
        middle = sum(p[0] for p in moved) / len(moved)
        volume = meshes.volume([(x - middle, y, z) for x, y, z in moved], faces)
        print("middle at %d, %s: moved by %.4f, volume %.3f for %.3f" % (
            shift, "normalized" if normalize else "as it is", middle - shift + 0, volume, meshes.volume(points, faces)))
END
verdict "$(python3 "$work/smooth.py" | sed 's/-0\.0000/0.0000/')" \
"middle at 0, as it is: moved by 0.0000, volume 36.673 for 37.270
middle at 0, normalized: moved by 0.0000, volume 36.673 for 37.270
middle at 1000, as it is: moved by -1.6100, volume 36.673 for 37.270
middle at 1000, normalized: moved by 0.0000, volume 36.673 for 37.270
middle at 1000000, as it is: moved by -1609.9821, volume 36.673 for 37.270
middle at 1000000, normalized: moved by 0.0000, volume 36.673 for 37.270"
