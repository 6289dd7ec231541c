// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef DISPLACED_CURVES_H
#define DISPLACED_CURVES_H

// A curve displaced by one combinatorial step: still a closed path on the mesh, but not a geodesic any more.

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace displaced_curves {

template <class Mesh>
class Displacements
{
  typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
  typedef typename Constriction::Location Location;
  typedef typename Constriction::vertex_descriptor Vertex;
  typedef typename Constriction::halfedge_descriptor Halfedge;
  typedef std::vector<Location> Locations;

public:
  // Every stride-th pivot is displaced, and every stride-th location if it is a crossing.
  Displacements(const Mesh& mesh, const Constriction& curve, std::size_t stride)
    : m_mesh(mesh), m_curve(curve), m_stride(stride)
  {}

  // Around each side of each pivot, over its edges there, at the given share of their lengths.
  std::vector<Constriction> around_pivots(double share) const
  {
    std::vector<Constriction> result;
    for(const auto& pivot : chosen_pivots())
      for(bool left : {true, false})
      {
        Locations path = crossings_around(pivot.location, left, share);
        const Locations rest = all_but(pivot.location);
        path.insert(path.end(), rest.begin(), rest.end());
        result.push_back(curve_of(path));
      }
    return result;
  }

  // Each pivot moved along each of its edges to the neighbour there, with the crossings in between.
  std::vector<Constriction> through_neighbours() const
  {
    std::vector<Constriction> result;
    for(const auto& pivot : chosen_pivots())
      for(bool left : {true, false})
      {
        const Locations path = crossings_around(pivot.location, left, 0.5);
        for(std::size_t i = 0; i < path.size(); ++i)
        {
          const Halfedge h = path[i].halfedge;
          const Vertex v = pivot.vertex, a = source(h, m_mesh) == v ? target(h, m_mesh) : source(h, m_mesh);
          Locations moved = {vertex(a)};
          moved.insert(moved.end(), path.begin() + static_cast<std::ptrdiff_t>(i) + 1, path.end());
          const Locations rest = all_but(pivot.location);
          moved.insert(moved.end(), rest.begin(), rest.end());
          moved.insert(moved.end(), path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i));
          if(leave_edges_of_first(moved))
            result.push_back(curve_of(moved));
        }
      }
    return result;
  }

  // Each crossing moved by the given share of the way to the further end of its edge.
  std::vector<Constriction> with_moved_crossings(double share) const
  {
    std::vector<Constriction> result;
    for(std::size_t i = 0; i < m_curve.locations().size(); i += m_stride)
    {
      Locations moved = m_curve.locations();
      double& t = moved[i].parameter;
      if(moved[i].is_pivot)
        continue;
      t += share * (t < 0.5 ? 1 - t : -t);
      result.push_back(curve_of(moved));
    }
    return result;
  }

private:
  std::vector<typename Constriction::Pivot> chosen_pivots() const
  {
    std::vector<typename Constriction::Pivot> result;
    for(std::size_t i = 0; i < m_curve.pivots().size(); i += m_stride)
      result.push_back(m_curve.pivots()[i]);
    return result;
  }

  Location vertex(Vertex v) const { return {true, v, Halfedge(), 0}; }

  static Constriction curve_of(const Locations& locations)
  {
    typename Constriction::Data data;
    data.locations = locations;
    return Constriction(std::move(data));
  }

  // The locations after the given one, up to the one before it.
  Locations all_but(std::size_t i) const
  {
    const Locations& l = m_curve.locations();
    Locations result(l.begin() + static_cast<std::ptrdiff_t>(i) + 1, l.end());
    result.insert(result.end(), l.begin(), l.begin() + static_cast<std::ptrdiff_t>(i));
    return result;
  }

  // The edges of a pivot of a geodesic that a curve crosses which passes the pivot on one side.
  Locations crossings_around(std::size_t i, bool left, double share) const
  {
    const Locations& l = m_curve.locations();
    const std::size_t n = l.size();
    const Location &before = l[(i + n - 1) % n], &after = l[(i + 1) % n];
    const Vertex v = l[i].vertex;
    Halfedge h, end; // out of v: the first edge, and the last one or the one after that
    if(before.is_pivot)
      h = turn(halfedge(v, before.vertex, m_mesh).first, left);
    else
    {
      const Halfedge o = opposite(before.halfedge, m_mesh); // in a face with v
      h = left ? prev(o, m_mesh) : opposite(next(o, m_mesh), m_mesh);
    }
    if(after.is_pivot)
      end = halfedge(v, after.vertex, m_mesh).first;
    else
      end = left ? opposite(next(after.halfedge, m_mesh), m_mesh) : prev(after.halfedge, m_mesh);

    Locations result;
    while(!after.is_pivot || h != end)
    {
      // an edge is crossed clockwise from the face of its halfedge out of v, counterclockwise from the opposite one
      result.push_back({false, Vertex(), left ? h : opposite(h, m_mesh), left ? share : 1 - share});
      if(h == end)
        break;
      h = turn(h, left);
    }
    return result;
  }

  // To the next edge out of the same vertex: on the left of a curve, from where it comes, clockwise.
  Halfedge turn(Halfedge h, bool left) const
  {
    return left ? next(opposite(h, m_mesh), m_mesh) : opposite(prev(h, m_mesh), m_mesh);
  }

  // Leaves out crossings of edges of the first location, a vertex, next to it on either side; a curve that came from
  // the vertex itself would be no displacement.
  bool leave_edges_of_first(Locations& l) const
  {
    const auto is_of_first = [&](const Location& x) {
      return !x.is_pivot && (source(x.halfedge, m_mesh) == l[0].vertex || target(x.halfedge, m_mesh) == l[0].vertex);
    };
    while(l.size() > 1 && is_of_first(l.back()))
      l.pop_back();
    while(l.size() > 1 && is_of_first(l[1]))
      l.erase(l.begin() + 1);
    return l.size() > 2 && !(l[1].is_pivot && l[1].vertex == l[0].vertex) &&
           !(l.back().is_pivot && l.back().vertex == l[0].vertex);
  }

  const Mesh& m_mesh;
  const Constriction& m_curve;
  const std::size_t m_stride;
};

} // namespace displaced_curves

#endif // DISPLACED_CURVES_H
