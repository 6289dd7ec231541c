// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_SECTION_AT_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_SECTION_AT_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Plane_section.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Face_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Geodesic_loop_maker.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Section_branch.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/given_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A vector along an axis, the same one for both orientations of the axis; its coordinates have absolute values of at
// most 1. Throws Invalid_input for a coordinate that is not a finite number, and for a vector of length 0.
template <class Vector>
Vector3 given_axis(const Vector& axis)
{
  const double x = nearest_double(axis.x()), y = nearest_double(axis.y()), z = nearest_double(axis.z());
  for(double c : {x, y, z})
    if(!std::isfinite(c))
      throw Invalid_input(Input_defect::NON_FINITE_COORDINATE, 0,
                          "non-finite coordinate: the axis has " + std::to_string(c));
  const double greatest = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  if(greatest == 0)
    throw Invalid_input(Input_defect::INVALID_LOCATION, 0, "invalid location: the axis has length 0");
  const double first = x != 0 ? x : y != 0 ? y : z;
  const double divisor = first < 0 ? -greatest : greatest;
  return {x / divisor, y / divisor, z / divisor};
}

// Computes the section of a prepared surface with the plane through a location.
template <class TriangleMesh, class VertexPointMap>
class Section_at_location
{
public:
  // Throws Invalid_input for a location that is not on the mesh. A location that is not a vertex costs a copy of the
  // connectivity and the points.
  template <class Location>
  Section_at_location(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared, const Location& location)
    : m_prepared(prepared), m_at(without_tiny_coordinates(given_location(prepared, location))),
      m_inserted(insert_point(prepared.surface(), m_at)), m_locations(prepared.imported(), prepared.surface())
  {
    if(m_inserted.is_changed)
      m_changed.emplace(std::move(m_inserted.table), std::move(m_inserted.points));
  }

  // Linear in the number of faces that the section crosses, plus the cost of tightening the curve, and of letting it
  // go.
  Plane_section<TriangleMesh> section(const Vector3& axis, bool certifies) const
  {
    Plane_section<TriangleMesh> result;
    std::vector<Section_branch> branches = section_branches(with(), m_inserted.vertex, axis, true);
    if(branches.empty())
      branches = section_branches(with(), m_inserted.vertex, axis, false);
    std::stable_sort(branches.begin(), branches.end(), [](const Section_branch& a, const Section_branch& b) {
      return a.is_closed != b.is_closed ? a.is_closed : a.length < b.length;
    });
    const std::size_t closed = static_cast<std::size_t>(
        std::count_if(branches.begin(), branches.end(), [](const Section_branch& b) { return b.is_closed; }));
    result.number_of_curves = closed + (branches.size() - closed + 1) / 2;
    if(closed > 0)
    {
      result.kind = Section_kind::CLOSED;
      place_vertex(result);
      place(branches.front(), result);
      result.loop = tightened(branches.front(), certifies);
    }
    else if(!branches.empty())
    {
      result.kind = Section_kind::OPEN;
      if(branches.size() > 1)
        place(branches[1], result);
      std::reverse(result.locations.begin(), result.locations.end());
      place_vertex(result);
      place(branches.front(), result);
    }
    return result;
  }

private:
  const Progressive_mesh& with() const { return m_changed ? *m_changed : m_prepared.surface(); }

  void place_vertex(Plane_section<TriangleMesh>& result) const
  {
    result.locations.push_back(m_inserted.is_changed ? m_locations.at(m_at) : m_locations.corner(m_inserted.vertex));
  }

  // Appends the points of a branch, except the vertex where it begins. A branch that passes another vertex may cross
  // several edges at this vertex.
  void place(const Section_branch& branch, Plane_section<TriangleMesh>& result) const
  {
    result.length += m_prepared.imported().unit().restored(branch.length);
    Index last = null_index;
    for(const Trace_point& p : branch.crossings)
    {
      const Index v = p.parameter == 0   ? with().source(p.halfedge)
                      : p.parameter == 1 ? with().target(p.halfedge)
                                         : null_index;
      if(v == null_index)
      {
        const Surface_with_point::Piece piece = m_inserted.piece(p.halfedge);
        result.locations.push_back(
            m_locations.crossing(piece.old, piece.begin + p.parameter * (piece.end - piece.begin)));
      }
      else if(v != last)
        result.locations.push_back(m_locations.corner(v));
      last = v;
    }
  }

  std::optional<Geodesic_loop<TriangleMesh>> tightened(const Section_branch& branch, bool certifies) const
  {
    Strip strip;
    for(const Trace_point& p : branch.crossings)
      strip.push_back(p.halfedge);
    std::vector<Arc> arcs;
    String_puller(with()).pull(m_inserted.vertex, strip, m_inserted.vertex, arcs);
    if(arcs.empty())
      return std::nullopt;
    Held_curves curves(with(), m_inserted.vertex, m_prepared.length_unit());
    curves.insert(std::move(arcs));
    if(curves.ends().empty() || !is_held_loop(with(), curves.ends().front(), 0))
      return std::nullopt;
    Geodesic_loop_maker<TriangleMesh, VertexPointMap> maker(m_prepared, with(), m_inserted, m_at, certifies);
    return maker.make(curves.ends().front());
  }

  const Prepared_surface<TriangleMesh, VertexPointMap>& m_prepared;
  const Surface_location m_at;
  Surface_with_point m_inserted;
  std::optional<Progressive_mesh> m_changed;
  const Face_locations<TriangleMesh> m_locations;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_SECTION_AT_LOCATION_H
