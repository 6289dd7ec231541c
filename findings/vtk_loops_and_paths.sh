#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): vtkStripper on a closed polyline, and
# vtkDijkstraGraphGeodesicPath.
#
# Guess: vtkStripper joins the segments of one closed curve to one polyline that begins with the first segment, and a
# shortest path goes from the start vertex to the end vertex; without a path it is empty.
# What happens: a polyline of vtkStripper has at most 1000 segments, a limit that SetMaximumLength() changes. A loop of
# 1500 segments comes back as two open pieces. JoinContiguousSegmentsOn() makes one polyline of them, which begins and
# ends at the place of the cut, with one point more than it should have: 1502 for 1500 different ones. The path runs
# from the end vertex to the start vertex. To a vertex that cannot be reached it has one point, the end vertex: a path
# of length zero, with no error.
#
# Why it matters: both are the usual ways to get loops of edges for "constrictions tighten --loops". A loop in pieces is
# no closed curve, and a test "length 0, so already there" takes two components for one.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1

cat > "$work/loops.py" << 'END'
import math
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkStripper
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath


def poly_data(points, cells, lines=False):
    data, coordinates, array = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetDataTypeToDouble()
    for p in points:
        coordinates.InsertNextPoint(p)
    for c in cells:
        array.InsertNextCell(len(c), c)
    data.SetPoints(coordinates)
    data.SetLines(array) if lines else data.SetPolys(array)
    return data


n = 1500
circle = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), 0) for i in range(n)]
loop = poly_data(circle, [(i, (i + 1) % n) for i in range(n)], lines=True)
for join in (False, True):
    stripper = vtkStripper()
    stripper.SetInputData(loop)
    stripper.SetJoinContiguousSegments(join)
    stripper.Update()
    out = stripper.GetOutput()
    ids = [[out.GetCell(i).GetPointId(k) for k in range(out.GetCell(i).GetNumberOfPoints())]
           for i in range(out.GetNumberOfCells())]
    print("joined:" if join else "strips:", ", ".join("%d points from %d to %d" % (len(l), l[0], l[-1]) for l in ids),
          "; different points", len(set(sum(ids, []))))

torus, octahedron = meshes.torus(), meshes.octahedron()
points = torus[0] + [(x + 50, y, z) for x, y, z in octahedron[0]]
faces = torus[1] + [tuple(i + len(torus[0]) for i in f) for f in octahedron[1]]
for end in (100, len(torus[0])):
    path = vtkDijkstraGraphGeodesicPath()
    path.SetInputData(poly_data(points, faces))
    path.SetStartVertex(0)
    path.SetEndVertex(end)
    path.Update()
    ids = [path.GetIdList().GetId(i) for i in range(path.GetIdList().GetNumberOfIds())]
    print("path from 0 to %d: %d points, first %d, last %d" % (end, len(ids), ids[0], ids[-1]))
END
verdict "$(python3 "$work/loops.py")" \
"strips: 1001 points from 0 to 1000, 501 points from 1000 to 0 ; different points 1500
joined: 1502 points from 1000 to 1000 ; different points 1500
path from 0 to 100: 10 points, first 100, last 0
path from 0 to 288: 1 points, first 288, last 288"
