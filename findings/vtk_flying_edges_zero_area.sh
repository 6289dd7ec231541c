#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkFlyingEdges3D beside vtkMarchingCubes.
#
# Guess: the faster filter makes the same mesh as the older one, up to the order, also where samples are equal to the
# value of the contour, as in a distance that has been rounded to whole numbers.
# What happens: vtkMarchingCubes merges the points that fall on a sample and leaves out the triangles between them;
# vtkFlyingEdges3D keeps both. Around a ball of radius 7, where 30 samples lie on the sphere, it writes 240 triangles of
# area zero and 120 points twice; where no sample is hit the two meshes are equally large.
#
# Why it matters: edges of length zero and triangles without a plane are what exact predicates and angles cannot use. The
# points are different vertices, so that the mesh looks closed and manifold, and nothing warns. The program here
# collapses edges of length zero and says how many (test Repair.edges_of_length_zero_are_collapsed).
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/contours.py" << 'END'
import meshes
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkMarchingCubes

N = 21
image, values = vtkImageData(), vtkDoubleArray()
image.SetDimensions(N, N, N)
for z in range(N):
    for y in range(N):
        for x in range(N):
            values.InsertNextValue(-((x - 10) ** 2 + (y - 10) ** 2 + (z - 10) ** 2))
image.GetPointData().SetScalars(values)


def area(p, q, r):
    u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
    return sum((u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) ** 2 for i in range(3)) ** 0.5 / 2


for level in (-49, -49.5):
    for make in (vtkMarchingCubes, vtkFlyingEdges3D):
        contour = make()
        contour.SetInputData(image)
        contour.SetValue(0, level)
        contour.Update()
        out = contour.GetOutput()
        points = [out.GetPoint(i) for i in range(out.GetNumberOfPoints())]
        faces = [tuple(out.GetCell(i).GetPointId(k) for k in range(3)) for i in range(out.GetNumberOfCells())]
        print("%s at %g: V %d, of these twice %d; F %d, of area zero %d; border edges %s" % (
            make.__name__, level, len(points), len(points) - len(set(points)), len(faces),
            sum(area(*(points[i] for i in f)) == 0 for f in faces),
            meshes.describe(faces).split("border edges ")[1].split(",")[0]))
END
verdict "$(/usr/bin/python3 "$work/contours.py")" \
"vtkMarchingCubes at -49: V 774, of these twice 0; F 1544, of area zero 0; border edges 0
vtkFlyingEdges3D at -49: V 894, of these twice 120; F 1784, of area zero 240; border edges 0
vtkMarchingCubes at -49.5: V 894, of these twice 0; F 1784, of area zero 0; border edges 0
vtkFlyingEdges3D at -49.5: V 894, of these twice 0; F 1784, of area zero 0; border edges 0"
