// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/mesh_json.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace constrictions {

// Vertices on no face are counted, as they have numbers, but do not belong to the surface that has a genus: that of the
// surface with its holes filled.
nlohmann::ordered_json mesh_as_json(const std::string& file, const Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<std::size_t> component(mesh.num_faces());
  const std::size_t components = PMP::connected_components(mesh, CGAL::make_property_map(component));
  const std::int64_t euler_characteristic = std::int64_t(mesh.number_of_vertices()) -
                                            std::int64_t(mesh.number_of_edges()) + std::int64_t(mesh.number_of_faces());
  std::int64_t holes = 0;
  std::vector<bool> is_seen(mesh.num_halfedges(), false);
  for(Mesh::Halfedge_index border : mesh.halfedges())
    if(mesh.is_border(border) && !is_seen[border])
    {
      ++holes;
      for(Mesh::Halfedge_index h : mesh.halfedges_around_face(border))
        is_seen[h] = true;
    }
  return {{"file", file},
          {"vertices", mesh.num_vertices()},
          {"faces", mesh.number_of_faces()},
          {"components", components},
          {"genus", std::int64_t(components) - (euler_characteristic + holes) / 2},
          {"holes", holes},
          {"area", PMP::area(mesh)}};
}

const char* side_name(CGAL::Surface_mesh_constrictions::Side side)
{
  using CGAL::Surface_mesh_constrictions::Side;
  return side == Side::OBJECT ? "object" : side == Side::COMPLEMENT ? "complement" : "mixed";
}

} // namespace constrictions
