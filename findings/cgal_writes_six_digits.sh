#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2): IO::write_polygon_mesh() with a file name.
#
# Guess: a function that is given a name and a mesh of doubles writes a file that gives the same mesh again, and
# use_binary_mode(true) makes it binary, or fails where the format has none.
# What happens: OFF, OBJ and text PLY have six digits unless stream_precision is given. use_binary_mode(true) is taken
# without a word for OFF, which CGAL can write in no binary form, and the file is the same text. A torus of radius 2
# that lies 1e6 away from the origin, an ordinary position in a map or a scan, comes back with its 312 points at 88
# places.
#
# Why it matters: the lengths, and with them which of two necks is shorter, are those of another surface; exact ties of
# flat bands are gone. The program here writes all digits of a double into each of its formats.
. "$(dirname "$0")/lib/packages.sh"
debian libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cat > "$work/write.cpp" << 'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <cmath>
#include <cstdio>
#include <set>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  Mesh tetrahedron;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1. / 3, 0, 0), Kernel::Point_3(0, 1. / 3, 0),
                         Kernel::Point_3(0, 0, 1. / 3), tetrahedron);
  for(const char* name : {"t.off", "t.obj", "t.ply"})
    for(bool binary : {false, true})
    {
      Mesh mesh;
      const bool written = CGAL::IO::write_polygon_mesh(name, tetrahedron, CGAL::parameters::use_binary_mode(binary));
      if(!written || !CGAL::IO::read_polygon_mesh(name, mesh))
        return EXIT_FAILURE;
      double x = 0;
      for(auto v : mesh.vertices())
        x = std::max(x, mesh.point(v).x());
      std::printf("%s, binary %s: 1 / 3 comes back as %.17g\n", name, binary ? "asked for" : "not asked for", x);
    }
  // A torus of quadrilaterals, whose six digits are used up by its place.
  Mesh torus;
  CGAL::make_grid(24, 12, torus, [](double i, double j) {
    const double a = i * CGAL_PI / 12, b = j * CGAL_PI / 6, r = 2 + std::cos(b);
    return Kernel::Point_3(1e6 + r * std::cos(a), 1e6 + r * std::sin(a), std::sin(b));
  });
  Mesh mesh;
  CGAL::IO::write_polygon_mesh("torus.off", torus);
  CGAL::IO::read_polygon_mesh("torus.off", mesh);
  const auto places = [](const Mesh& m) {
    std::set<Kernel::Point_3> result;
    for(auto v : m.vertices())
      result.insert(m.point(v));
    return result.size();
  };
  std::printf("grid on a torus at 1e6: %zu different places, %zu after writing and reading\n", places(torus),
              places(mesh));
}
END
compile write mpfr gmp
cd "$work"
verdict "$(./write)" "t.off, binary not asked for: 1 / 3 comes back as 0.33333299999999999
t.off, binary asked for: 1 / 3 comes back as 0.33333299999999999
t.obj, binary not asked for: 1 / 3 comes back as 0.33333299999999999
t.obj, binary asked for: 1 / 3 comes back as 0.33333299999999999
t.ply, binary not asked for: 1 / 3 comes back as 0.33333299999999999
t.ply, binary asked for: 1 / 3 comes back as 0.33333333333333331
grid on a torus at 1e6: 312 different places, 88 after writing and reading"
