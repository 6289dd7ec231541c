#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), the level set of an image whose axes are turned or
# mirrored (vtkImageData::SetDirectionMatrix), by four filters.
#
# Guess: the surface around the bright ball of an image lies by all four filters where the image has the ball, and faces
# outwards, also if an axis is mirrored.
# What happens: vtkSynchronizedTemplates3D and vtkContourFilter, which uses it, leave the axes out: the surface is the
# one of an image that is not turned, in another place. vtkMarchingCubes and vtkFlyingEdges3D put it where it belongs,
# but in a mirrored image its triangles face inwards. All are closed, and nothing is said.
#
# Why it matters: images of scanners often have a mirrored axis in the coordinates of NIfTI, and whoever hands it on,
# which VTK can since version 9, gets a surface in the wrong place or a solid that is turned inside out, where a neck of
# the body is taken for one of the space around it. A measure of length alone notices neither.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/images.py" << 'END'
import math
import meshes
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import (vtkContourFilter, vtkFlyingEdges3D, vtkMarchingCubes,
                                       vtkSynchronizedTemplates3D)

n = 21
center = (9, 10, 11)
for name, axes in (("as it is", (1, 0, 0, 0, 1, 0, 0, 0, 1)), ("turned", (0, -1, 0, 1, 0, 0, 0, 0, 1)),
                   ("mirrored", (-1, 0, 0, 0, 1, 0, 0, 0, 1))):
    image, values = vtkImageData(), vtkDoubleArray()
    for k in range(n):
        for j in range(n):
            for i in range(n):
                values.InsertNextValue(7.3 - math.dist((i, j, k), center))
    image.SetDimensions(n, n, n)
    image.SetDirectionMatrix(*axes)
    image.GetPointData().SetScalars(values)
    middle = [sum(axes[3 * row + column] * center[column] for column in range(3)) for row in range(3)]
    for Filter in (vtkMarchingCubes, vtkFlyingEdges3D, vtkSynchronizedTemplates3D, vtkContourFilter):
        level = Filter()
        level.SetInputData(image)
        level.SetValue(0, 0)
        level.Update()
        out = level.GetOutput()
        points = [out.GetPoint(i) for i in range(out.GetNumberOfPoints())]
        faces = [tuple(out.GetCell(i).GetPointId(k) for k in range(3)) for i in range(out.GetNumberOfCells())]
        bounds = out.GetBounds()
        print("%s, centre %d %d %d, %s: centre %.0f %.0f %.0f, closed %s, volume by the faces %.0f" % (
            name, *middle, Filter.__name__, *(sum(bounds[i:i + 2]) / 2 for i in (0, 2, 4)),
            "border edges 0, non-manifold edges 0" in meshes.describe(faces), meshes.volume(points, faces)))
END
verdict "$(python3 "$work/images.py")" \
"as it is, centre 9 10 11, vtkMarchingCubes: centre 9 10 11, closed True, volume by the faces 1611
as it is, centre 9 10 11, vtkFlyingEdges3D: centre 9 10 11, closed True, volume by the faces 1611
as it is, centre 9 10 11, vtkSynchronizedTemplates3D: centre 9 10 11, closed True, volume by the faces 1611
as it is, centre 9 10 11, vtkContourFilter: centre 9 10 11, closed True, volume by the faces 1611
turned, centre -10 9 11, vtkMarchingCubes: centre -10 9 11, closed True, volume by the faces 1611
turned, centre -10 9 11, vtkFlyingEdges3D: centre -10 9 11, closed True, volume by the faces 1611
turned, centre -10 9 11, vtkSynchronizedTemplates3D: centre 9 10 11, closed True, volume by the faces 1611
turned, centre -10 9 11, vtkContourFilter: centre 9 10 11, closed True, volume by the faces 1611
mirrored, centre -9 10 11, vtkMarchingCubes: centre -9 10 11, closed True, volume by the faces -1611
mirrored, centre -9 10 11, vtkFlyingEdges3D: centre -9 10 11, closed True, volume by the faces -1611
mirrored, centre -9 10 11, vtkSynchronizedTemplates3D: centre 9 10 11, closed True, volume by the faces 1611
mirrored, centre -9 10 11, vtkContourFilter: centre 9 10 11, closed True, volume by the faces 1611"
