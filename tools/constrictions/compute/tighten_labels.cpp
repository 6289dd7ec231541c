// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_label_borders.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <vector>

namespace constrictions {

void tighten_labels(const std::vector<Label>& labels, bool certifies, Stage_monitor& monitor, Report& report)
{
  using namespace CGAL::Surface_mesh_constrictions;

  monitor.begin(Detection_stage::TIGHTENING, 1);
  Labelling& labelling = report.labelling.emplace();
  std::vector<Label> of_triangles;
  for(Mesh::Face_index f : report.mesh.faces())
    of_triangles.push_back(labels[report.file.numbering.face_of(f)]);
  labelling.old_labels = of_triangles;
  labelling.labels.resize(of_triangles.size());
  labelling.tightened =
      tighten_label_borders(report.mesh, CGAL::make_property_map(of_triangles),
                            CGAL::make_property_map(labelling.labels), parameters::certify(certifies));
  report.statistics.seeds = labelling.tightened.borders.size();
  for(const Label_border& border : labelling.tightened.borders)
  {
    report.statistics.signs = report.statistics.signs + border.certificate.signs;
    labelling.constriction.push_back(Labelling::none);
    switch(border.outcome)
    {
    case Label_border_outcome::CLOSED_GEODESIC:
      labelling.constriction.back() = report.constrictions.size();
      report.constrictions.push_back(border.curve);
      break;
    case Label_border_outcome::DEGENERATE:
      ++report.statistics.degenerate;
      break;
    case Label_border_outcome::NOT_SIMPLE:
      ++report.statistics.not_simple;
      break;
    case Label_border_outcome::NOT_CERTIFIED:
      ++report.statistics.not_certified;
      break;
    case Label_border_outcome::GEODESIC_ARC:
    case Label_border_outcome::CROSSING:
      break;
    }
  }
  monitor.step(1);
  monitor.end(Detection_stage::TIGHTENING);
}

} // namespace constrictions
