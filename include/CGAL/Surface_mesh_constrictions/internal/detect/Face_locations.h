// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_FACE_LOCATIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_FACE_LOCATIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Translates locations on T^0 to the user's mesh: a face, and barycentric coordinates that begin with the source of its
// halfedge. Each is constant, but for the degree of a vertex with a hole.
template <class TriangleMesh>
class Face_locations
{
  typedef typename Constriction<TriangleMesh>::Face_location Face_location;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

public:
  Face_locations(const Imported_mesh<TriangleMesh>& imported, const Progressive_mesh& pm)
    : m_imported(imported), m_pm(pm)
  {}

  // At a vertex, in a face that is not a ghost.
  Face_location corner(Index vertex) const
  {
    Index h = m_pm.outgoing(vertex);
    while(m_pm.is_ghost_face(m_pm.face(h)))
      h = m_pm.ccw(h);
    return location(h, {{1, 0, 0}});
  }

  // A crossing of a halfedge is not at an end of it, so that the halfedge can be told from the numbers.
  Face_location crossing(Index h, double parameter) const
  {
    const double t = (std::min)((std::max)(parameter, (std::numeric_limits<double>::min)()),
                                1 - std::numeric_limits<double>::epsilon() / 2);
    return location(h, {{1 - t, t, 0}});
  }

  Face_location at(const Surface_location& location) const
  {
    return this->location(3 * location.face, location.barycentric);
  }

private:
  // Barycentric coordinates with respect to the source of a halfedge, its target, and the third corner of its face.
  Face_location location(Index h, const std::array<double, 3>& barycentric) const
  {
    const TriangleMesh& tm = m_imported.mesh();
    const halfedge_descriptor given = m_imported.halfedge_of(h);
    Face_location result(face(given, tm), {{0, 0, 0}});
    halfedge_descriptor first = halfedge(result.first, tm), i = given;
    for(std::size_t k = 0; k < 3; ++k, i = next(i, tm))
    {
      halfedge_descriptor j = first;
      for(std::size_t place = 0; place < 3; ++place, j = next(j, tm))
        if(j == i)
          result.second[place] = barycentric[k];
    }
    return result;
  }

  const Imported_mesh<TriangleMesh>& m_imported;
  const Progressive_mesh& m_pm;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_FACE_LOCATIONS_H
