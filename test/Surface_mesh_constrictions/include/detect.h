// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef DETECT_H
#define DETECT_H

#include "include/sanitizers.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <vector>

namespace detection {

template <class Mesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>>
detect(const Mesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> result;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(result), np);
  return result;
}

// Without a selection.
template <class Mesh>
std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> detect_all(const Mesh& mesh)
{
  return detect(mesh, CGAL::Surface_mesh_constrictions::parameters::all_constrictions(true));
}

// The same, but of larger meshes, of which there are thousands, only what is selected; of all meshes without a selection
// if CONSTRICTIONS_ALL_CURVES is set.
template <class Mesh>
std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> detect_all_in_time(const Mesh& mesh)
{
  const std::size_t most_faces = sanitizers::are_on ? 3000 : 6000;
  return num_faces(mesh) > most_faces && std::getenv("CONSTRICTIONS_ALL_CURVES") == nullptr ? detect(mesh)
                                                                                            : detect_all(mesh);
}

// Without a selection, from non-face triangles only.
template <class Mesh>
std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> detect_all_from_triangles(const Mesh& mesh)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  return detect(mesh, SMC::parameters::all_constrictions(
                          true, SMC::parameters::seed_detection(SMC::Seed_detection::ON_APPEARANCE)));
}

} // namespace detection

#endif // DETECT_H
