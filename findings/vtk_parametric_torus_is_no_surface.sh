#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): vtkParametricFunctionSource of vtkParametricTorus and
# vtkParametricEllipsoid.
#
# Guess: either the torus is cut open along two circles, with the points there twice, or the switches JoinU and JoinV,
# on from the start, make it closed.
# What happens: both at once. The first and the last row of points are at one place, and a band of flat triangles is put
# between them. The triangles of that band do not fit to each other: in one direction their diagonals cross, in the
# other they belong to neighbouring rows. The torus of 24 by 12 points has edges of three faces, 81 border edges and
# Euler characteristic -35; the ellipsoid is no better. Nothing is seen of it in a picture. vtkCleanPolyData as it is
# changes nothing, since the places differ in the last digits; with a tolerance of 1e-6 it gives a closed torus of 23 by
# 11 points.
#
# Why it matters: it is the torus that one takes to try a program on, and its necks are known. As it comes
# "constrictions check" calls it a surface that cannot be oriented, and the faces it names as the reason are not to be
# seen.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/torus.py" << 'END'
import meshes
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricEllipsoid, vtkParametricTorus
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource


def report(name, data):
    faces, flat = [], 0
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        faces.append(tuple(cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())))
        flat += len(faces[-1]) > 2 and cell.ComputeArea() < 1e-6
    print("%s: %s; flat %d" % (name, meshes.describe([f for f in faces if len(f) > 2]), flat))


for surface in (vtkParametricTorus(), vtkParametricEllipsoid()):
    name = surface.GetClassName()[13:].lower()
    for join in (True, False):
        if not join:
            surface.JoinUOff()
            surface.JoinVOff()
        source, clean = vtkParametricFunctionSource(), vtkCleanPolyData()
        source.SetParametricFunction(surface)
        source.SetUResolution(24)
        source.SetVResolution(12)
        source.Update()
        clean.SetInputConnection(source.GetOutputPort())
        clean.Update()
        report(name + ("" if join else ", switches off"), source.GetOutput())
        report("  cleaned", clean.GetOutput())
        clean.SetTolerance(1e-6)
        clean.Update()
        report("  cleaned to 1e-6", clean.GetOutput())
END
verdict "$(python3 "$work/torus.py")" \
"torus: V 288, F 576, components 1, Euler characteristic -35, border edges 81, non-manifold edges 11; flat 70
  cleaned: V 288, F 576, components 1, Euler characteristic -35, border edges 81, non-manifold edges 11; flat 70
  cleaned to 1e-6: V 253, F 506, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0; flat 0
torus, switches off: V 288, F 506, components 1, Euler characteristic 1, border edges 68, non-manifold edges 0; flat 0
  cleaned: V 288, F 506, components 1, Euler characteristic 1, border edges 68, non-manifold edges 0; flat 0
  cleaned to 1e-6: V 253, F 506, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0; flat 0
ellipsoid: V 288, F 528, components 1, Euler characteristic -11, border edges 81, non-manifold edges 11; flat 68
  cleaned: V 265, F 504, components 1, Euler characteristic -9, border edges 54, non-manifold edges 10; flat 44
  cleaned to 1e-6: V 232, F 460, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; flat 0
ellipsoid, switches off: V 288, F 506, components 1, Euler characteristic 1, border edges 68, non-manifold edges 0; flat 46
  cleaned: V 265, F 483, components 1, Euler characteristic 1, border edges 45, non-manifold edges 0; flat 23
  cleaned to 1e-6: V 232, F 460, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; flat 0"
