#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2) and 6.0.1 (6.0.1-1 of Debian 13): Surface_mesh_shortest_path, a source point on an
# edge, as face_location(halfedge, t) gives it.
#
# Guess: distances to the source are those from the point(face, weights) of the same location.
# What happens: they are those from the point that lies as far from the other end of the edge. Of the six edges of a
# square of two triangles, inner ones and those of the border, all are mirrored. The same location, moved into the face
# by a thousandth, has the right distances, and so have targets on edges. In the middle of an edge nothing can be seen.
#
# Why it matters: closed curves meet edges, so sources on edges are what one takes to measure from a curve. Distances
# are wrong by up to the length of an edge, and a triangle inequality fails that a proof may rest on. This package takes
# vertices only as sources: it makes a mesh of the strip of a curve that has the points of the curve as vertices.
. "$(dirname "$0")/lib/cgal6.sh"
debian libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cd "$work"
cat > edges.cpp << 'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <cmath>
#include <cstdio>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Paths;

double to_source(const Mesh& mesh, const Paths::Face_location& location, Mesh::Vertex_index v)
{
  Paths paths(mesh);
  paths.add_source_point(location);
  return paths.shortest_distance_to_source_points(v).first;
}

int main()
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}), c = mesh.add_vertex({0, 1, 0}),
             d = mesh.add_vertex({1, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(b, d, c);
  int mirrored = 0, right = 0, right_inside = 0;
  for(auto h : mesh.halfedges()) {
    if(mesh.is_border(h))
      continue;
    const Paths paths(mesh);
    const Paths::Face_location on = paths.face_location(h, 0.25);
    Paths::Face_location inside = on;
    for(double& weight : inside.second)
      weight = 0.998 * weight + 0.002 / 3;
    const auto source = mesh.source(h), target = mesh.target(h);
    const double length = std::sqrt(CGAL::squared_distance(mesh.point(source), mesh.point(target)));
    const double from = std::sqrt(CGAL::squared_distance(paths.point(on.first, on.second), mesh.point(source)));
    const double seen = to_source(mesh, on, source);
    right += std::abs(seen - from) < 1e-9;
    mirrored += std::abs(seen - (length - from)) < 1e-9;
    right_inside += std::abs(to_source(mesh, inside, source) - from) < 1e-2;
  }
  std::printf("on an edge: %d right, %d mirrored; a little inside the face: %d right\n", right, mirrored, right_inside);
}
END
stated="on an edge: 0 right, 6 mirrored; a little inside the face: 6 right"
compile edges gmp mpfr
first=$(./edges)
if [ "$first" != "$stated" ]; then
  verdict "CGAL 5.5.1, $first" "CGAL 5.5.1, $stated"
fi

compile_with_cgal6 edges gmp mpfr
verdict "CGAL 6.0.1, $(./edges)" "CGAL 6.0.1, $stated"
