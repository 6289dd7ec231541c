// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_SELECTION_PARAMETERS_H
#define CONSTRICTIONS_SELECTION_PARAMETERS_H

#include "options.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <limits>

namespace constrictions {

/// named parameters for a selection, in front of others.
template <class NamedParameters>
auto with_selection(const Selection& selection, const NamedParameters& np)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  namespace params = SMC::parameters;
  return params::all_constrictions(selection.all, np)
      .rim_constrictions(selection.rims)
      .minimum_curve_length(selection.minimum_length.value_or(0))
      .maximum_curve_length(selection.maximum_length.value_or(std::numeric_limits<double>::infinity()))
      .maximum_number_of_constrictions(selection.maximum_number)
      .maximum_isoperimetric_ratio(selection.maximum_ratio.value_or(SMC::default_maximum_isoperimetric_ratio))
      .minimum_isolation(selection.minimum_isolation.value_or(SMC::default_minimum_isolation))
      .minimum_prominence(selection.minimum_prominence.value_or(SMC::default_minimum_prominence));
}

} // namespace constrictions

#endif // CONSTRICTIONS_SELECTION_PARAMETERS_H
