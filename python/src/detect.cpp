// SPDX-License-Identifier: GPL-3.0-or-later
#include "detect.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/tags.h>

#include <iterator>
#include <limits>

namespace constrictions {

Detected detect(const Mesh& mesh, const Search& search, Monitor& monitor)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  typedef CGAL::Parallel_if_available_tag Concurrency;
  Detected result;
  const auto np =
      SMC::parameters::all_constrictions(search.all)
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
          .visitor(Monitoring_visitor(monitor, result.statistics));
  if(search.location)
    SMC::detect_constrictions_near<Concurrency>(mesh, *search.location, std::back_inserter(result.constrictions), np);
  else
    SMC::detect_constrictions<Concurrency>(mesh, std::back_inserter(result.constrictions), np);
  return result;
}

} // namespace constrictions
