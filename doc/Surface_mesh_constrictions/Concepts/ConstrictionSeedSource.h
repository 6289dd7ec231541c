// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshConstrictionsConcepts
/// \cgalConcept
///
/// The concept `ConstrictionSeedSource` describes where seed curves come from: the named parameter `seed_sources` of
/// `CGAL::Surface_mesh_constrictions::detect_constrictions()`.
///
/// A source is called once for each surface <i>T<sup>0</sup></i>, <i>T<sup>1</sup></i>, ..., <i>T<sup>n</sup></i>, from
/// the finest to the coarsest, by one thread. So its work on every level should touch the merged vertex only, and
/// expensive work should be done on one level, chosen by `CGAL::Surface_mesh_constrictions::is_level_with()`. The
/// stages that follow do not depend on where seeds come from. The same surface has to give the same seeds.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Default_seed_sources}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Seed_sources}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Non_face_triangle_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Refused_collapse_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Saddle_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Gauss_bonnet_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Cut_locus_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Local_boundary_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Local_cut_locus_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Section_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Boundary_seeds}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Given_seeds}
/// \cgalHasModelsEnd
class ConstrictionSeedSource
{
public:
  /// writes the seeds of the current surface of `pm`.
  ///
  /// \tparam OutputIterator takes `CGAL::Surface_mesh_constrictions::Seed_curve`
  ///
  /// \param pm the surface, at the level for which the source is called. Its vertices are numbered in the order of
  ///        `vertices(tm)`; its faces may be in another order than in `faces(tm)`.
  /// \param level data of this level
  /// \param out takes closed paths of edges of the current surface, with `level` equal to `pm.level()`; no vertex may
  ///        follow itself, and a path has three vertices at least
  /// \return the output iterator, past the last seed
  template <class OutputIterator>
  OutputIterator operator()(const CGAL::Surface_mesh_constrictions::Progressive_mesh& pm,
                            const CGAL::Surface_mesh_constrictions::Seed_level& level, OutputIterator out) const;
};
