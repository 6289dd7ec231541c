// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_FIND_ON_MESH_H
#define CONSTRICTIONS_FIND_ON_MESH_H

#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace constrictions {

/// A point of a closed curve, in space.
struct Curve_point
{
  Point place;
  bool is_pivot; ///< whether the curve passes through a vertex there, and not over an edge
};

/// Where the points of a curve are on a mesh.
struct Found_curve
{
  std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>::Location> locations;
  std::optional<std::size_t> lost; ///< a point that is on no edge, or at no vertex; then there are no locations
};

/// finds the vertices and edges on which the points of closed curves are, within a tolerance. Where there are several
/// those are taken that make each point share a face with the next one and are nearest, if there are such. The crossed
/// halfedges have no particular direction. Linear in the size of the mesh, but for edges longer than the average.
std::vector<Found_curve> find_on_mesh(const Mesh& mesh, const std::vector<std::vector<Curve_point>>& curves,
                                      double tolerance);

} // namespace constrictions

#endif // CONSTRICTIONS_FIND_ON_MESH_H
