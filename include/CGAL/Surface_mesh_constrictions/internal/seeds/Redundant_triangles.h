// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_REDUNDANT_TRIANGLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_REDUNDANT_TRIANGLES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Removes those seeds of one level that are triangles of three edges, no faces, and lead where other ones lead:
// - those that have been found on a finer level. A triangle is found again whenever a collapse moves one of its corners.
//   It is the same closed curve on all these levels;
// - those that become shorter when they are led around two faces. If acd and bcd are faces, the triangles abc and abd
//   have these between them. Tightening leads the longer one into the two faces, and to the shorter one or on to where
//   the shorter one is led, too. A tube with a section of few edges has many triangles of this kind beside each neck.
// Yet on a coarse level, where curves are tightened and seeds are few, a triangle may lead to another constriction than
// on a finer one, and none is removed.
class Redundant_triangles
{
public:
  // Removes them from those from `first` on, of a level with so many vertices. O(degree) for each.
  void remove(const Progressive_mesh& pm, std::size_t vertices, std::size_t first, std::vector<Seed_curve>& seeds)
  {
    if(vertices < least_vertices)
      return;
    const auto begin = seeds.begin() + static_cast<std::ptrdiff_t>(first);
    auto end = std::remove_if(begin, seeds.end(), [this](const Seed_curve& s) {
      return is_triangle(s) && !m_known.insert(corners(s)).second;
    });
    end = std::remove_if(begin, end, [&](const Seed_curve& s) { return is_triangle(s) && becomes_shorter(pm, s); });
    seeds.erase(end, seeds.end());
  }

private:
  static constexpr std::size_t least_vertices = 1000;
  typedef std::array<Index, 3> Corners;

  static bool is_triangle(const Seed_curve& s)
  {
    return s.origin == Seed_origin::NON_FACE_TRIANGLE && s.vertices.size() == 3;
  }

  static Corners sorted(Corners corners)
  {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  static Corners corners(const Seed_curve& s) { return sorted({{s.vertices[0], s.vertices[1], s.vertices[2]}}); }

  // Whether two faces beside one of its corners, c, lead to a shorter one that is known. Of two of one length the corner
  // decides.
  bool becomes_shorter(const Progressive_mesh& pm, const Seed_curve& s) const
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index c = s.vertices[i], a = s.vertices[(i + 1) % 3], b = s.vertices[(i + 2) % 3];
      const Index edge = pm.halfedge(c, a);
      for(const Index beside : {edge, pm.opposite(edge)})
      {
        const Index d = corner_opposite(pm, beside), cd = pm.halfedge(c, d), dc = pm.opposite(cd);
        if(pm.is_ghost_face(pm.face(cd)) || pm.is_ghost_face(pm.face(dc)) ||
           (corner_opposite(pm, cd) != b && corner_opposite(pm, dc) != b))
          continue;
        if(std::make_pair(length(pm, a, d, b), d) < std::make_pair(length(pm, a, c, b), c) &&
           m_known.count(sorted({{a, b, d}})) != 0)
          return true;
      }
    }
    return false;
  }

  static Index corner_opposite(const Progressive_mesh& pm, Index h) { return pm.target(Progressive_mesh::next(h)); }

  static double length(const Progressive_mesh& pm, Index a, Index b, Index c)
  {
    return norm(vector(pm.point(a), pm.point(b))) + norm(vector(pm.point(b), pm.point(c)));
  }

  std::unordered_set<Corners, boost::hash<Corners>> m_known; // the triangles that have been found
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_REDUNDANT_TRIANGLES_H
