// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/mesh_json.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace constrictions {

// Vertices on no face are counted, as they have numbers, but do not belong to the surface that has a genus: that of the
// surface whose holes are filled.
nlohmann::ordered_json mesh_as_json(const std::string& file, const Mesh& mesh, const File_record& record)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<std::size_t> component(mesh.num_faces());
  const std::size_t components = PMP::connected_components(mesh, CGAL::make_property_map(component));
  const std::size_t holes = record.findings.count(Finding::HOLES);
  const std::int64_t euler_characteristic = std::int64_t(mesh.number_of_vertices()) -
                                            std::int64_t(mesh.number_of_edges()) +
                                            std::int64_t(mesh.number_of_faces()) + std::int64_t(holes);
  nlohmann::ordered_json result = {{"file", file},
                                   {"vertices", record.numbering.vertices},
                                   {"faces", record.numbering.faces},
                                   {"triangles", mesh.number_of_faces()},
                                   {"components", components},
                                   {"genus", std::int64_t(components) - euler_characteristic / 2},
                                   {"holes", holes},
                                   {"border_edges", record.findings.count(Finding::BORDER_EDGES)},
                                   {"area", PMP::area(mesh)},
                                   {"repairs", repairs_as_json(record.findings)}};
  if(!record.unit.empty())
    result["unit"] = record.unit;
  return result;
}

nlohmann::ordered_json repairs_as_json(const Mesh_findings& findings)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for(std::size_t i = 0; i < number_of_findings; ++i)
  {
    const Finding finding = static_cast<Finding>(i);
    if(is_repair(finding) && findings.count(finding) > 0)
      result[name_of(finding)] = findings.count(finding);
  }
  return result;
}

const char* side_name(CGAL::Surface_mesh_constrictions::Side side)
{
  using CGAL::Surface_mesh_constrictions::Side;
  return side == Side::OBJECT ? "object" : side == Side::COMPLEMENT ? "complement" : "mixed";
}

const char* origin_name(CGAL::Surface_mesh_constrictions::Seed_origin origin)
{
  using CGAL::Surface_mesh_constrictions::Seed_origin;
  switch(origin)
  {
  case Seed_origin::NON_FACE_TRIANGLE:
    return "non_face_triangle";
  case Seed_origin::CUT_LOCUS:
    return "cut_locus";
  case Seed_origin::SECTION:
    return "section";
  case Seed_origin::BARRIER:
    return "barrier";
  case Seed_origin::BOUNDARY:
    return "boundary";
  case Seed_origin::USER:
    break;
  }
  return "user";
}

} // namespace constrictions
