// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshConstrictionsConcepts
/// \cgalConcept
///
/// The concept `ConstrictionSimplificationPolicies` describes how the surface is simplified: the named parameter
/// `simplification_policies` of `CGAL::Surface_mesh_constrictions::detect_constrictions()`.
///
/// Several meshes may be simplified with the same policies. So they must not store data of a mesh in themselves, but in
/// the object that they return.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Garland_heckbert_policies}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Lindstrom_turk_policies}
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Edge_length_policies}
/// \cgalHasModelsEnd
class ConstrictionSimplificationPolicies
{
public:
  /// A type with the members `get_cost()` and `get_placement()`, as
  /// `CGAL::Surface_mesh_constrictions::Cost_and_placement` and CGAL's `GarlandHeckbert_plane_policies` have them. They
  /// return models of CGAL's `GetCost` and `GetPlacement`, for edge profiles of
  /// `CGAL::Surface_mesh_constrictions::Simplification_mesh`.
  typedef unspecified_type Policies;

  /// returns the policies for a mesh that is about to be simplified; what is returned lives as long as its
  /// simplification.
  Policies operator()(CGAL::Surface_mesh_constrictions::Simplification_mesh& mesh) const;
};
