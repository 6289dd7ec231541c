#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# SFCGAL 1.4.1 (libsfcgal-dev 1.4.1-5): intersection3D() and difference3D() of a line and a cube, and distance3D() and
# difference3D() of a cube and a smaller one within it.
#
# Guess: the part of a line that is in a cube is a segment, and the parts outside are two, all of them exact. The
# distance of a solid from one that contains it is 0, and their difference is a solid with a cavity.
# What happens: of a line that passes through the cube, with both ends outside, the intersection is the point where it
# comes in; with a vertex of the line within the cube, or an end, it is right. The difference is two segments if the
# line is in the middle, and only one of the two if it is beside. A solid within another one has the distance 1, that of
# the surfaces, a point at the same place has 0, and intersects3D() says that the two solids meet. Their difference is
# one shell of 24 faces in two pieces: volume() of it, and every other function that checks its input, throws "not
# connected".
#
# Why it matters: PostGIS offers these functions as ST_3DIntersection and ST_3DDifference. Chords through a neck or
# along an axis are segments through a solid, with both ends outside.
. "$(dirname "$0")/lib/packages.sh"
debian libsfcgal-dev=1.4.1-5 libgmp-dev libmpfr-dev

cat > "$work/solids.cpp" << 'END'
#include <SFCGAL/Solid.h>
#include <SFCGAL/algorithm/difference.h>
#include <SFCGAL/algorithm/distance3d.h>
#include <SFCGAL/algorithm/intersection.h>
#include <SFCGAL/algorithm/intersects.h>
#include <SFCGAL/algorithm/length.h>
#include <SFCGAL/algorithm/volume.h>
#include <SFCGAL/io/wkt.h>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace algorithm = SFCGAL::algorithm;
using Geometry = std::unique_ptr<SFCGAL::Geometry>;

// A cube from low to high in each coordinate.
std::string cube(int low, int high)
{
  const int sides[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  std::string faces;
  for (const auto& side : sides) {
    std::string ring;
    for (int k = 0; k <= 4; ++k) {
      for (const int bit : {4, 2, 1})
        ring += std::to_string((side[k % 4] & bit) != 0 ? high : low) + " ";
      ring.back() = k < 4 ? ',' : ')';
    }
    faces += (faces.empty() ? "((" : ",((") + ring + ")";
  }
  return "SOLID((" + faces + "))";
}

template <class Task> void attempt(const char* what, Task task)
{
  try {
    std::printf("%s: %s\n", what, task().c_str());
  } catch (const std::exception& error) {
    const std::string message = error.what();
    std::printf("%s: exception, %s\n", what, message.substr(0, message.find(" : SOLID")).c_str());
  }
}

std::string number(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", x);
  return text;
}

int main()
{
  const Geometry solid = SFCGAL::io::readWkt(cube(0, 2));
  const std::vector<std::string> lines = {"LINESTRING(-1 1 1,3 1 1)", "LINESTRING(-1 0.5 1,3 0.5 1)",
                                          "LINESTRING(0.5 1 1,3 1 1)", "LINESTRING(-1 1 1,1 1 1,3 1 1)"};
  for (const std::string& text : lines) {
    const Geometry line = SFCGAL::io::readWkt(text);
    attempt(text.c_str(), [&] {
      const Geometry inside = algorithm::intersection3D(*line, *solid);
      const Geometry outside = algorithm::difference3D(*line, *solid);
      return inside->geometryType() + " of length " + number(algorithm::length3D(*inside)) + "; outside " +
             outside->geometryType() + " of " + number(algorithm::length3D(*outside));
    });
  }
  const Geometry outer = SFCGAL::io::readWkt(cube(0, 5)), inner = SFCGAL::io::readWkt(cube(1, 2));
  attempt("distance of a solid within", [&] { return number(algorithm::distance3D(*outer, *inner)); });
  attempt("distance of a point within", [&] {
    return number(algorithm::distance3D(*outer, *SFCGAL::io::readWkt("POINT(1.5 1.5 1.5)")));
  });
  attempt("intersects3D", [&] { return std::string(algorithm::intersects3D(*outer, *inner) ? "yes" : "no"); });
  attempt("intersection3D", [&] {
    return number(CGAL::to_double(algorithm::volume(*algorithm::intersection3D(*outer, *inner))));
  });
  Geometry rest;
  attempt("difference3D", [&] {
    rest = algorithm::difference3D(*outer, *inner);
    return rest->geometryType() + " with " + std::to_string(rest->as<SFCGAL::Solid>().numShells()) + " shell of " +
           std::to_string(rest->as<SFCGAL::Solid>().exteriorShell().numPolygons()) + " faces";
  });
  attempt("its volume", [&] { return number(CGAL::to_double(algorithm::volume(*rest))); });
}
END
compile solids SFCGAL gmp mpfr
verdict "$("$work/solids")" \
"LINESTRING(-1 1 1,3 1 1): Point of length 0.00; outside MultiLineString of 2.00
LINESTRING(-1 0.5 1,3 0.5 1): Point of length 0.00; outside LineString of 1.00
LINESTRING(0.5 1 1,3 1 1): LineString of length 1.50; outside LineString of 1.00
LINESTRING(-1 1 1,1 1 1,3 1 1): LineString of length 2.00; outside MultiLineString of 2.00
distance of a solid within: 1.00
distance of a point within: 0.00
intersects3D: yes
intersection3D: 1.00
difference3D: Solid with 1 shell of 24 faces
its volume: exception, Solid is invalid : PolyhedralSurface (shell) 0 is invalid: not connected"
