// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_VERIFY_WITH_SHORTEST_PATHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_VERIFY_WITH_SHORTEST_PATHS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Shortest_path_verification.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/internal/verify/Arc_verifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/verify/Curve_nodes.h>

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

namespace internal {

struct Verification_parameters : Point_parameters::With<internal_np::maximum_number_t>
{};

// What `verify_with_shortest_paths()` does with arguments of the right kind.
template <class Kernel, class TriangleMesh, class NamedParameters>
Shortest_path_verification verify_with_shortest_paths_checked(const TriangleMesh& tm,
                                                              const Constriction<TriangleMesh>& curve,
                                                              const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// asks `CGAL::Surface_mesh_shortest_path` whether a curve is a closed geodesic: whether each of its short arcs is the
/// shortest path between the ends of the arc, in the faces around it.
///
/// This is a witness that is independent of the rest of the package. It uses the vertices, crossed halfedges and
/// parameters of `locations()`, and none of the code that computed them. Arcs are of two kinds:
///
/// - *at a vertex* that the curve passes through: from the last point before it to the first point after it on the link
///   of the vertex, in the star of the vertex; on the boundary of the mesh that is a fan of faces;
/// - *between two vertices*: in the strip of the faces that the arc crosses; a face that it crosses twice is in the
///   strip twice. A strip of more than `maximum_number` faces is cut into pieces.
///
/// Points of the curve other than vertices and crossings are inside a face or an edge, where it is straight by
/// definition. Every vertex and every crossing is inside an arc, and the patch of the arc contains a neighbourhood of
/// it: pieces of one strip overlap. So if all arcs are shortest paths, the curve is a geodesic all along.
///
/// *Why a geodesic arc must be the shortest path in these patches.* A strip is a disc without interior vertices: it is
/// flat. The only interior vertex of a star is the one that the curve passes through, and where both side angles are
/// \f$\pi\f$ or more its total angle is \f$2\pi\f$ or more. Either patch is simply connected and nowhere positively
/// curved; there geodesics are unique and shortest. In a larger patch that need not be so: behind a cone tip there can
/// be a shorter way. Conversely, where a side angle is less than \f$\pi\f$ the way around that side of the vertex is
/// shorter, and the star contains it. A fan at the boundary is a disc without interior vertices, and the way around the
/// hole is not in it.
///
/// An arc is confirmed if it is not longer than CGAL's distance \f$d\f$, up to \f$10^{-9} d\f$, and if CGAL's path
/// crosses the same edges in the same order, nowhere further from the arc than \f$10^{-9}\f$ of the patch's size, which
/// is a power of two between its diameter and twice its diameter. The second condition is the sharper one: a turn by an
/// angle \f$\epsilon\f$ moves a path by \f$O(\epsilon)\f$, but changes its length by \f$O(\epsilon^2)\f$ only. A
/// crossing nearer to a vertex than \f$10^{-9}\f$ of its edge is taken to pass through the vertex; so a curve that
/// passes so close to a vertex of total angle less than \f$2\pi\f$ is refused.
///
/// *What is not checked:* whether the curve is simple, whether a flat band leaks, and whether `length()` is right.
///
/// *What each kernel shows.* Patches are moved to the origin and scaled to a diameter of at most 1, because CGAL
/// compares with an absolute tolerance. The ends of arcs are vertices of the patch.
///
/// - `Exact_predicates_inexact_constructions_kernel`: distances have the rounding of doubles. Larger errors of CGAL are
///   known on patches that are not scaled and have flat interior vertices; they make distances too large, so they can
///   hide a shorter way.
/// - `Exact_predicates_exact_constructions_kernel`: proves no more, and takes about 50 times as long. CGAL takes square
///   roots in double precision for it, too, and errs on patches with many flat interior vertices; here there is at most
///   one.
/// - `Exact_predicates_exact_constructions_kernel_with_sqrt`: CGAL's distances and paths are exact for the patch, whose
///   points on edges are those of the rounded parameters. Use it with `maximum_number(2)` or 3: strips of four faces
///   can take minutes. Stars of six faces take up to a second; if two ways are equally long the search may not end.
///
/// \tparam Kernel a model of the %CGAL kernel concept; the patches have its points
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param curve a closed curve on it
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///     \cgalParamExtra{Coordinates that are not doubles are rounded to doubles.}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the greatest number of faces of a piece of a strip, at least 2}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`16`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the verdict on the curve, or the first refused arc and why
/// \cost one search of CGAL's in a patch for every vertex that the curve passes through, and one for every
/// `maximum_number` - 1 crossings between two of them
///
/// \sa `CGAL::Surface_mesh_shortest_path`
template <class Kernel = Exact_predicates_inexact_constructions_kernel, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Shortest_path_verification verify_with_shortest_paths(const TriangleMesh& tm, const Constriction<TriangleMesh>& curve,
                                                      const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_parameters<internal::Verification_parameters, NamedParameters>())
    return internal::verify_with_shortest_paths_checked<Kernel>(tm, curve, np);
  else
    return internal::no_result<Shortest_path_verification>();
}

namespace internal {

template <class Kernel, class TriangleMesh, class NamedParameters>
Shortest_path_verification verify_with_shortest_paths_checked(const TriangleMesh& tm,
                                                              const Constriction<TriangleMesh>& curve,
                                                              const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const std::size_t maximum_number =
      static_cast<std::size_t>(choose_parameter(get_parameter(np, internal_np::maximum_number), std::size_t(16)));

  typedef internal::Curve_nodes<TriangleMesh> Nodes;
  const Nodes nodes(tm, curve.locations(), internal::verification_tolerance);
  const std::size_t n = nodes.size();
  Shortest_path_verification result;
  for(std::size_t i = 0; i < n || n < 2; ++i)
    if(n < 2 || !nodes.is_connected(i))
    {
      result.refusal = Arc_refusal::NOT_A_PATH;
      result.refused_location = n == 0 ? 0 : nodes[i].location;
      return result;
    }

  const internal::Arc_verifier<Kernel, TriangleMesh, decltype(vpm)> verifier(tm, vpm, nodes);
  std::size_t start = 0;
  while(start < n && !nodes[start].is_vertex)
    ++start;
  if(start == n)
    start = 0;
  // n + 1 faces are enough for a curve without vertices to pass all of its crossings inside one arc
  const std::size_t faces = (std::min)((std::max)(maximum_number, std::size_t(2)), n + 1);
  // Consecutive arcs overlap, so that every crossing and every vertex is inside an arc, and not only the end of one.
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

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_VERIFY_WITH_SHORTEST_PATHS_H
