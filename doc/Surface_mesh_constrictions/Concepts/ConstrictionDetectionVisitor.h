// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshConstrictionsConcepts
/// \cgalConcept
///
/// The concept `ConstrictionDetectionVisitor` describes a visitor that follows the progress of
/// `CGAL::Surface_mesh_constrictions::detect_constrictions()`.
///
/// The visitor is copied, so it should hold pointers to the data that it changes. With `Parallel_tag` different threads
/// call it, but one at a time. A visitor cancels the detection by an exception, which reaches the caller of
/// `detect_constrictions()`: \ref Surface_mesh_constrictions/follow_progress.cpp.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Detection_visitor_base}
/// \cgalHasModelsEnd
class ConstrictionDetectionVisitor
{
public:
  /// called when a stage begins that takes `steps` steps at most: edge collapses, levels, curves, or parts of
  /// curves. With several simplification policies the first three stages are repeated.
  void on_stage_begin(CGAL::Surface_mesh_constrictions::Detection_stage stage, std::size_t steps) const;

  /// called when `done` steps of the stage under way are done; `done` grows, and may skip
  void on_step(CGAL::Surface_mesh_constrictions::Detection_stage stage, std::size_t done) const;

  /// called when a stage ends
  void on_stage_end(CGAL::Surface_mesh_constrictions::Detection_stage stage) const;

  /// called once, before the first curve is written to the output
  void on_end(const CGAL::Surface_mesh_constrictions::Detection_statistics& statistics) const;
};
