// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CLOSED_VOLUME_H
#define CONSTRICTIONS_CLOSED_VOLUME_H

#include "input/mesh_file.h"

#include <CGAL/determinant.h>

namespace constrictions {

/// What a closed triangle mesh encloses; negative if it is inside out. It is measured from one of the vertices: seen
/// from the origin, with a small body far away, the tetrahedra over the faces cancel out, and rounding errors are left.
inline double closed_volume(const Mesh& mesh)
{
  double six_times = 0;
  if(mesh.number_of_faces() == 0)
    return six_times;
  const auto& apex = mesh.point(mesh.target(mesh.halfedge(*mesh.faces().begin())));
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    six_times += CGAL::determinant(mesh.point(mesh.source(h)) - apex, mesh.point(mesh.target(h)) - apex,
                                   mesh.point(mesh.target(mesh.next(h))) - apex);
  }
  return six_times / 6;
}

} // namespace constrictions

#endif // CONSTRICTIONS_CLOSED_VOLUME_H
