// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PARAMETER_CHAIN_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PARAMETER_CHAIN_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

// The parameters of this package, which CGAL does not have.
#define CGAL_SURFACE_MESH_CONSTRICTIONS_OWN_PARAMETERS(DO)                                                             \
  DO(seed_detection_t, seed_detection)                                                                                 \
  DO(tightening_schedule_t, tightening_schedule)                                                                       \
  DO(seed_sources_t, seed_sources)                                                                                     \
  DO(simplification_policies_t, simplification_policies)                                                               \
  DO(first_constriction_only_t, first_constriction_only)                                                               \
  DO(certify_t, certify)                                                                                               \
  DO(certified_only_t, certified_only)                                                                                 \
  DO(minimum_prominence_t, minimum_prominence)                                                                         \
  DO(minimum_isolation_t, minimum_isolation)                                                                           \
  DO(maximum_isoperimetric_ratio_t, maximum_isoperimetric_ratio)                                                       \
  DO(minimum_curve_length_t, minimum_curve_length)                                                                     \
  DO(maximum_curve_length_t, maximum_curve_length)                                                                     \
  DO(maximum_number_of_constrictions_t, maximum_number_of_constrictions)                                               \
  DO(maximum_number_of_loops_t, maximum_number_of_loops)                                                               \
  DO(minimum_loop_angle_t, minimum_loop_angle)                                                                         \
  DO(crossing_constrictions_t, crossing_constrictions)                                                                 \
  DO(all_constrictions_t, all_constrictions)                                                                           \
  DO(rim_constrictions_t, rim_constrictions)                                                                           \
  DO(measure_prominence_t, measure_prominence)                                                                         \
  DO(prove_prominence_t, prove_prominence)                                                                             \
  DO(maximum_number_of_parts_t, maximum_number_of_parts)                                                               \
  DO(choked_side_t, choked_side)                                                                                       \
  DO(target_genus_t, target_genus)                                                                                     \
  DO(maximum_number_of_handles_t, maximum_number_of_handles)                                                           \
  DO(with_caps_t, with_caps)                                                                                           \
  DO(with_filled_holes_t, with_filled_holes)                                                                           \
  DO(cap_output_iterator_t, cap_output_iterator)

// CGAL's parameters that functions of this package take.
#define CGAL_SURFACE_MESH_CONSTRICTIONS_TAKEN_PARAMETERS(DO)                                                           \
  DO(vertex_point_t, vertex_point_map)                                                                                 \
  DO(vertex_index_t, vertex_index_map)                                                                                 \
  DO(edge_is_constrained_t, edge_is_constrained_map)                                                                   \
  DO(visitor_t, visitor)                                                                                               \
  DO(get_cost_policy_t, get_cost)                                                                                      \
  DO(get_placement_policy_t, get_placement)                                                                            \
  DO(maximum_number_t, maximum_number)

namespace internal_np {

#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(tag, name)                                                           \
  enum tag                                                                                                             \
  {                                                                                                                    \
    name                                                                                                               \
  };
CGAL_SURFACE_MESH_CONSTRICTIONS_OWN_PARAMETERS(CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER)
#undef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER

} // namespace internal_np

namespace Surface_mesh_constrictions {
namespace internal {

// Named parameters of which the outermost is one of this package, or is chained to such a one. CGAL's class has a
// closed list of the names that can be chained to it; this one adds those of this package, and so
//
//   minimum_prominence(0.1).certify(false)
//   minimum_prominence(0.1).vertex_index_map(m).certify(false)
//
// compile: to a parameter of this package all others can be chained in any order. Those of CGAL's that no function of
// this package takes are inherited, and return CGAL's class, to which only CGAL's own can be chained.
//
// A chain that starts with a parameter of CGAL's, `vertex_index_map(m)`, is of CGAL's class, to which
// `.minimum_prominence(0.1)` cannot be chained. CGAL has no hook for that: the members are written by a list inside the
// class. Another list earlier in the search path, a specialization of the class for CGAL's own tags, or an overload of
// `vertex_index_map()` would change what CGAL's names mean in some translation units of a program only, which breaks
// the rule of one definition. Put in front it works: `minimum_prominence(0.1, vertex_index_map(m))`. So does CGAL 6's
// `vertex_index_map(m).combine(minimum_prominence(0.1), certify(false))`, which CGAL 5.5 does not have.
//
// The base is what CGAL makes of the same parameters, so functions that take `Named_function_parameters<T, Tag, Base>`
// take this class too. That of several bases that fit the nearest one is deduced is CWG 2303.
template <class T, class Tag, class Base = internal_np::No_property>
struct Parameter_chain : Named_function_parameters<T, Tag, Base>
{
  using Named_function_parameters<T, Tag, Base>::Named_function_parameters;

#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(tag, name)                                                           \
  template <class Value>                                                                                               \
  Parameter_chain<Value, internal_np::tag, Named_function_parameters<T, Tag, Base>> name(const Value& value) const     \
  {                                                                                                                    \
    return {value, *this};                                                                                             \
  }
  CGAL_SURFACE_MESH_CONSTRICTIONS_OWN_PARAMETERS(CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER)
  CGAL_SURFACE_MESH_CONSTRICTIONS_TAKEN_PARAMETERS(CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER)
#undef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER
};

// Returns `is_known`; unless it is `true` the compiler stops with a sentence that names the parameter.
template <bool is_known, class Parameter>
constexpr bool check_is_known(Parameter)
{
  static_assert(is_known, "the called function does not know a named parameter that is given to it: see 'Parameter'");
  return is_known;
}

#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(tag, name)                                                           \
  template <bool is_known>                                                                                             \
  constexpr bool check_is_known(internal_np::tag)                                                                      \
  {                                                                                                                    \
    static_assert(is_known, "the called function does not know the named parameter '" #name "'");                      \
    return is_known;                                                                                                   \
  }
CGAL_SURFACE_MESH_CONSTRICTIONS_OWN_PARAMETERS(CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER)
CGAL_SURFACE_MESH_CONSTRICTIONS_TAKEN_PARAMETERS(CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER)
#undef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER

} // namespace internal
} // namespace Surface_mesh_constrictions

#undef CGAL_SURFACE_MESH_CONSTRICTIONS_TAKEN_PARAMETERS
#undef CGAL_SURFACE_MESH_CONSTRICTIONS_OWN_PARAMETERS

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PARAMETER_CHAIN_H
