// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef OPEN_MESHES_H
#define OPEN_MESHES_H

// Surfaces with boundary, as points and faces: closed ones from which faces have been taken. Vertices keep their
// numbers, so some are on no face.

#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace open_meshes {

using test_meshes::Position;
using test_meshes::Soup;
using test_meshes::Triangle;

template <class Predicate>
Soup without_faces(Soup soup, const Predicate& is_taken)
{
  soup.faces.erase(std::remove_if(soup.faces.begin(), soup.faces.end(), is_taken), soup.faces.end());
  return soup;
}

inline Soup without_star(const Soup& soup, std::size_t v)
{
  return without_faces(soup, [v](const Triangle& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
}

inline Soup without_face(Soup soup, std::size_t f)
{
  soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
  return soup;
}

// A regular tube without ends: rings of n vertices on circles, given by radius and height.
inline Soup open_tube(int n, const std::vector<std::array<double, 2>>& profile)
{
  test_meshes::Soup_builder b;
  const auto at = [&](int i, const std::array<double, 2>& p) {
    const double phi = 2 * CGAL_PI * (i % n) / n;
    return Position{{p[0] * std::cos(phi), p[0] * std::sin(phi), p[1]}};
  };
  for(std::size_t r = 0; r + 1 < profile.size(); ++r)
    for(int i = 0; i < n; ++i)
      b.quad(at(i, profile[r]), at(i + 1, profile[r]), at(i + 1, profile[r + 1]), at(i, profile[r + 1]));
  return b.soup;
}

// A tube of the given width along a square, as wide as long in whole units, with exact coordinates: its sides are flat.
inline Soup square_tube(int width, int length)
{
  test_meshes::Soup_builder b;
  const std::array<std::array<int, 2>, 4> corner = {{{{0, 0}}, {{width, 0}}, {{width, width}}, {{0, width}}}};
  const auto at = [&](int i, int z) {
    const std::size_t side = static_cast<std::size_t>(i / width) % 4, next = (side + 1) % 4;
    const double t = static_cast<double>(i % width) / width;
    return Position{{corner[side][0] + t * (corner[next][0] - corner[side][0]),
                     corner[side][1] + t * (corner[next][1] - corner[side][1]), static_cast<double>(z)}};
  };
  for(int z = 0; z < length; ++z)
    for(int i = 0; i < 4 * width; ++i)
      b.quad(at(i, z), at(i + 1, z), at(i + 1, z + 1), at(i, z + 1), (i + z) % 2 == 0);
  return b.soup;
}

// Takes faces from a closed surface at random: single ones, and stars of vertices. No two of what is taken touch, so
// that what is left is a surface.
inline Soup with_random_holes(const Soup& soup, std::size_t holes, unsigned seed)
{
  std::mt19937 random(seed);
  Soup result = soup;
  std::set<std::size_t> touched;
  for(std::size_t tries = 0, made = 0; made < holes && tries < 200; ++tries)
  {
    const bool is_star = random() % 2 == 0;
    const std::size_t f = random() % soup.faces.size(), v = soup.faces[f][0];
    std::set<std::size_t> corners;
    std::vector<Triangle> taken;
    for(std::size_t g = 0; g < soup.faces.size(); ++g)
      if(is_star ? std::count(soup.faces[g].begin(), soup.faces[g].end(), v) != 0 : g == f)
      {
        taken.push_back(soup.faces[g]);
        corners.insert(soup.faces[g].begin(), soup.faces[g].end());
      }
    if(std::any_of(corners.begin(), corners.end(), [&](std::size_t c) { return touched.count(c) != 0; }))
      continue;
    touched.insert(corners.begin(), corners.end());
    result = without_faces(result,
                           [&](const Triangle& t) { return std::find(taken.begin(), taken.end(), t) != taken.end(); });
    ++made;
  }
  return result;
}

} // namespace open_meshes

#endif // OPEN_MESHES_H
