// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_NEAREST_POINT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_NEAREST_POINT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

template <class NT>
double nearest_double(const NT& x)
{
  return CGAL::to_double(x);
}

// to_double() of a lazy number may be the middle of its interval, and that five digits wide.
template <class ET>
double nearest_double(const Lazy_exact_nt<ET>& x)
{
  return CGAL::to_double(x.exact());
}

// The point of doubles nearest to a point of any kernel with Cartesian coordinates.
template <class Point>
Exact_predicates_inexact_constructions_kernel::Point_3 nearest_point(const Point& p)
{
  return {nearest_double(p.x()), nearest_double(p.y()), nearest_double(p.z())};
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_NEAREST_POINT_H
