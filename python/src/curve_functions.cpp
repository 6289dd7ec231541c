// SPDX-License-Identifier: GPL-3.0-or-later
#include "detect.h"

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loops_at_location.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <iterator>

namespace constrictions {

namespace SMC = CGAL::Surface_mesh_constrictions;

std::vector<Geodesic_loop> girth(const Mesh& mesh, const Mesh::Point& location, std::size_t maximum_number,
                                 std::optional<double> minimum_angle, bool certify)
{
  std::vector<Geodesic_loop> result;
  const auto np = SMC::parameters::maximum_number_of_loops(maximum_number).certify(certify);
  if(minimum_angle)
    SMC::geodesic_loops_at_location(mesh, location, std::back_inserter(result),
                                    SMC::parameters::minimum_loop_angle(*minimum_angle, np));
  else
    SMC::geodesic_loops_at_location(mesh, location, std::back_inserter(result), np);
  return result;
}

std::vector<Tightened_curve> tighten(const Mesh& mesh, const std::vector<std::vector<Mesh::Vertex_index>>& loops,
                                     bool certify, Monitor& monitor)
{
  std::vector<Tightened_curve> result;
  monitor.begin(SMC::Detection_stage::TIGHTENING, loops.size());
  const auto take = [&](const Tightened_curve& tightened) {
    result.push_back(tightened);
    monitor.step(result.size());
  };
  SMC::tighten_closed_curves(mesh, loops, boost::make_function_output_iterator(take),
                             SMC::parameters::certify(certify));
  return result;
}

SMC::Certificate certify(const Mesh& mesh, const Constriction& curve) { return SMC::certify_constriction(mesh, curve); }

} // namespace constrictions
