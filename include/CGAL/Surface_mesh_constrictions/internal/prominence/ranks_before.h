// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RANKS_BEFORE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RANKS_BEFORE_H

#include <cmath>
#include <utility>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The order of the results: by prominence times roundness, so that necks come before curves that hold as firmly but lie
// aslant around several limbs; then by prominence. Curves without a prominence come last.
template <class Constriction>
bool ranks_before(const Constriction& c, const Constriction& d)
{
  const auto rank = [](const Constriction& x) {
    const double prominence = std::isnan(x.prominence()) ? -1 : x.prominence();
    return std::make_pair(prominence < 0 ? prominence : prominence * x.roundness(), prominence);
  };
  return rank(c) > rank(d);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RANKS_BEFORE_H
