// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SPREAD_PARAMETERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SPREAD_PARAMETERS_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The least distance of crossings from each other and from the ends of their edge, as a share of its length. Parameters
// are known to some 2^-50.
constexpr double least_distance_of_crossings = 1.0 / (1ll << 50);

// Moves parameters as little as is needed for them to grow by `distance` or more, and to keep that far from 0 and 1.
// Linear.
inline void spread(std::vector<double>& parameters, double distance)
{
  const std::size_t n = parameters.size();
  double bound = distance;
  for(double& t : parameters)
  {
    t = (std::max)(t, bound);
    bound = t + distance;
  }
  bound = 1 - distance;
  for(std::size_t i = n; i-- > 0 && parameters[i] > bound;)
  {
    parameters[i] = bound;
    bound -= distance;
  }
}

// The parameters of the crossings of an edge, along its halfedge, growing.
template <class TriangleMesh>
std::vector<double> spread_parameters(const Curve_arrangement<TriangleMesh>& arrangement, std::size_t edge,
                                      double distance = least_distance_of_crossings)
{
  std::vector<double> result;
  for(std::size_t c : arrangement.edges()[edge].crossings)
    result.push_back(arrangement.parameter(c));
  spread(result, distance);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SPREAD_PARAMETERS_H
