// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_EDGE_SET_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_EDGE_SET_H

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>

#include <boost/container/flat_set.hpp>
#include <boost/container/set.hpp>
#include <boost/container/small_vector.hpp>

#include <set>
#include <type_traits>

// After each collapse CGAL's edge_collapse() puts the thirty or so edges around it into a std::set, goes through it
// once and throws it away. With a node for each edge this takes more than a quarter of the simplification, and no
// parameter of edge_collapse() changes it. But the standard allows to specialise std::set for elements of a
// user-defined type. Sets of halfedges of the simplified mesh, in the order of edge_collapse(), are therefore sorted
// arrays, on the stack while they are short.
//
// Unlike those of a general std::set, their iterators do not survive insertion and erasure, which are linear. All other
// sets of these halfedges have nodes as usual, among them that of edges of length zero, from which edge_collapse()
// takes edges while it goes through it.

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Whether this is the order of the sets that edge_collapse() makes after each collapse.
template <class Compare, class = void>
struct Is_order_of_edge_collapse : std::false_type
{};

template <class Compare>
struct Is_order_of_edge_collapse<
    Compare, std::void_t<typename std::remove_pointer_t<decltype(Compare::m_algorithm)>::Compare_id>>
  : std::is_same<Compare, typename std::remove_pointer_t<decltype(Compare::m_algorithm)>::Compare_id>
{};

template <class Compare, class Allocator>
using Set_of_halfedges = std::conditional_t<
    Is_order_of_edge_collapse<Compare>::value,
    boost::container::flat_set<Simplification_mesh::Halfedge_index, Compare,
                               boost::container::small_vector<Simplification_mesh::Halfedge_index, 64>>,
    boost::container::set<Simplification_mesh::Halfedge_index, Compare, Allocator>>;

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

namespace std {

template <class Compare, class Allocator>
class set<CGAL::Surface_mesh_constrictions::Simplification_mesh::Halfedge_index, Compare, Allocator>
  : public CGAL::Surface_mesh_constrictions::internal::Set_of_halfedges<Compare, Allocator>
{
  typedef CGAL::Surface_mesh_constrictions::internal::Set_of_halfedges<Compare, Allocator> Base;

public:
  using Base::Base;
};

} // namespace std

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_EDGE_SET_H
