// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/closed_volume.h"
#include "compute/computations.h"
#include "input/find_border.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

// Of the diagonal of the mesh. A height that is less comes of rounding: the last digits of coordinates differ where a
// surface closes. Those of files with floats, or with seven digits, are ten thousand times higher.
const double least_height = 1e-12;

Slivers find_slivers(const Mesh& mesh, const File_numbering& numbering)
{
  Slivers result;
  CGAL::Bbox_3 box;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      box += mesh.point(v).bbox();
  const double least =
      least_height * std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                               CGAL::square(box.zmax() - box.zmin()));
  if(!std::isfinite(least)) // too large to be squared
    return result;
  double worst = std::numeric_limits<double>::infinity(), greatest = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = mesh.point(mesh.target(mesh.next(h)));
    std::array<Mesh::Point::R::Vector_3, 3> edges = {{q - p, r - q, p - r}};
    std::sort(edges.begin(), edges.end(),
              [](const auto& a, const auto& b) { return a.squared_length() < b.squared_length(); });
    const double width = std::sqrt(edges[0].squared_length()), length = std::sqrt(edges[2].squared_length());
    const double height = std::sqrt(CGAL::cross_product(edges[0], edges[2]).squared_length()) / length;
    if(!(height < least) || CGAL::collinear(p, q, r))
      continue;
    ++result.number;
    if(width < least)
    {
      ++result.with_near_corners;
      greatest = (std::max)(greatest, width);
    }
    if(height < worst)
    {
      worst = height;
      const Point middle = CGAL::centroid(p, q, r);
      std::ostringstream words;
      words << "the worst is face " << numbering.face_of(f) << ", around " << middle.x() << ' ' << middle.y() << ' '
            << middle.z() << ", " << height << " high and " << length << " long";
      result.worst = words.str();
    }
  }
  if(greatest > 0)
    result.merging_distance = merging_distance_for(greatest);
  return result;
}

} // namespace

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
  report.slivers = find_slivers(report.mesh, report.file.numbering);
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
