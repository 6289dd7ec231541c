// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_COLLAPSE_RECORDING_VISITOR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_COLLAPSE_RECORDING_VISITOR_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/non_face_triangles.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The record that a `Collapse_recording_visitor` writes.
struct Collapse_record
{
  std::vector<Edge_collapse> collapses;  ///< in the order in which they were made
  std::vector<Seed_curve> refused_seeds; ///< non-face triangles for which a collapse was refused, each once
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Visitor of CGAL's `edge_collapse()` that records the collapses, from which a `Progressive_mesh` is built, and the
/// non-face triangles for which a collapse was refused (Sections 1 and 4.4 of the paper). It works with any placement
/// and filter.
///
/// The visitor is copied by `edge_collapse()`; the record that it points to must outlive the call.
///
/// \cgalModels{EdgeCollapseSimplificationVisitor}
///
/// \tparam VertexIndexMap readable map from vertices of the simplified mesh to integers that name them in the record
template <class VertexIndexMap>
class Collapse_recording_visitor
{
public:
  /// \param record what is written to
  /// \param vim names the vertices in the record
  /// \param with_refused_seeds whether `Collapse_record::refused_seeds` is written, too
  Collapse_recording_visitor(Collapse_record& record, VertexIndexMap vim, bool with_refused_seeds = true)
    : m_record(&record), m_vim(vim), m_with_refused_seeds(with_refused_seeds)
  {}

  /// does nothing
  template <class TriangleMesh>
  void OnStarted(TriangleMesh&)
  {}

  /// does nothing
  template <class TriangleMesh>
  void OnFinished(TriangleMesh&)
  {}

  /// records the seeds of the edge that was selected last.
  /// \cost quadratic in the degree of the edge's ends
  template <class Profile>
  void OnStopConditionReached(const Profile& profile)
  {
    note_seeds(profile);
  }

  /// does nothing
  template <class Profile, class OptionalCost>
  void OnCollected(const Profile&, const OptionalCost&)
  {}

  /// does nothing
  template <class Profile, class OptionalCost, class Size>
  void OnSelected(const Profile&, const OptionalCost&, Size, Size)
  {}

  /// does nothing
  template <class Profile, class OptionalPoint>
  void OnCollapsing(const Profile&, const OptionalPoint&)
  {}

  /// records the seeds of the edge whose collapse is refused.
  /// \cost quadratic in the degree of the edge's ends
  template <class Profile>
  void OnNonCollapsable(const Profile& profile)
  {
    note_seeds(profile);
  }

  // Not OnCollapsing: edges of length zero are collapsed without it, and only here the kept vertex is known.
  /// records the collapse.
  template <class Profile, class Vertex>
  void OnCollapsed(const Profile& profile, const Vertex& kept)
  {
    const Vertex removed = kept == profile.v1() ? profile.v0() : profile.v1();
    const auto p = get(profile.vertex_point_map(), kept);
    m_record->collapses.push_back(
        Edge_collapse{index(removed), index(kept),
                      Progressive_mesh::Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()))});
  }

private:
  template <class Vertex>
  Index index(const Vertex& v) const
  {
    return static_cast<Index>(get(m_vim, v));
  }

  template <class Profile>
  void note_seeds(const Profile& profile)
  {
    if(!m_with_refused_seeds)
      return;
    internal::for_each_apex_of_non_face_triangle(profile, [&](const auto& apex) {
      std::array<Index, 3> triangle = {index(profile.v0()), index(profile.v1()), index(apex)};
      std::sort(triangle.begin(), triangle.end());
      if(m_known.insert(triangle).second)
        m_record->refused_seeds.push_back(Seed_curve{m_record->collapses.size(),
                                                     std::vector<Index>(triangle.begin(), triangle.end()),
                                                     Seed_origin::NON_FACE_TRIANGLE});
      return true;
    });
  }

  Collapse_record* m_record;
  VertexIndexMap m_vim;
  bool m_with_refused_seeds;
  std::set<std::array<Index, 3>> m_known;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_COLLAPSE_RECORDING_VISITOR_H
