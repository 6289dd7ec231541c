// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINTS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A surface with several points put in as vertices, one after the other.
class Surface_with_points
{
public:
  // `pm` is T^0. Linear in the size of the surface for each location that is not a vertex.
  Surface_with_points(const Progressive_mesh& pm, std::vector<Surface_location> locations)
    : m_pm(pm), m_first_inserted(pm.has_boundary() ? static_cast<Index>(pm.points().size() - pm.number_of_holes())
                                                   : static_cast<Index>(pm.points().size()))
  {
    for(std::size_t i = 0; i < locations.size(); ++i)
    {
      Surface_with_point inserted = insert_point(surface(), locations[i]);
      m_vertices.push_back(inserted.vertex);
      if(!inserted.is_changed)
        continue;
      for(std::size_t j = i + 1; j < locations.size(); ++j)
        move(locations[i], inserted, locations[j]);
      m_surface = std::make_unique<Progressive_mesh>(std::move(inserted.table), std::move(inserted.points));
      m_insertions.push_back(std::move(inserted));
    }
  }

  const Progressive_mesh& surface() const { return m_surface ? *m_surface : m_pm; }

  // of the locations, in their order
  const std::vector<Index>& vertices() const { return m_vertices; }

  // whether a vertex, not a ghost, has been put in
  bool is_inserted(Index v) const { return v >= m_first_inserted; }

  // Where a halfedge was before all points were put in. Constant, for each of them.
  Surface_with_point::Piece piece(Index h) const
  {
    Surface_with_point::Piece result = {h, h, 0, 1};
    for(auto i = m_insertions.rbegin(); i != m_insertions.rend() && result.old != null_index; ++i)
    {
      const Surface_with_point::Piece p = i->piece(result.old);
      const double length = p.end - p.begin;
      result = {h, p.old, p.begin + result.begin * length, p.begin + result.end * length};
    }
    return result;
  }

private:
  // Moves a location to the face that it is in after another one has been put in: of those that its face has fallen
  // into the one in which its least coordinate is greatest.
  void move(const Surface_location& at, const Surface_with_point& inserted, Surface_location& location) const
  {
    const Progressive_mesh& before = surface();
    Surface_location best = {null_index, {}};
    double best_least = 0;
    for(std::size_t i = 0; i + 2 < inserted.pieces.size(); i += 3)
    {
      const Index old = inserted.pieces[i + 1].old; // the side of the new face that is opposite to the new vertex
      if(before.face(old) != location.face)
        continue;
      const Index from = old % 3, to = Progressive_mesh::next(old) % 3, third = Progressive_mesh::prev(old) % 3;
      const std::array<double, 3> w = coordinates(before, at, location.face);
      Surface_location moved = {inserted.pieces[i].halfedge / 3, {}};
      const double x = location.barycentric[third] / w[third];
      moved.barycentric = {{x, location.barycentric[from] - x * w[from], location.barycentric[to] - x * w[to]}};
      const double least = *std::min_element(moved.barycentric.begin(), moved.barycentric.end());
      if(best.face == null_index || least > best_least)
      {
        best = moved;
        best_least = least;
      }
    }
    if(best.face != null_index)
      location = without_tiny_coordinates(best);
  }

  // The coordinates of a location in its own face, or in the other one at its edge.
  static std::array<double, 3> coordinates(const Progressive_mesh& pm, const Surface_location& at, Index face)
  {
    if(face == at.face)
      return at.barycentric;
    std::array<double, 3> result = {{0, 0, 0}};
    for(Index h = 3 * face; h < 3 * face + 3; ++h)
      for(Index k = 3 * at.face; k < 3 * at.face + 3; ++k)
        if(pm.source(h) == pm.source(k))
          result[h % 3] = at.barycentric[k % 3];
    return result;
  }

  const Progressive_mesh& m_pm;
  const Index m_first_inserted;
  std::unique_ptr<Progressive_mesh> m_surface;  // if there is a point that is not a vertex
  std::vector<Surface_with_point> m_insertions; // without their surfaces
  std::vector<Index> m_vertices;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINTS_H
