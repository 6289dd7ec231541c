// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_ARRANGE_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_ARRANGE_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/ranks_before.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The parameters that choose which curves cut.
struct Cutting_parameters : Mesh_parameters::With<internal_np::minimum_prominence_t, internal_np::choked_side_t,
                                                  internal_np::maximum_number_of_parts_t>
{};

// The curves that cut, arranged, and for each given curve whether it cuts, and if not, why.
template <class TriangleMesh>
struct Arranged_curves
{
  std::unique_ptr<Curve_arrangement<TriangleMesh>> arrangement;
  std::vector<Cut_outcome> outcomes;
};

// The curves that the named parameters choose, in the order of their ranks, those of the same rank in their order.
template <class TriangleMesh, class NamedParameters>
std::vector<std::size_t> cutting_order(const std::vector<Constriction<TriangleMesh>>& curves, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  std::vector<std::size_t> order;
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    if constexpr(!is_default_parameter<NamedParameters, internal_np::minimum_prominence_t>::value)
      if(!(curves[i].prominence() >= get_parameter(np, internal_np::minimum_prominence)))
        continue;
    if constexpr(!is_default_parameter<NamedParameters, internal_np::choked_side_t>::value)
      if(curves[i].side() != get_parameter(np, internal_np::choked_side))
        continue;
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return ranks_before(curves[i], curves[j]); });
  return order;
}

// Arranges the first `n` curves in this order, without those that cross one before them.
template <class TriangleMesh>
Arranged_curves<TriangleMesh> arrange(const TriangleMesh& tm, const std::vector<Constriction<TriangleMesh>>& curves,
                                      const std::vector<std::size_t>& order, std::size_t n)
{
  Arranged_curves<TriangleMesh> result = {std::make_unique<Curve_arrangement<TriangleMesh>>(tm),
                                          std::vector<Cut_outcome>(curves.size(), {false, Cut_outcome::none})};
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::optional<std::size_t> crossed = result.arrangement->insert(curves[order[i]], order[i]);
    result.outcomes[order[i]] = {!crossed, crossed.value_or(Cut_outcome::none)};
  }
  return result;
}

// Arranges the curves that the named parameters choose, whatever the number of parts.
template <class TriangleMesh, class NamedParameters>
Arranged_curves<TriangleMesh>
arrange_chosen(const TriangleMesh& tm, const std::vector<Constriction<TriangleMesh>>& curves, const NamedParameters& np)
{
  const std::vector<std::size_t> order = cutting_order(curves, np);
  return arrange(tm, curves, order, order.size());
}

// Leaves out the curves that would make more parts than the named parameters allow. `cuts` are those of all curves that
// the parameters choose. Returns whether there are any.
template <class TriangleMesh, class NamedParameters>
bool limit_parts(const TriangleMesh& tm, const std::vector<Constriction<TriangleMesh>>& curves,
                 const std::vector<Nested_cut>& cuts, const NamedParameters& np,
                 Arranged_curves<TriangleMesh>& arranged)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::maximum_number_of_parts_t>::value)
  {
    const std::size_t maximum = get_parameter(np, internal_np::maximum_number_of_parts);
    const auto end =
        std::find_if(cuts.begin(), cuts.end(), [=](const Nested_cut& c) { return c.number_of_parts > maximum; });
    if(end == cuts.end())
      return false;
    const std::vector<std::size_t> order = cutting_order(curves, np);
    std::size_t n = 0; // up to the last one that cuts
    if(end != cuts.begin())
      n = static_cast<std::size_t>(std::find(order.begin(), order.end(), (end - 1)->curve) - order.begin()) + 1;
    arranged = arrange(tm, curves, order, n);
    return true;
  }
  else
    return false;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_ARRANGE_CURVES_H
