// SPDX-License-Identifier: GPL-3.0-or-later
#include "detect.h"

#include "search_parameters.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/tags.h>

#include <iterator>
#include <memory>
#include <mutex>

namespace constrictions {

Detected detect(const Surface& surface, const Search& search, Monitor& monitor)
{
  std::shared_ptr<const Prepared_mesh> prepared;
  {
    const std::lock_guard<std::mutex> lock(surface.prepared_mutex);
    prepared = surface.prepared;
  }
  if(prepared && prepared->is_for_detection())
    return prepared->detect(search, monitor);
  Detected result;
  CGAL::Surface_mesh_constrictions::detect_constrictions<CGAL::Parallel_if_available_tag>(
      surface.mesh, std::back_inserter(result.constrictions), search_parameters(search, monitor, result.statistics));
  return result;
}

} // namespace constrictions
