#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK 9.1.0 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkCutter with a vtkPlane, against CGAL 5.5.1 (libcgal-dev
# 5.5.1-2), Polygon_mesh_slicer.
#
# Guess: a plane that contains a flat end of a box gives the border of that end, at both ends alike, or at neither.
# What happens: a vertex on the plane counts as above it. At the top of the box vtkCutter gives the border of the face,
# four segments; at the bottom nothing, not even a point. CGAL's slicer gives the border at both ends, closed. At a
# ridge, four vertices in the plane with faces above and below, both give the four edges once.
#
# Why it matters: sections are seeds of closed curves, and ends of voxel bodies and machine parts lie in the planes that
# one cuts with; of two mirrored bodies one loses a seed. The seeds by sections of this package are taken from the graph
# of the crossed edges of its own surface.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cd "$work"
cat > cut.py << 'END'
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter

corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
points = [(x, y, z) for z in (-1, 0, 1) for x, y in corners]
faces = [(0, 2, 1), (0, 3, 2), (8, 9, 10), (8, 10, 11)]
for k in (0, 4):
    for i in range(4):
        a, b = k + i, k + (i + 1) % 4
        faces += [(a, b, b + 4), (a, b + 4, a + 4)]
print("box:", meshes.describe(faces))
meshes.write_off("box.off", points, faces)
data, coordinates, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
for p in points:
    coordinates.InsertNextPoint(p)
for f in faces:
    polygons.InsertNextCell(3, f)
data.SetPoints(coordinates)
data.SetPolys(polygons)
for z in (1, 0, -1):
    plane, cutter = vtkPlane(), vtkCutter()
    plane.SetOrigin(0, 0, z)
    plane.SetNormal(0, 0, 1)
    cutter.SetCutFunction(plane)
    cutter.SetInputData(data)
    cutter.Update()
    print("vtkCutter at z = %d: %d segments, %d points" % (z, cutter.GetOutput().GetNumberOfLines(),
                                                           cutter.GetOutput().GetNumberOfPoints()))
END
cat > slice.cpp << 'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <cstdio>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  Mesh mesh;
  if(!CGAL::IO::read_OFF("box.off", mesh))
    return EXIT_FAILURE;
  CGAL::Polygon_mesh_slicer<Mesh, Kernel> slicer(mesh);
  for(int z : {1, 0, -1})
  {
    std::vector<std::vector<Kernel::Point_3>> lines;
    slicer(Kernel::Plane_3(0, 0, 1, -z), std::back_inserter(lines));
    for(const auto& line : lines)
      std::printf("Polygon_mesh_slicer at z = %d: %zu segments, %s\n", z, line.size() - 1,
                  line.front() == line.back() ? "closed" : "open");
  }
}
END
compile slice mpfr gmp
verdict "$(python3 cut.py; ./slice)" \
"box: V 12, F 20, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
vtkCutter at z = 1: 4 segments, 4 points
vtkCutter at z = 0: 4 segments, 4 points
vtkCutter at z = -1: 0 segments, 0 points
Polygon_mesh_slicer at z = 1: 4 segments, closed
Polygon_mesh_slicer at z = 0: 4 segments, closed
Polygon_mesh_slicer at z = -1: 4 segments, closed"
