// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshConstrictionsConcepts
/// \cgalConcept
///
/// The concept `ConstrictionRefinementVisitor` describes a visitor that follows seed curves on their way to the input:
/// the visitor of `CGAL::Surface_mesh_constrictions::refine_seed_curves()` and
/// `CGAL::Surface_mesh_constrictions::carry_seed_curves()`. It is not copied.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Refinement_visitor_base}
/// \cgalHasModelsEnd
class ConstrictionRefinementVisitor
{
public:
  /// called when all curves have reached the given level
  void on_level(std::size_t level);

  /// called when a curve has appeared or changed on a level. `carry_seed_curves()`, which carries paths of edges, does
  /// not call it.
  ///
  /// \tparam Curve a function object
  ///
  /// \param level the level
  /// \param seeds the numbers of the seeds that have led to the curve so far
  /// \param curve `curve()` gives it as a `CGAL::Surface_mesh_constrictions::Closed_curve`, which is empty if it has
  ///        shortened to a point. Linear in the length of its strips.
  template <class Curve>
  void on_curve(std::size_t level, const std::vector<std::size_t>& seeds, const Curve& curve);
};
