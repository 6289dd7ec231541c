// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_LABEL_BORDER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_LABEL_BORDER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What has become of a border between two labels.
enum class Label_border_outcome
{
  CLOSED_GEODESIC, ///< a closed border has become a constriction
  GEODESIC_ARC,    ///< a border that is held at its ends has become a geodesic between them
  DEGENERATE,      ///< it shortens to a point, or to the vertex at which it is held: one of its labels vanishes
  CROSSING,        ///< what it is tightened to crosses another border
  NOT_SIMPLE,      ///< what it is tightened to crosses or touches itself
  NOT_CERTIFIED    ///< what a closed border is tightened to could not be proved to be a constriction
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A border between the faces of two labels, as it was and as it is after `tighten_label_borders()`. It is closed, or
/// it runs from a vertex that it is held at to another one, or back to the same.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Label a type with `operator<`
template <class TriangleMesh, class Label>
struct Label_border
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor; ///< of the mesh
  typedef typename Constriction<TriangleMesh>::Location Location;                          ///< a point of a border
  typedef typename Constriction<TriangleMesh>::Face_location Face_location; ///< a face, and barycentric coordinates

  std::array<Label, 2> labels; ///< on the left and on the right, along its direction; the left one is the lesser
  bool is_closed = true;       ///< else it is held at its ends

  /// the border as it was: the path of its vertices, the first not repeated if it is closed
  std::vector<vertex_descriptor> old_vertices;
  double old_length = 0; ///< of that path, in the unit of the mesh's coordinates

  Label_border_outcome outcome = Label_border_outcome::DEGENERATE; ///< what has become of it

  /// where the border runs now, in the same direction, and parts the labels; the first point is not repeated if it is
  /// closed. What is `CROSSING`, `NOT_SIMPLE` or `NOT_CERTIFIED` stays where it was. Empty if the border is gone: it is
  /// degenerate, or where it was it would cross others.
  std::vector<Location> locations;
  double length = 0; ///< of that, in the unit of the mesh's coordinates; 0 if the border is gone

  Constriction<TriangleMesh> curve; ///< what a closed border is tightened to; empty if that is no constriction
  Certificate certificate; ///< that of `curve`, or why it could not be proved; of an arc `GEODESIC_ARC`, or why not

  /// how prominent `curve` is, if that has been asked for because closed borders cross; else NaN
  double prominence = std::numeric_limits<double>::quiet_NaN();

  /// the label that vanishes beside the border: on its side of a degenerate one, or between this border and others, if
  /// it comes to lie on these all along
  std::optional<Label> vanishing_label;

  std::optional<std::size_t> crossed_border; ///< of one that is `CROSSING`: the place of the border that it crosses

  /// writes the points of `locations` to `out`.
  ///
  /// \param tm the mesh that the border was computed on
  /// \param vpm its vertex point map
  /// \param out an output iterator that takes the value type of `vpm`
  /// \cost linear in the number of locations
  template <class VertexPointMap, class OutputIterator>
  OutputIterator points(const TriangleMesh& tm, VertexPointMap vpm, OutputIterator out) const
  {
    return located().points(tm, vpm, out);
  }

  /// as above, with the mesh's own points.
  template <class OutputIterator>
  OutputIterator points(const TriangleMesh& tm, OutputIterator out) const
  {
    return points(tm, get(CGAL::vertex_point, tm), out);
  }

  /// writes `locations` to `out` as `Face_location`s; see `Constriction::face_locations()`.
  template <class OutputIterator>
  OutputIterator face_locations(const TriangleMesh& tm, OutputIterator out) const
  {
    return located().face_locations(tm, out);
  }

private:
  Constriction<TriangleMesh> located() const
  {
    typename Constriction<TriangleMesh>::Data data;
    data.locations = locations;
    return Constriction<TriangleMesh>(data);
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The result of `tighten_label_borders()`.
template <class TriangleMesh, class Label>
struct Tightened_labels
{
  std::vector<Label_border<TriangleMesh, Label>> borders; ///< one for each border that there was
  std::vector<Surface_part> parts; ///< into which the borders divide the surface now, in the order of their first faces
  std::vector<Label> labels;       ///< of the parts; of one that a border has vanished from, that of most of its area
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_LABEL_BORDER_H
