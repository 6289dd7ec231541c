// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_POLICIES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_POLICIES_H

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A cost and a placement of edge collapses.
template <class Cost, class Placement>
class Cost_and_placement
{
public:
  Cost_and_placement(const Cost& cost, const Placement& placement) : m_cost(cost), m_placement(placement) {}

  const Cost& get_cost() const { return m_cost; }
  const Placement& get_placement() const { return m_placement; }

private:
  Cost m_cost;
  Placement m_placement;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Simplification policies.
///
/// Simplification policies are a copyable type that is called with the mesh to be simplified, a `Simplification_mesh`,
/// before the simplification, and returns an object that has the members `get_cost()` and `get_placement()` and is alive
/// as long as the simplification. The cost is of a class that can be derived from. Of a large mesh parts are simplified on
/// their own first, and with `Parallel_tag` several at a time: then the policies are called for each part. Passed to the named parameter `simplification_policies`, one or several in a
/// `std::tuple`.
///
/// `Garland_heckbert_policies` are CGAL's `GarlandHeckbert_plane_policies`, as in the paper.
struct Garland_heckbert_policies
{
  auto operator()(Simplification_mesh& mesh) const
  {
    return Surface_mesh_simplification::GarlandHeckbert_plane_policies<Simplification_mesh,
                                                                       Exact_predicates_inexact_constructions_kernel>(mesh);
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Simplification policies: CGAL's `LindstromTurk_cost` and `LindstromTurk_placement`.
struct Lindstrom_turk_policies
{
  auto operator()(Simplification_mesh&) const
  {
    namespace SMS = Surface_mesh_simplification;
    return Cost_and_placement<SMS::LindstromTurk_cost<Simplification_mesh>,
                              SMS::LindstromTurk_placement<Simplification_mesh> >({}, {});
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Simplification policies: CGAL's `Edge_length_cost` and `Midpoint_placement`, the shortest edge first.
struct Edge_length_policies
{
  auto operator()(Simplification_mesh&) const
  {
    namespace SMS = Surface_mesh_simplification;
    return Cost_and_placement<SMS::Edge_length_cost<Simplification_mesh>, SMS::Midpoint_placement<Simplification_mesh> >(
        {}, {});
  }
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_POLICIES_H
