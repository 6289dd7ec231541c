// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CLOSED_CURVE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CLOSED_CURVE_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A closed curve on the current surface of a `Progressive_mesh`, given by its combinatorics: the cyclic sequence of
/// its pivots and, between them, of the halfedges that it crosses. Between two pivots it runs straight in the planar
/// unfolding of the faces that it crosses, or along the edge that joins them; so its positions need not be stored.
struct Closed_curve
{
  /// A pivot, or a halfedge that is crossed from its own face to the opposite one; the other is `null_index`.
  struct Node
  {
    Index pivot;    ///< a vertex, or `null_index`
    Index halfedge; ///< a halfedge that is crossed, or `null_index`

    /// whether the curve passes through a vertex here
    bool is_pivot() const { return pivot != null_index; }
    /// whether both are the same pivot, or the same halfedge
    friend bool operator==(const Node& a, const Node& b) { return a.pivot == b.pivot && a.halfedge == b.halfedge; }
  };

  std::vector<Node> nodes; ///< the first is a pivot; it is not repeated at the end

  /// an empty curve: what has shortened to a point
  Closed_curve() = default;

  /// the curve along the edges between consecutive vertices of a closed path.
  explicit Closed_curve(const std::vector<Index>& path)
  {
    for(Index v : path)
      nodes.push_back(Node{v, null_index});
  }
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CLOSED_CURVE_H
