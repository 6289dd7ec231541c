// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshConstrictionsConcepts
/// \cgalConcept
///
/// The concept `ConstrictionSplitVisitor` describes the visitor of
/// `CGAL::Surface_mesh_constrictions::split_along_constrictions()`. It is told which elements of a mesh are split, and
/// into which pieces, so that it can hand on properties of faces and edges to the pieces.
///
/// The names are those of the visitors of the corefinement in Polygon Mesh Processing. The visitor is copied, so it
/// should hold pointers to the data that it changes.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Surface_mesh_constrictions::Split_visitor_base}
/// \cgalHasModelsEnd
class ConstrictionSplitVisitor
{
public:
  /// The type of the mesh that is split.
  typedef unspecified_type Triangle_mesh;

  /// A halfedge of it.
  typedef unspecified_type halfedge_descriptor;

  /// A face of it.
  typedef unspecified_type face_descriptor;

  /// called when an edge has been split: `h` ends at the new vertex, which has its point, and `next(h, tm)` is the old
  /// halfedge. If it is crossed several times it is called for each, from the source of the old halfedge to its target.
  void edge_split(halfedge_descriptor h, const Triangle_mesh& tm) const;

  /// called before `f` is split; `f` will be one of the faces that it is split into
  void before_subface_creations(face_descriptor f, const Triangle_mesh& tm) const;

  /// called for each face that is created from the face of the last call of `before_subface_creations()`. It may still
  /// have more than three vertices.
  void after_subface_created(face_descriptor f, const Triangle_mesh& tm) const;

  /// called when the face of the last call of `before_subface_creations()` has been split into triangles
  void after_subface_creations(const Triangle_mesh& tm) const;
};
