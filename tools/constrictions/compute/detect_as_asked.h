// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_DETECT_AS_ASKED_H
#define CONSTRICTIONS_DETECT_AS_ASKED_H

#include "compute/chosen_seed_sources.h"
#include "compute/levels.h"
#include "compute/selection_parameters.h"
#include "options.h"
#include "output/report.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/tags.h>

#include <iterator>
#include <vector>

namespace constrictions {

/// the constrictions of the whole mesh, or those near the location that the user gave. `np` holds the policies of the
/// simplification and the visitor. If `levels` is not null, and the whole mesh is searched, it gets the
/// simplified surface with all its levels.
template <class NamedParameters>
std::vector<Constriction> detect_as_asked(const Mesh& mesh, const Selection& selection, const Search& search,
                                          Levels* levels, const NamedParameters& np)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;

  typedef CGAL::Parallel_if_available_tag Concurrency;
  std::vector<Constriction> result;
  const auto selected = SMC::parameters::prove_prominence(search.proves_prominence, with_selection(selection, np));
  if(search.location)
  {
    const Mesh::Point location((*search.location)[0], (*search.location)[1], (*search.location)[2]);
    SMC::detect_constrictions_near<Concurrency>(mesh, location, std::back_inserter(result),
                                                SMC::parameters::certify(search.certifies, selected));
  }
  else
  {
    const auto measured = SMC::parameters::measure_prominence(search.measures_prominence, selected);
    SMC::detect_constrictions<Concurrency>(
        mesh, std::back_inserter(result),
        SMC::parameters::certify(search.certifies, with_seed_sources(search.triangles_only, levels, measured)));
  }
  return result;
}

} // namespace constrictions

#endif // CONSTRICTIONS_DETECT_AS_ASKED_H
