// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_VISITOR_BASE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_VISITOR_BASE_H

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Visitor of `split_along_constrictions()` whose callbacks do nothing: derive from it and hide what you need. The
/// names are those of the visitors of the corefinement in Polygon Mesh Processing. The visitor is copied, so it should
/// hold pointers to the data that it changes.
///
/// \cgalModels{ConstrictionSplitVisitor}
///
/// \tparam TriangleMesh the type of the mesh that is split
template <class TriangleMesh>
struct Split_visitor_base
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;     ///< vertices
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor; ///< halfedges
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;         ///< faces

  /// called when an edge has been split: `h` ends at the new vertex, which has its point, and `next(h, tm)` is the old
  /// halfedge. If it is crossed several times it is called for each, from the source of the old halfedge to its target.
  void edge_split(halfedge_descriptor /* h */, const TriangleMesh& /* tm */) const {}

  /// called before `f` is split; `f` will be one of the faces that it is split into
  void before_subface_creations(face_descriptor /* f */, const TriangleMesh& /* tm */) const {}

  /// called for each face that is created from the face of the last call of `before_subface_creations()`. It may still
  /// have more than three vertices.
  void after_subface_created(face_descriptor /* f */, const TriangleMesh& /* tm */) const {}

  /// called when the face of the last call of `before_subface_creations()` has been split into triangles
  void after_subface_creations(const TriangleMesh& /* tm */) const {}
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_VISITOR_BASE_H
