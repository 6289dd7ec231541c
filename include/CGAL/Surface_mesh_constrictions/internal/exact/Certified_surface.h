// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CERTIFIED_SURFACE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CERTIFIED_SURFACE_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Graph_connectivity.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Surfaces for the exact arithmetic: connectivity, and the points as exact numbers. There are two models.

typedef std::array<Interval_nt<false>, 3> Interval_point;
typedef std::array<Rational, 3> Rational_point;

// Called while rounding is upward. Number types other than the built-in ones rely on rounding to the nearest, so this
// mode is restored while they compute.
template <class Point>
Interval_point interval_point(const Point& p)
{
  typedef std::decay_t<decltype(p.x())> Coordinate;
  if constexpr(!std::is_arithmetic<Coordinate>::value)
  {
    Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    return {{Interval_nt<false>(CGAL::to_interval(p.x())), Interval_nt<false>(CGAL::to_interval(p.y())),
             Interval_nt<false>(CGAL::to_interval(p.z()))}};
  }
  return {{Interval_nt<false>(CGAL::to_interval(p.x())), Interval_nt<false>(CGAL::to_interval(p.y())),
           Interval_nt<false>(CGAL::to_interval(p.z()))}};
}

// Throws Invalid_input if a coordinate is not known to be rational.
template <class Point>
Rational_point rational_point(const Point& p)
{
  const auto exact = [](const auto& x) {
    const auto result = exact_rational(x);
    if(!result)
      throw Invalid_input(Input_defect::IRRATIONAL_COORDINATE, 0,
                          "irrational coordinate: no proof for points with a coordinate near " +
                              std::to_string(CGAL::to_double(x)) + " that is not a rational number of moderate size");
    return *result;
  };
  return {{exact(p.x()), exact(p.y()), exact(p.z())}};
}

// A triangle mesh as it is.
template <class TriangleMesh, class VertexPointMap>
class Graph_surface : public Graph_connectivity<TriangleMesh>
{
  typedef Graph_connectivity<TriangleMesh> Base;

public:
  typedef typename Base::Vertex Vertex;
  typedef typename Base::Halfedge Halfedge;

  Graph_surface(const TriangleMesh& tm, VertexPointMap vpm) : Base(tm), m_vpm(vpm) {}

  // Throws Invalid_input if h is neither in a triangle nor in a hole. Every computation with a face calls this
  // function.
  Halfedge prev(Halfedge h) const
  {
    if(!this->is_ghost(h) && !this->is_triangle(h))
      throw Invalid_input(Input_defect::NOT_TRIANGULAR, 0,
                          "not a triangle mesh: a face at the edge " + place(h) + " does not have three vertices");
    return Base::prev(h);
  }

  Interval_point interval_point(Vertex v) const { return internal::interval_point(get(m_vpm, v)); }
  Rational_point rational_point(Vertex v) const { return internal::rational_point(get(m_vpm, v)); }

private:
  std::string place(Halfedge h) const
  {
    std::ostringstream out;
    out << "from (" << get(m_vpm, this->source(h)) << ") to (" << get(m_vpm, this->target(h)) << ")";
    return out.str();
  }

  VertexPointMap m_vpm;
};

// T^0 of a progressive mesh, with the points of the triangle mesh that was imported.
template <class TriangleMesh, class VertexPointMap>
class Imported_surface
{
public:
  typedef Index Vertex;
  typedef Index Halfedge;

  Imported_surface(const Progressive_mesh& pm, const Imported_mesh<TriangleMesh>& imported, VertexPointMap vpm)
    : m_pm(pm), m_imported(imported), m_vpm(vpm)
  {}

  Index next(Index h) const { return m_pm.next(h); }
  Index prev(Index h) const { return m_pm.prev(h); }
  Index opposite(Index h) const { return m_pm.opposite(h); }
  Index source(Index h) const { return m_pm.source(h); }
  Index target(Index h) const { return m_pm.target(h); }
  Index outgoing(Index v) const { return m_pm.outgoing(v); }
  bool is_ghost(Index h) const { return m_pm.is_ghost_face(m_pm.face(h)); }

  Interval_point interval_point(Index v) const { return internal::interval_point(get(m_vpm, m_imported.vertex(v))); }
  Rational_point rational_point(Index v) const { return internal::rational_point(get(m_vpm, m_imported.vertex(v))); }

private:
  const Progressive_mesh& m_pm;
  const Imported_mesh<TriangleMesh>& m_imported;
  VertexPointMap m_vpm;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CERTIFIED_SURFACE_H
