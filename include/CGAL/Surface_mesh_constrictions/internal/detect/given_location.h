// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GIVEN_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GIVEN_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Throws Invalid_input for a number that is not finite.
inline void check_finite(double x, const std::string& name)
{
  if(!std::isfinite(x))
    throw Invalid_input(Input_defect::NON_FINITE_COORDINATE, 0,
                        "non-finite coordinate: the location has " + name + " = " + std::to_string(x));
}

// A point in space in the unit of a prepared surface, no further away than squares of distances allow. Throws
// Invalid_input for a coordinate that is not a finite number.
template <class TriangleMesh, class GivenPoint>
Point given_point(const Imported_mesh<TriangleMesh>& imported, const GivenPoint& point)
{
  std::array<double, 3> p = {{nearest_double(point.x()), nearest_double(point.y()), nearest_double(point.z())}};
  for(std::size_t i = 0; i < 3; ++i)
  {
    check_finite(p[i], std::string(1, "xyz"[i]));
    p[i] = (std::min)((std::max)(imported.unit().divided(p[i]), -1e150), 1e150);
  }
  return Point(p[0], p[1], p[2]);
}

// A location of the user as one of a prepared surface: a vertex, a location in a face, or the location nearest to a
// point in space. Throws Invalid_input for one that is not on the mesh. Linear for a location in a face.
template <class TriangleMesh, class VertexPointMap, class Location>
Surface_location given_location(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                const Location& location)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const Imported_mesh<TriangleMesh>& imported = prepared.imported();
  const Progressive_mesh& pm = prepared.surface();
  if constexpr(std::is_convertible_v<Location, typename Graph_traits::vertex_descriptor>)
  {
    const Index v = prepared.number_of(location);
    if(v == null_index || pm.outgoing(v) == null_index)
      throw Invalid_input(Input_defect::INVALID_LOCATION, 0,
                          "invalid location: the vertex is isolated, or not one of the mesh");
    Index h = pm.outgoing(v);
    while(pm.is_ghost_face(pm.face(h)))
      h = pm.ccw(h);
    Surface_location result = {pm.face(h), {{0, 0, 0}}};
    result.barycentric[h % 3] = 1;
    return result;
  }
  else if constexpr(std::is_convertible_v<Location, typename Constriction<TriangleMesh>::Face_location>)
  {
    const typename Constriction<TriangleMesh>::Face_location& given = location;
    double sum = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      check_finite(given.second[i], "barycentric coordinate " + std::to_string(i));
      sum += given.second[i];
    }
    for(double b : given.second)
      if(b < -least_barycentric || std::abs(sum - 1) > least_barycentric)
        throw Invalid_input(Input_defect::INVALID_LOCATION, 0,
                            "invalid location: its barycentric coordinates are negative or do not add up to 1");
    for(Index f = 0; f < imported.number_of_faces(); ++f)
    {
      if(face(imported.halfedge_of(3 * f), imported.mesh()) != given.first)
        continue;
      // the coordinates of the user begin with the source of the face's halfedge
      Index i = 0;
      while(imported.halfedge_of(3 * f + i) != halfedge(given.first, imported.mesh()))
        ++i;
      Surface_location result = {f, {{0, 0, 0}}};
      for(Index k = 0; k < 3; ++k)
        result.barycentric[(i + k) % 3] = given.second[k];
      return result;
    }
    throw Invalid_input(Input_defect::INVALID_LOCATION, 0, "invalid location: its face is not one of the mesh");
  }
  else
    return prepared.locator().nearest_location(given_point(imported, location));
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GIVEN_LOCATION_H
