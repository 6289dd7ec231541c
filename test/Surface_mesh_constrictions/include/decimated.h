// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef DECIMATED_H
#define DECIMATED_H

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace decimated {

// CGAL's stop predicates have changed their names.
struct Stops_at_edges
{
  template <class FT, class Profile>
  bool operator()(const FT&, const Profile&, std::size_t, std::size_t number) const
  {
    return number <= edges;
  }

  std::size_t edges;
};

// The closed mesh with no more than the given number of faces, if the simplification gets so far. The policies are
// given, as the default differs between versions of CGAL.
template <class Mesh>
Mesh decimated(Mesh mesh, std::size_t faces)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  if(num_faces(mesh) > faces)
    SMS::edge_collapse(mesh, Stops_at_edges{faces * 3 / 2},
                       CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                           .get_placement(SMS::LindstromTurk_placement<Mesh>()));
  mesh.collect_garbage();
  return mesh;
}

} // namespace decimated

#endif // DECIMATED_H
