#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkTubeFilter, with a line whose last point is its first.
#
# Guess: the tube around a closed line is a closed ring with Euler characteristic 0, and caps are made where a line ends
# only, since first and last point of the line are one.
# What happens: the tube begins and ends at that point like one around an open line. Each end is perpendicular to its
# own segment, so that the two circles meet in one edge at the inside of a bend, if at all, and leave a wedge open at
# the outside. Without caps the tube has 24 border edges there; with caps, two disks close it within the ring, and it is
# a bent rod, Euler characteristic 2, or touches itself along an edge. Places were joined before counting.
#
# Why it matters: closed curves are shown, printed and intersected as tubes, in ParaView by a filter on this one. The
# ring one counts on, a torus, is not there, and on a curve with few points the wedge can be seen.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/tubes.py" << 'END'
import math
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter, vtkTubeFilter


def circle(n):
    return [(2 * math.cos(2 * math.pi * i / n), 2 * math.sin(2 * math.pi * i / n), 0) for i in range(n)]


def saddle(n):
    return [(x, y, 0.5 * math.cos(4 * math.pi * i / n)) for i, (x, y, z) in enumerate(circle(n))]


for name, points, line in (("straight line", [(0, 0, 0), (1, 0, 0), (2, 0, 0)], [0, 1, 2]),
                           ("circle of 40", circle(40), [*range(40), 0]), ("circle of 41", circle(41), [*range(41), 0]),
                           ("saddle of 40", saddle(40), [*range(40), 0])):
    for caps in (True, False):
        data, coordinates, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
        coordinates.SetDataTypeToDouble()
        for p in points:
            coordinates.InsertNextPoint(p)
        lines.InsertNextCell(len(line), line)
        data.SetPoints(coordinates)
        data.SetLines(lines)
        tube, triangles = vtkTubeFilter(), vtkTriangleFilter()
        tube.SetInputData(data)
        tube.SetRadius(0.2)
        tube.SetNumberOfSides(12)
        tube.SetCapping(caps)
        triangles.SetInputConnection(tube.GetOutputPort())
        triangles.Update()
        out = triangles.GetOutput()
        places = {}
        joined = [places.setdefault(tuple(round(c, 4) + 0.0 for c in out.GetPoint(i)), len(places))
                  for i in range(out.GetNumberOfPoints())]
        faces = [tuple(joined[out.GetCell(i).GetPointId(k)] for k in range(3)) for i in range(out.GetNumberOfCells())]
        print("%s, caps %s, places joined: %s" % (name, caps, meshes.describe(faces)))
END
verdict "$(python3 "$work/tubes.py")" \
"straight line, caps True, places joined: V 36, F 68, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
straight line, caps False, places joined: V 36, F 48, components 1, Euler characteristic 0, border edges 24, non-manifold edges 0
circle of 40, caps True, places joined: V 490, F 980, components 1, Euler characteristic 1, border edges 0, non-manifold edges 1
circle of 40, caps False, places joined: V 490, F 960, components 1, Euler characteristic -2, border edges 24, non-manifold edges 0
circle of 41, caps True, places joined: V 502, F 1004, components 1, Euler characteristic 1, border edges 0, non-manifold edges 1
circle of 41, caps False, places joined: V 502, F 984, components 1, Euler characteristic -2, border edges 24, non-manifold edges 0
saddle of 40, caps True, places joined: V 492, F 980, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
saddle of 40, caps False, places joined: V 492, F 960, components 1, Euler characteristic 0, border edges 24, non-manifold edges 0"
