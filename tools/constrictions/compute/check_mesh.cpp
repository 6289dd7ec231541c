// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/closed_volume.h"
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

Check_report check_mesh(const std::string& name, const Reading& reading)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  namespace PMP = CGAL::Polygon_mesh_processing;

  Check_report report;
  report.mesh_file = name;
  try
  {
    report.mesh = read_mesh_file(name, reading, report.file);
    // what every computation begins with
    SMC::internal::Imported_mesh<Mesh>(report.mesh, get(CGAL::vertex_point, report.mesh),
                                       get(boost::vertex_index, report.mesh));
  }
  catch(const SMC::Invalid_input& e)
  {
    report.refusal = with_hint(e, report.file).what();
  }
  if(report.mesh.number_of_faces() == 0)
    return report;

  for(Mesh::Face_index f : report.mesh.faces())
  {
    const Mesh::Halfedge_index h = report.mesh.halfedge(f);
    report.flat_triangles +=
        CGAL::collinear(report.mesh.point(report.mesh.source(h)), report.mesh.point(report.mesh.target(h)),
                        report.mesh.point(report.mesh.target(report.mesh.next(h))));
  }
  report.is_inside_out = report.file.findings.count(Finding::HOLES) == 0 && closed_volume(report.mesh) < 0;
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections<CGAL::Sequential_tag>(faces(report.mesh), report.mesh, std::back_inserter(pairs));
  report.self_intersections = pairs.size();
  for(std::size_t i = 0; i < pairs.size() && i < Mesh_findings::shown_places; ++i)
    report.first_intersections.push_back("faces " + std::to_string(report.file.numbering.face_of(pairs[i].first)) +
                                         " and " + std::to_string(report.file.numbering.face_of(pairs[i].second)));
  return report;
}

} // namespace constrictions
