// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_POLICIES_ASKED_FOR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_POLICIES_ASKED_FOR_H

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/Named_function_parameters.h>

#include <tuple>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Several policies as they are, and a single one, in a tuple.
template <class... T>
std::tuple<T...> as_tuple(const std::tuple<T...>& t)
{
  return t;
}

template <class T>
std::tuple<T> as_tuple(const T& t)
{
  return std::tuple<T>(t);
}

// The simplification policies that the named parameters ask for, in a tuple.
template <class NamedParameters>
auto policies_asked_for(const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  constexpr bool has_cost = !is_default_parameter<NamedParameters, internal_np::get_cost_policy_t>::value;
  constexpr bool has_placement = !is_default_parameter<NamedParameters, internal_np::get_placement_policy_t>::value;
  constexpr bool has_policies = !is_default_parameter<NamedParameters, internal_np::simplification_policies_t>::value;
  static_assert(has_cost == has_placement, "get_cost and get_placement have to be given together");
  static_assert(!has_cost || !has_policies, "give get_cost and get_placement, or simplification_policies");
  if constexpr(has_policies)
    return as_tuple(get_parameter(np, internal_np::simplification_policies));
  else if constexpr(has_cost)
    return as_tuple([cost = get_parameter(np, internal_np::get_cost_policy),
                     placement = get_parameter(np, internal_np::get_placement_policy)](Simplification_mesh&) {
      return Cost_and_placement<decltype(cost), decltype(placement)>(cost, placement);
    });
  else
    return as_tuple(Garland_heckbert_policies());
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_POLICIES_ASKED_FOR_H
