// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/cut_handles.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace constrictions {

bool cut_along_handles(const std::vector<Constriction>& constrictions, const Segmentation& segmentation,
                       std::optional<double> maximum_length, std::size_t round, Handle_removal& removal)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;

  const auto np = SMC::parameters::maximum_number_of_handles(removal.genus() - removal.target_genus)
                      .maximum_curve_length(maximum_length.value_or(std::numeric_limits<double>::infinity()));
  std::vector<Removed_handle> handles;
  if(segmentation.side)
    SMC::cut_handles(removal.mesh, constrictions, std::back_inserter(handles),
                     SMC::parameters::choked_side(*segmentation.side, np));
  else
    SMC::cut_handles(removal.mesh, constrictions, std::back_inserter(handles), np);
  removal.mesh.collect_garbage();
  for(Removed_handle& h : handles)
  {
    h.round = round;
    removal.handles.push_back(std::move(h));
  }
  return !handles.empty();
}

} // namespace constrictions
