// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GIVEN_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GIVEN_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
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

// A location of the user's as one of the mesh that was taken over: a vertex, a location in a face, or of a point in
// space the nearest one. Throws Invalid_input for one that is not on the mesh. Linear.
template <class TriangleMesh, class VertexIndexMap, class Location>
Surface_location given_location(const Imported_mesh<TriangleMesh>& imported, VertexIndexMap vim,
                                const Location& location)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const Index faces = static_cast<Index>(imported.number_of_faces());
  if constexpr(std::is_convertible_v<Location, typename Graph_traits::vertex_descriptor>)
  {
    const typename Graph_traits::vertex_descriptor given = location;
    for(Index v = 0; v < imported.number_of_vertices() && given != Graph_traits::null_vertex(); ++v)
    {
      const Index h = imported.table.outgoing[v];
      if(h == null_index || get(vim, imported.vertex(v)) != get(vim, given))
        continue;
      Surface_location result = {h / 3, {{0, 0, 0}}};
      result.barycentric[h % 3] = 1;
      return result;
    }
    throw Invalid_input(Input_defect::INVALID_LOCATION, 0,
                        "invalid location: it is a vertex that is isolated or not one of the mesh");
  }
  else if constexpr(std::is_convertible_v<Location, typename Constriction<TriangleMesh>::Face_location>)
  {
    double sum = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      check_finite(location.second[i], "barycentric coordinate " + std::to_string(i));
      sum += location.second[i];
    }
    for(double b : location.second)
      if(b < -least_barycentric || std::abs(sum - 1) > least_barycentric)
        throw Invalid_input(Input_defect::INVALID_LOCATION, 0,
                            "invalid location: its barycentric coordinates are negative or do not add up to 1");
    for(Index f = 0; f < faces; ++f)
      for(Index i = 0; i < 3; ++i)
      {
        // the coordinates of the user begin with the source of the face's halfedge
        const auto h = imported.halfedge_of(3 * f + i);
        if(face(h, imported.mesh()) != location.first || h != halfedge(location.first, imported.mesh()))
          continue;
        Surface_location result = {f, {{0, 0, 0}}};
        for(Index k = 0; k < 3; ++k)
          result.barycentric[(i + k) % 3] = location.second[k];
        return result;
      }
    throw Invalid_input(Input_defect::INVALID_LOCATION, 0, "invalid location: its face is not one of the mesh");
  }
  else
  {
    std::array<double, 3> p = {
        {nearest_double(location.x()), nearest_double(location.y()), nearest_double(location.z())}};
    for(std::size_t i = 0; i < 3; ++i)
    {
      check_finite(p[i], std::string(1, "xyz"[i]));
      p[i] = (std::min)((std::max)(imported.unit().divided(p[i]), -1e150), 1e150);
    }
    return nearest_location(imported.table, imported.points, Point(p[0], p[1], p[2]));
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GIVEN_LOCATION_H
