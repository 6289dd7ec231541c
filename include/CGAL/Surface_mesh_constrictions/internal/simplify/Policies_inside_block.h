// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_POLICIES_INSIDE_BLOCK_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_POLICIES_INSIDE_BLOCK_H

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Whether both ends of a profile's edge are among the first vertices of a block, those inside.
template <class Profile>
bool is_edge_inside(const Profile& profile, std::size_t inside)
{
  return static_cast<std::size_t>(profile.v0()) < inside && static_cast<std::size_t>(profile.v1()) < inside;
}

// A cost policy that has no cost for edges that are not inside. Derived from the given one, because CGAL asks some for
// more than their cost.
template <class Cost>
class Cost_inside_block : public Cost
{
public:
  Cost_inside_block(const Cost& cost, std::size_t inside) : Cost(cost), m_inside(inside) {}

  template <class Profile, class OptionalPoint>
  auto operator()(const Profile& profile, const OptionalPoint& placement) const
      -> decltype(std::declval<const Cost&>()(profile, placement))
  {
    if(!is_edge_inside(profile, m_inside))
      return {};
    return static_cast<const Cost&>(*this)(profile, placement);
  }

private:
  std::size_t m_inside;
};

// A placement policy that has no place for edges that are not inside.
template <class Placement>
class Placement_inside_block
{
public:
  Placement_inside_block(const Placement& placement, std::size_t inside) : m_placement(placement), m_inside(inside) {}

  template <class Profile>
  auto operator()(const Profile& profile) const -> decltype(std::declval<const Placement&>()(profile))
  {
    if(!is_edge_inside(profile, m_inside))
      return {};
    return m_placement(profile);
  }

private:
  Placement m_placement;
  std::size_t m_inside;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_POLICIES_INSIDE_BLOCK_H
