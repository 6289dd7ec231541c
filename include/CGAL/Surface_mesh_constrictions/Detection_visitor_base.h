// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_DETECTION_VISITOR_BASE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_DETECTION_VISITOR_BASE_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// How the seed curves ended. Every seed is counted in exactly one of `degenerate`, `discarded`, `not_simple`,
/// `not_certified`, `merged` and `not_selected`, or is the first seed of a returned curve.
struct Detection_statistics
{
  std::size_t collapses = 0;     ///< edge collapses of the simplification
  std::size_t seeds = 0;         ///< seed curves of the sources
  std::size_t barriers = 0;      ///< further seeds: curves that constrictions become behind their lowest barriers
  std::size_t degenerate = 0;    ///< seeds that shortened to a point
  std::size_t discarded = 0;     ///< seeds given up on a coarse level, as they lead to curves that are not selected
  std::size_t not_simple = 0;    ///< seeds that ended in a curve that crosses or touches itself
  std::size_t merged = 0;        ///< seeds that ended in a curve that another seed had found
  std::size_t not_selected = 0;  ///< distinct closed geodesics that were found and are not returned
  std::size_t leaky_bands = 0;   ///< times a curve slipped out of a flat band that leaks, and went on shortening
  std::size_t not_certified = 0; ///< seeds that ended in a curve that was left out because it is not certified
  std::size_t corrected = 0;     ///< curves that rounding had led astray, and that exact arithmetic corrected
  Sign_statistics signs;         ///< how the signs were decided on which the certificates rest
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The stages of `detect_constrictions()`, in order. With several simplification policies the first three are repeated.
enum class Detection_stage
{
  SIMPLIFICATION, ///< edge collapses
  SEEDS,          ///< the search for seed curves on each level
  REFINEMENT,     ///< vertex splits, with early merging
  TIGHTENING,     ///< of the curves that have arrived on the input
  CERTIFICATION,  ///< of the distinct closed geodesics that may be selected
  SELECTION       ///< prominences, and selection by them
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Visitor of `detect_constrictions()` whose callbacks do nothing: derive from it and hide what you need.
///
/// \cgalModels{ConstrictionDetectionVisitor}
struct Detection_visitor_base
{
  /// called when a stage begins that takes `steps` steps at most: edge collapses, levels, curves, or
  /// parts of curves
  void on_stage_begin(Detection_stage /* stage */, std::size_t /* steps */) const {}

  /// called when `done` steps of the stage under way are done; `done` grows, and may skip
  void on_step(Detection_stage /* stage */, std::size_t /* done */) const {}

  /// called when a stage ends
  void on_stage_end(Detection_stage /* stage */) const {}

  /// called once, before the first curve is written to the output
  void on_end(const Detection_statistics& /* statistics */) const {}
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_DETECTION_VISITOR_BASE_H
