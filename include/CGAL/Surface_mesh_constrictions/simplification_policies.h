// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_POLICIES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_POLICIES_H

#include <CGAL/Surface_mesh_constrictions/internal/simplify/Plane_quadric_policies.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A cost and a placement of edge collapses, which a model of `ConstrictionSimplificationPolicies` may return.
///
/// \tparam Cost a model of `GetCost`
/// \tparam Placement a model of `GetPlacement`
template <class Cost, class Placement>
class Cost_and_placement
{
public:
  /// stores copies of both
  Cost_and_placement(const Cost& cost, const Placement& placement) : m_cost(cost), m_placement(placement) {}

  /// the cost
  const Cost& get_cost() const { return m_cost; }
  /// the placement
  const Placement& get_placement() const { return m_placement; }

private:
  Cost m_cost;
  Placement m_placement;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The default simplification policies, as in the paper: the costs and placements are those of CGAL's
/// `GarlandHeckbert_plane_policies`, computed in less time. The fine levels of a mesh of more than 65,536 faces are made
/// with these costs, but not by `edge_collapse()`.
///
/// \cgalModels{ConstrictionSimplificationPolicies}
struct Garland_heckbert_policies
{
  /// the policies for a mesh, also one of a user's own, whose points have double coordinates
  template <class TriangleMesh>
  auto operator()(TriangleMesh& mesh) const
  {
    return internal::Plane_quadric_policies<TriangleMesh>(mesh);
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Simplification policies: CGAL's `LindstromTurk_cost` and `LindstromTurk_placement`.
///
/// \cgalModels{ConstrictionSimplificationPolicies}
struct Lindstrom_turk_policies
{
  /// the policies for a mesh, also one of a user's own
  template <class TriangleMesh>
  auto operator()(TriangleMesh&) const
  {
    namespace SMS = Surface_mesh_simplification;
    return Cost_and_placement<SMS::LindstromTurk_cost<TriangleMesh>, SMS::LindstromTurk_placement<TriangleMesh>>({},
                                                                                                                 {});
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Simplification policies: CGAL's `Edge_length_cost` and `Midpoint_placement`, the shortest edge first.
///
/// \cgalModels{ConstrictionSimplificationPolicies}
struct Edge_length_policies
{
  /// the policies for a mesh, also one of a user's own
  template <class TriangleMesh>
  auto operator()(TriangleMesh&) const
  {
    namespace SMS = Surface_mesh_simplification;
    return Cost_and_placement<SMS::Edge_length_cost<TriangleMesh>, SMS::Midpoint_placement<TriangleMesh>>({}, {});
  }
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_POLICIES_H
