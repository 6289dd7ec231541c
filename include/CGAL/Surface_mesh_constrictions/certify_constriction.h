// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CERTIFY_CONSTRICTION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CERTIFY_CONSTRICTION_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/exact_arcs_of_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

// What `certify_constriction()` does with arguments of the right kind.
template <class TriangleMesh, class NamedParameters>
Certificate certify_constriction_checked(const TriangleMesh& tm, const Constriction<TriangleMesh>& curve,
                                         const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// decides with exact arithmetic whether a closed curve is a constriction.
///
/// The contract:
///
/// 1. *The curve.* Only the combinatorial curve is examined: the pivots and the crossed halfedges of
///    `curve.locations()`. The rounded parameters of the crossings, and everything else that `curve` holds, are not
///    read.
/// 2. *The surface.* The points of the mesh are taken as the exact numbers that they are. Only the faces that the curve
///    crosses, those around its pivots and those of its flat bands are read; the rest of the mesh is not checked.
/// 3. *The conditions.* They are decided in this order, and together they suffice (Proposition 9 of the paper, and the
///    section "Proofs" of the user manual):
///    - consecutive locations fit together, else `NOT_A_CLOSED_CURVE`;
///    - each arc between two pivots is straight in its unfolded strip, and crosses the inside of each edge, else
///      `NOT_STRAIGHT`;
///    - both side angles at each pivot are at least pi, else `ANGLE_BELOW_PI`;
///    - the curve neither crosses nor touches itself, else `CROSSES_ITSELF` or `TOUCHES_ITSELF`;
///    - if all angles on one side are equal to pi, the flat band on that side holds at its end, else `LEAKY_BAND`.
/// 4. *The verdict.* If all conditions hold it is `STRICT_CONSTRICTION`, where each side has an angle greater than pi,
///    or else `CONSTRICTION`. If not, it is the first condition that is violated, with the place.
/// 5. *No tolerance.* Each sign is proved. A sign that cannot be proved ends the examination with `TIE_NOT_PROVED`;
///    nothing is said about the conditions after it. The section "Certificate" of the user manual tells how signs are
///    decided, and when this can happen.
/// 6. *Boundary.* At a vertex on the boundary of the mesh the angle on the side of the hole is infinite. A flat band
///    that ends at the boundary holds there.
/// 7. *No pivots.* A curve without pivots is examined through the parallel copy of it that passes through vertices on
///    its right. If there is no such copy the curve is `NOT_STRAIGHT`. For such a curve the certificate names no place.
/// 8. *Repeatable.* Neither `tm` nor `curve` is changed, and the same input gives the same certificate. The rounding
///    mode of the caller may be any; it is the same after the call.
/// 9. *Floating-point arithmetic.* First of all it is tried whether in this thread intervals of doubles are what they
///    should be. If not, nothing is decided, and the verdict is `NO_DIRECTED_ROUNDING` or `SUBNORMALS_FLUSHED`.
///
/// \tparam TriangleMesh a model of `HalfedgeGraph` with totally ordered descriptors
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param curve a closed curve on it
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point with rational coordinates:
///                    of double, or of an exact kernel}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the verdict, with the place of the first condition that is violated
/// \throws Invalid_input if a coordinate is not a rational number of moderate size, or if the curve comes to a face
///         that is not a triangle
/// \cost If intervals of doubles decide all signs: linear up to a logarithm in the number of crossings and in the
///       degrees of the pivots, plus the squared number of pieces of the curve in each face, plus the faces of a flat
///       band times the parallel copies in it that meet vertices. A sign that intervals leave open costs, for an arc
///       with k crossings, O(k) operations at each higher precision. A tie in a strip on a prism or a bore costs O(k)
///       operations on integers, and at most as many tests for a square as there are pairs of planes. Any other tie
///       costs operations in a field of up to 2^m dimensions, where m is the number of square classes of the squared
///       areas of the faces concerned.
///
/// \sa `detect_constrictions()`
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Certificate certify_constriction(const TriangleMesh& tm, const Constriction<TriangleMesh>& curve,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_parameters<internal::Point_parameters, NamedParameters>())
    return internal::certify_constriction_checked(tm, curve, np);
  else
    return internal::no_result<Certificate>();
}

namespace internal {

template <class TriangleMesh, class NamedParameters>
Certificate certify_constriction_checked(const TriangleMesh& tm, const Constriction<TriangleMesh>& curve,
                                         const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  typedef internal::Graph_surface<TriangleMesh, std::decay_t<decltype(vpm)>> Surface;

  const Surface surface(tm, vpm);
  internal::Certifier<Surface> certifier(surface);
  Certificate result;
  result.verdict = certifier.floating_point_defect();
  if(result.verdict != Certificate_verdict::NOT_COMPUTED)
    return result;
  const auto located = internal::exact_arcs_of_locations(certifier.prover(), curve.locations());
  if(located.verdict == Certificate_verdict::NOT_COMPUTED)
    return certifier.examine(located.arcs).certificate;
  result.verdict = located.verdict;
  result.location = located.location;
  result.signs = certifier.prover().statistics();
  return result;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CERTIFY_CONSTRICTION_H
