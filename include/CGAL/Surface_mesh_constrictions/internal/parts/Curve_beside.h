// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_BESIDE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_BESIDE_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve beside a cycle of edges, on its left: it crosses the edges that leave the cycle there, all at the same
// distance from it: where a curve beside a straight one bends towards that, a cap would cover the surface. The distance
// is the given one, or a third of that of the nearest other end of an edge if that is less. So the curve stays clear of
// curves beside the other side, and beside other cycles. Where an end comes as near as a millionth of the distance the
// curve bends.
//
// Edges within a face of the surface as it was before the cycle was put into it are crossed a little beyond the straight
// line between the crossings before and after. So what is to be cut off there lies on the side of the cycle, and does
// not cover the surface.
template <class TriangleMesh>
class Curve_beside
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point;

public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<typename Constriction<TriangleMesh>::Location> locations;

  // of each location, the halfedge of the cycle to the vertex where its edge begins; none of an edge within a face
  std::vector<std::size_t> origins;

  // is_inner(h) tells whether an edge is within such a face. Linear in the number of crossed edges.
  template <class VertexPointMap, class IsInner>
  Curve_beside(const TriangleMesh& tm, VertexPointMap vpm, const std::vector<halfedge_descriptor>& cycle,
               double distance, const IsInner& is_inner)
  {
    const auto point = [&](vertex_descriptor v) { return nearest_point(get(vpm, v)); };
    for(std::size_t i = 0; i < cycle.size(); ++i)
    {
      const halfedge_descriptor out = cycle[(i + 1) % cycle.size()];
      const Point before = point(source(cycle[i], tm)), here = point(target(cycle[i], tm)),
                  after = point(target(out, tm));
      for(halfedge_descriptor h = next(cycle[i], tm); h != out; h = next(opposite(h, tm), tm))
      {
        // on both sides of a face between two edges of the cycle is the same edge, which joins their other ends
        if(!locations.empty() && locations.back().halfedge == opposite(h, tm))
        {
          locations.pop_back();
          origins.pop_back();
          continue;
        }
        // the distance of the other end, to begin with
        const Point end = point(target(h, tm));
        const double to_end = std::sqrt((std::min)(CGAL::squared_distance(end, Kernel::Segment_3(before, here)),
                                                   CGAL::squared_distance(end, Kernel::Segment_3(here, after))));
        locations.push_back({false, vertex_descriptor(), h, to_end});
        origins.push_back(is_inner(h) ? none : i);
      }
    }
    while(locations.size() > 1 && locations.front().halfedge == opposite(locations.back().halfedge, tm))
    {
      locations.pop_back();
      origins.pop_back();
      locations.erase(locations.begin());
      origins.erase(origins.begin());
    }

    double common_distance = distance;
    for(std::size_t i = 0; i < locations.size(); ++i)
      if(origins[i] != none)
        common_distance = (std::min)(common_distance, locations[i].parameter / 3);
    common_distance = (std::max)(common_distance, 1e-6 * distance);
    for(auto& l : locations)
      l.parameter = common_distance < l.parameter / 3 ? common_distance / l.parameter : 1. / 3;

    const std::size_t n = locations.size();
    if(std::count(origins.begin(), origins.end(), none) + 2 > static_cast<std::ptrdiff_t>(n))
      return;
    const auto crossing = [&](std::size_t i) {
      const Point p = point(source(locations[i].halfedge, tm)), q = point(target(locations[i].halfedge, tm));
      return p + locations[i].parameter * (q - p);
    };
    for(std::size_t i = 0; i < n; ++i)
    {
      if(origins[i] != none)
        continue;
      std::size_t previous = i, following = i;
      while(origins[previous] == none)
        previous = (previous + n - 1) % n;
      while(origins[following] == none)
        following = (following + 1) % n;
      const Point p = crossing(previous);
      const Kernel::Vector_3 along = crossing(following) - p;
      const auto height = [&](vertex_descriptor v) {
        return std::sqrt(cross_product(along, point(v) - p).squared_length());
      };
      const double near = height(source(locations[i].halfedge, tm)), far = height(target(locations[i].halfedge, tm));
      const double t = near + far > 0 ? near / (near + far) : 1. / 3;
      locations[i].parameter = t < 0.4 ? 1.25 * t : t;
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_BESIDE_H
