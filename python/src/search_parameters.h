// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_SEARCH_PARAMETERS_H
#define CONSTRICTIONS_PYTHON_SEARCH_PARAMETERS_H

#include "detect.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <cstddef>
#include <limits>

namespace constrictions {

/// the named parameters of a search, and of a visitor that tells a monitor of it and takes its statistics
inline auto search_parameters(const Search& search, Monitor& monitor,
                              CGAL::Surface_mesh_constrictions::Detection_statistics& statistics)
{
  return CGAL::Surface_mesh_constrictions::parameters::all_constrictions(search.all)
      .rim_constrictions(search.rims)
      .crossing_constrictions(search.crossing)
      .minimum_curve_length(search.minimum_length)
      .maximum_curve_length(search.maximum_length)
      .maximum_number_of_constrictions(search.maximum_number.value_or((std::numeric_limits<std::size_t>::max)()))
      .maximum_isoperimetric_ratio(search.maximum_ratio)
      .minimum_isolation(search.minimum_isolation)
      .minimum_prominence(search.minimum_prominence)
      .certify(search.certify)
      .certified_only(search.certified_only)
      .visitor(Monitoring_visitor(monitor, statistics));
}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_SEARCH_PARAMETERS_H
