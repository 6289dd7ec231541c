// SPDX-License-Identifier: GPL-3.0-or-later
#include "detect.h"

#include "search_parameters.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/tags.h>

#include <iterator>

namespace constrictions {

Detected detect(const Mesh& mesh, const Search& search, Monitor& monitor)
{
  Detected result;
  CGAL::Surface_mesh_constrictions::detect_constrictions<CGAL::Parallel_if_available_tag>(
      mesh, std::back_inserter(result.constrictions), search_parameters(search, monitor, result.statistics));
  return result;
}

} // namespace constrictions
