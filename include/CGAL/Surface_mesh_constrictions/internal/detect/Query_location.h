// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_QUERY_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_QUERY_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Distances from a point in space to a mesh and to curves on it, in the unit of the mesh's coordinates. No square
// overflows or vanishes.
template <class TriangleMesh, class VertexPointMap>
class Query_location
{
  typedef Simple_cartesian<double>::Point_3 Point;

public:
  // Throws Invalid_input for a point with a coordinate that is no finite number. Linear in the number of vertices.
  template <class GivenPoint>
  Query_location(const TriangleMesh& tm, VertexPointMap vpm, const GivenPoint& point) : m_tm(tm), m_vpm(vpm)
  {
    const Point p = to_point(point);
    double greatest = 0;
    for(int i = 0; i < 3; ++i)
    {
      if(!std::isfinite(p[i]))
        throw Invalid_input(Input_defect::NON_FINITE_COORDINATE, 0,
                            std::string("non-finite coordinate: the location has ") + "xyz"[i] + " = " +
                                std::to_string(p[i]));
      greatest = (std::max)(greatest, std::abs(p[i]));
    }
    for(auto v : vertices(tm))
    {
      const Point q = to_point(get(vpm, v));
      for(int i = 0; i < 3; ++i)
        if(std::isfinite(q[i]))
          greatest = (std::max)(greatest, std::abs(q[i]));
    }
    m_unit = Coordinate_unit(greatest);
    m_point = m_unit.divided(p);
  }

  // The number, in the order of vertices(tm), of the vertex that is nearest to the point and not isolated. Linear.
  Index nearest_vertex() const
  {
    Index nearest = 0, number = 0;
    double least = (std::numeric_limits<double>::infinity)();
    for(auto v : vertices(m_tm))
    {
      const double d = squared_distance(m_point, m_unit.divided(to_point(get(m_vpm, v))));
      if(d < least && halfedge(v, m_tm) != boost::graph_traits<TriangleMesh>::null_halfedge())
      {
        least = d;
        nearest = number;
      }
      ++number;
    }
    return nearest;
  }

  // Linear in the number of locations.
  double distance(const Constriction<TriangleMesh>& curve) const
  {
    std::vector<typename boost::property_traits<VertexPointMap>::value_type> points;
    curve.points(m_tm, m_vpm, std::back_inserter(points));
    double least = (std::numeric_limits<double>::infinity)();
    Point p = m_unit.divided(to_point(points.back()));
    for(const auto& point : points)
    {
      const Point q = m_unit.divided(to_point(point));
      least = (std::min)(least, squared_distance_to_segment(p, q));
      p = q;
    }
    return m_unit.restored(std::sqrt(least));
  }

private:
  template <class GivenPoint>
  static Point to_point(const GivenPoint& p)
  {
    return Point(nearest_double(p.x()), nearest_double(p.y()), nearest_double(p.z()));
  }

  double squared_distance_to_segment(const Point& p, const Point& q) const
  {
    const auto along = q - p, offset = m_point - p;
    const double squared_length = along * along;
    const double t = squared_length > 0 ? (std::min)((std::max)(along * offset / squared_length, 0.0), 1.0) : 0;
    return (offset - t * along).squared_length();
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  Coordinate_unit m_unit;
  Point m_point;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_QUERY_LOCATION_H
