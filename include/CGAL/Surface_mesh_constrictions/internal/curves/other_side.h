// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_OTHER_SIDE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_OTHER_SIDE_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

inline Curve_side other_side(Curve_side side)
{
  return side == Curve_side::LEFT ? Curve_side::RIGHT : Curve_side::LEFT;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_OTHER_SIDE_H
