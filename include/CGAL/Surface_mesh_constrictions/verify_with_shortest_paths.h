// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_VERIFY_WITH_SHORTEST_PATHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_VERIFY_WITH_SHORTEST_PATHS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Shortest_path_verification.h>
#include <CGAL/Surface_mesh_constrictions/internal/Arc_verifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_nodes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

inline void add_verdict(const Arc_verdict& verdict, std::size_t location, Shortest_path_verification& result)
{
  ++result.number_of_arcs;
  result.greatest_excess = (std::max)(result.greatest_excess, verdict.excess);
  result.greatest_deviation = (std::max)(result.greatest_deviation, verdict.deviation);
  if(verdict.refusal == Arc_refusal::NONE)
    return;
  if(++result.number_of_refused_arcs == 1)
  {
    result.refusal = verdict.refusal;
    result.refused_location = location;
  }
}

} // namespace internal

// DOC
template <class Kernel = Exact_predicates_inexact_constructions_kernel, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Shortest_path_verification verify_with_shortest_paths(
    const TriangleMesh& tm, const Constriction<TriangleMesh>& curve,
    const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  const std::size_t faces = (std::max)(std::size_t(2), static_cast<std::size_t>(choose_parameter(
                                get_parameter(np, internal_np::maximum_number), 16)));

  typedef internal::Curve_nodes<TriangleMesh> Nodes;
  const Nodes nodes(tm, curve.locations(), internal::verification_tolerance);
  const std::size_t n = nodes.size();
  Shortest_path_verification result;
  for(std::size_t i = 0; i < n; ++i)
    if(n == 1 || !nodes.is_connected(i))
    {
      internal::add_verdict({Arc_refusal::NOT_A_PATH, 0, 0}, nodes[i].location, result);
      return result;
    }

  const internal::Arc_verifier<Kernel, TriangleMesh, decltype(vpm)> verifier(tm, vpm, nodes);
  std::size_t start = 0;
  while(start < n && !nodes[start].is_vertex)
    ++start;
  if(start == n)
    start = 0;
  // Consecutive arcs overlap, so that every crossing and every vertex is inside an arc, and not only an end of one.
  for(std::size_t first = start; first < start + n;)
  {
    if(nodes[first].is_vertex)
      internal::add_verdict(verifier.verify_in_star(first), nodes[first].location, result);
    std::size_t last = first + 1;
    while(last < first + faces && !nodes[last].is_vertex)
      ++last;
    if(last > first + 1)
      internal::add_verdict(verifier.verify_in_strip(first, last), nodes[first + 1].location, result);
    first = nodes[last].is_vertex ? last : last - 1;
  }
  return result;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_VERIFY_WITH_SHORTEST_PATHS_H
