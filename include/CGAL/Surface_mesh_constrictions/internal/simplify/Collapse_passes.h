// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_COLLAPSE_PASSES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_COLLAPSE_PASSES_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Plane_quadric.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Simplifies a surface with border by passes of collapses. A pass ranks the edges by their costs, those of Garland and
// Heckbert, with a little of the distances to the places of its vertices, and collapses the cheapest ones in this
// order. Where an end of an edge has moved in the same pass, its cost is not known, and the edge waits for the next
// pass. So there is no queue, and all data is in flat arrays. An edge is collapsed only if both ends are inside the
// surface, if the surface stays a 2-manifold without two edges between the same vertices (the link condition), and if
// no face turns over.
//
// Edges of the same cost are in the order of their halfedges, so the result is always the same.
class Collapse_passes
{
public:
  typedef Progressive_mesh::Point Point;

  // Costs have the squared distance to where the vertices were, too, with this weight. In flat regions the planes cost
  // nothing wherever a vertex goes; there this keeps the vertices evenly spread. Elsewhere it is too little to matter.
  static constexpr double weight_of_place = 1e-5;

  // The first `inside` vertices are not at the border. The table, the points and the record are written to, but not the
  // halfedges out of vertices at the border; `names` are those of the vertices in the record. Linear.
  Collapse_passes(Corner_table& table, std::vector<Point>& points, std::size_t inside, const std::vector<Index>& names,
                  bool with_refused_seeds, Collapse_record& record)
    : m_table(table), m_points(points), m_inside(inside), m_names(names), m_with_refused_seeds(with_refused_seeds),
      m_record(record), m_quadrics(inside), m_moved(inside, 0), m_seen(points.size(), 0),
      m_costs(table.halfedges.size())
  {
    for(Index f = 0; f < table.halfedges.size() / 3; ++f)
    {
      m_faces.push_back(f);
      const Point& p = points[source(3 * f)];
      Vector normal = CGAL::cross_product(points[source(3 * f + 1)] - p, points[source(3 * f + 2)] - p);
      const double length = std::sqrt(normal.squared_length());
      if(length > 0)
        normal = normal / length;
      const Plane_quadric quadric(normal.x(), normal.y(), normal.z(), -(normal * (p - CGAL::ORIGIN)));
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(is_inside(source(h)))
          m_quadrics[source(h)] += quadric;
    }
    for(Index v = 0; v < inside; ++v)
    {
      m_quadrics[v] += weight_of_place * Plane_quadric(1, 0, 0, -points[v].x());
      m_quadrics[v] += weight_of_place * Plane_quadric(0, 1, 0, -points[v].y());
      m_quadrics[v] += weight_of_place * Plane_quadric(0, 0, 1, -points[v].z());
    }
  }

  // Makes so many collapses, or fewer if no more may be made. A pass is linear, but for sorting and for the degrees of
  // what it collapses.
  void run(std::size_t collapses)
  {
    const std::size_t last = m_record.collapses.size() + collapses;
    bool goes_on = true;
    for(Index pass = 1; goes_on && m_record.collapses.size() < last; ++pass)
    {
      rank(pass);
      goes_on = !m_ranked.empty();
      for(std::size_t i = 0; i < m_ranked.size() && m_record.collapses.size() < last; ++i)
      {
        const Index h = static_cast<Index>(m_ranked[i]);
        if(!has_moved(h, pass) && !collapse(h, pass))
          m_costs[h] = refused;
      }
    }
  }

  // Whether a collapse has taken a face out of the surface. Its first halfedge is its own opposite then.
  static bool is_out(const Corner_table& table, Index f) { return table.halfedges[3 * f].opposite == 3 * f; }

private:
  typedef Exact_predicates_inexact_constructions_kernel::Vector_3 Vector;
  typedef std::uint32_t Cost; // the upper half of the bits of a double that is not negative: in the same order

  // of an edge that may not be collapsed before one of its ends moves
  static constexpr Cost refused = std::numeric_limits<Cost>::max();

  // the share of the edges that a pass looks at
  static constexpr double share = 0.25;

  Index source(Index h) const { return m_table.halfedges[h].source; }
  Index target(Index h) const { return source(Corner_table::next(h)); }
  Index opposite(Index h) const { return m_table.halfedges[h].opposite; }
  Index ccw(Index h) const { return opposite(Corner_table::prev(h)); }

  bool is_inside(Index v) const { return v < m_inside; }
  bool has_moved(Index h, Index pass) const { return m_moved[source(h)] == pass || m_moved[target(h)] == pass; }

  static Homogeneous homogeneous(const Point& p) { return {{p.x(), p.y(), p.z(), 1}}; }

  Plane_quadric quadric_of_edge(Index h) const
  {
    Plane_quadric result = m_quadrics[source(h)];
    return result += m_quadrics[target(h)];
  }

  // The point that an edge with this quadric collapses to.
  Homogeneous best_point(const Plane_quadric& quadric, Index h) const
  {
    const Homogeneous p = quadric.best_point(homogeneous(m_points[source(h)]), homogeneous(m_points[target(h)]));
    return {{p[0] / p[3], p[1] / p[3], p[2] / p[3], 1}};
  }

  Cost cost(Index h) const
  {
    const Plane_quadric quadric = quadric_of_edge(h);
    const Homogeneous p = best_point(quadric, h);
    const double value = quadric(p, p);
    if(!(value > 0)) // as rounding makes some
      return 0;
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return static_cast<Cost>(bits >> 32);
  }

  // Writes the cheapest edges in the order of their costs, which are computed anew where a vertex has moved.
  void rank(Index pass)
  {
    m_faces.erase(std::remove_if(m_faces.begin(), m_faces.end(), [this](Index f) { return is_out(m_table, f); }),
                  m_faces.end());
    m_ranked.clear();
    for(Index f : m_faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        if(h > opposite(h) || !is_inside(source(h)) || !is_inside(target(h)))
          continue;
        if(pass == 1 || has_moved(h, pass - 1))
          m_costs[h] = cost(h);
        if(m_costs[h] != refused)
          m_ranked.push_back(static_cast<std::uint64_t>(m_costs[h]) << 32 | h);
      }
    const auto end = std::next(m_ranked.begin(),
                               static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(m_ranked.size()))));
    std::nth_element(m_ranked.begin(), end, m_ranked.end());
    m_ranked.erase(end, m_ranked.end());
    std::sort(m_ranked.begin(), m_ranked.end());
  }

  // Collapses the edge of a halfedge; returns whether that may be done.
  bool collapse(Index h, Index pass)
  {
    const Index o = opposite(h);
    ++m_mark;
    const std::size_t degree_of_source = for_each_neighbour(h, [this](Index v) { m_seen[v] = m_mark; });
    std::size_t common = 0;
    const std::size_t degree_of_target =
        for_each_neighbour(o, [this, &common](Index v) { common += m_seen[v] == m_mark; });
    if(common > 2)
    {
      if(m_with_refused_seeds)
        note_seeds(h);
      return false;
    }
    if(degree_of_source + degree_of_target == 6) // of a tetrahedron
      return false;
    const Plane_quadric quadric = quadric_of_edge(h);
    const Homogeneous best = best_point(quadric, h);
    const Point p(best[0], best[1], best[2]);
    if(turns_a_face(h, p) || turns_a_face(o, p))
      return false;
    const Index left = degree_of_source <= degree_of_target ? h : o;
    const Index removed = source(left), kept = target(left);
    merge(left);
    m_points[kept] = p;
    m_quadrics[kept] = quadric;
    m_moved[removed] = m_moved[kept] = pass;
    m_record.collapses.push_back(Edge_collapse{m_names[removed], m_names[kept], p});
    return true;
  }

  // Calls f(v) for each neighbour v of the source of a halfedge, and returns how many there are.
  template <class Function>
  std::size_t for_each_neighbour(Index begin, const Function& f) const
  {
    std::size_t degree = 0;
    Index h = begin;
    do
    {
      f(target(h));
      ++degree;
      h = ccw(h);
    } while(h != begin);
    return degree;
  }

  // Whether a face around the source of a halfedge turns over or becomes flat when that vertex moves to p. The two faces
  // at the halfedge go.
  bool turns_a_face(Index begin, const Point& p) const
  {
    const Point& from = m_points[source(begin)];
    Index h = ccw(begin);
    for(Index k = ccw(h); k != begin; k = ccw(k)) // the face between h and k
    {
      const Point &a = m_points[target(h)], &b = m_points[target(k)];
      const Vector before = CGAL::cross_product(a - from, b - from), after = CGAL::cross_product(a - p, b - p);
      const bool was_flat = before == CGAL::NULL_VECTOR;
      if(was_flat ? after == CGAL::NULL_VECTOR : !(before * after > 0))
        return true;
      h = k;
    }
    return false;
  }

  // Merges the source of a halfedge into its target, as Progressive_mesh::collapse() does.
  void merge(Index left)
  {
    const Index kept = target(left), right = opposite(left);
    const Index a = opposite(Corner_table::next(left)), b = opposite(Corner_table::prev(left));
    const Index c = opposite(Corner_table::next(right)), d = opposite(Corner_table::prev(right));
    for(Index r = b; r != Corner_table::next(right); r = ccw(r))
      m_table.halfedges[r].source = kept;
    m_table.outgoing[kept] = b;
    glue(a, b);
    glue(c, d);
    for(Index f : {left / 3, right / 3})
      m_table.halfedges[3 * f].opposite = 3 * f;
  }

  void glue(Index h, Index o)
  {
    m_table.halfedges[h].opposite = o;
    m_table.halfedges[o].opposite = h;
  }

  // Writes the non-face triangles of an edge into the record, each once.
  void note_seeds(Index h)
  {
    const Index o = opposite(h), left = target(ccw(h)), right = target(ccw(o));
    for_each_neighbour(o, [&](Index v) {
      if(m_seen[v] != m_mark || v == left || v == right)
        return;
      std::array<Index, 3> triangle = {m_names[source(h)], m_names[source(o)], m_names[v]};
      std::sort(triangle.begin(), triangle.end());
      if(m_known.insert(triangle).second)
        m_record.refused_seeds.push_back(Seed_curve{m_record.collapses.size(),
                                                    std::vector<Index>(triangle.begin(), triangle.end()),
                                                    Seed_origin::NON_FACE_TRIANGLE});
    });
  }

  Corner_table& m_table;
  std::vector<Point>& m_points;
  const std::size_t m_inside;
  const std::vector<Index>& m_names;
  const bool m_with_refused_seeds;
  Collapse_record& m_record;
  std::vector<Plane_quadric> m_quadrics;
  std::vector<Index> m_moved; // by vertex, the last pass in which it has moved or has been merged
  std::vector<Index> m_seen;  // by vertex, the last mark
  Index m_mark = 0;
  std::vector<Cost> m_costs;           // by halfedge, the smaller one of an edge
  std::vector<Index> m_faces;          // that are left
  std::vector<std::uint64_t> m_ranked; // costs and halfedges
  std::set<std::array<Index, 3>> m_known;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_COLLAPSE_PASSES_H
