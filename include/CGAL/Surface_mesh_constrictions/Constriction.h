// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CONSTRICTION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CONSTRICTION_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/floating_point_requirements.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What a constriction chokes.
enum class Side
{
  OBJECT,     ///< the solid that the surface bounds: a neck
  COMPLEMENT, ///< the space around it: the hole of a handle
  MIXED       ///< part of each
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A closed geodesic of a triangle mesh: straight in the planar unfolding of the faces that it crosses, with side
/// angles of at least pi at each vertex that it passes through.
///
/// The curve is combinatorial: vertices and halfedges of the mesh. Positions are computed from it on demand. Copies
/// share their data.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
template <class TriangleMesh>
class Constriction
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;     ///< vertices of the mesh
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor; ///< halfedges of the mesh
  typedef typename Graph_traits::face_descriptor face_descriptor;         ///< faces of the mesh

  /// A face and barycentric coordinates with respect to `source(h)`, `target(h)` and `target(next(h))` of its halfedge
  /// `h`, as in Polygon Mesh Processing and Surface Mesh Shortest Paths.
  typedef std::pair<face_descriptor, std::array<double, 3>> Face_location;

  /// One point of the curve: a vertex that it passes through, or the crossing of a halfedge from its face to the
  /// opposite face, at `source + parameter * (target - source)`.
  struct Location
  {
    bool is_pivot;                ///< whether the curve passes through a vertex here
    vertex_descriptor vertex;     ///< if `is_pivot`
    halfedge_descriptor halfedge; ///< if not `is_pivot`
    double parameter;             ///< in [0, 1]; 0 if `is_pivot`
  };

  /// A vertex that the curve passes through.
  struct Pivot
  {
    vertex_descriptor vertex; ///< of the mesh
    std::size_t location;     ///< its place in `locations()`
    double left_angle;        ///< radians, along the surface, on the left of the curve's direction; infinite to a hole
    double right_angle;       ///< radians, along the surface, on the right of the curve's direction; infinite to a hole
  };

  /// A seed curve that led to the constriction, in vertices of the input mesh. A vertex of T^level that several input
  /// vertices have been merged into is given by the input vertex whose descriptor it kept.
  struct Seed
  {
    std::size_t level;                       ///< number of edge collapses after which the path exists
    std::vector<vertex_descriptor> vertices; ///< in cyclic order, the first not repeated
    Seed_origin origin;                      ///< the kind of its source
  };

  /// Everything that is known of the curve, for those who make one themselves, as for `certify_constriction()`.
  struct Data
  {
    std::vector<Location> locations;                              ///< see `Constriction::locations()`
    std::vector<Pivot> pivots;                                    ///< see `Constriction::pivots()`
    std::vector<Seed> seeds;                                      ///< see `Constriction::seeds()`
    double length = 0;                                            ///< see `Constriction::length()`
    std::array<double, 3> centroid = {0, 0, 0};                   ///< see `Constriction::centroid()`
    std::array<double, 3> normal = {0, 0, 0};                     ///< see `Constriction::normal()`
    double flat_band_width = 0;                                   ///< see `Constriction::flat_band_width()`
    bool separating = false;                                      ///< see `Constriction::is_separating()`
    std::vector<std::size_t> homology_class;                      ///< see `Constriction::homology_class()`
    std::array<double, 2> areas = {0, 0};                         ///< see `Constriction::areas()`
    std::array<std::size_t, 2> genera = {0, 0};                   ///< see `Constriction::genera()`
    double isoperimetric_ratio = 0;                               ///< see `Constriction::isoperimetric_ratio()`
    double roundness = 0;                                         ///< see `Constriction::roundness()`
    Side side = Side::MIXED;                                      ///< see `Constriction::side()`
    bool rim = false;                                             ///< see `Constriction::is_rim()`
    double boundary_share = 0;                                    ///< see `Constriction::boundary_share()`
    Certificate certificate;                                      ///< see `Constriction::certificate()`
    double prominence = std::numeric_limits<double>::quiet_NaN(); ///< see `Constriction::prominence()`
    double isolation = std::numeric_limits<double>::quiet_NaN();  ///< see `Constriction::isolation()`
    std::optional<std::size_t> dominated_by;                      ///< see `Constriction::dominated_by()`
    std::optional<vertex_descriptor> slides_off;                  ///< see `Constriction::slides_off()`
    std::vector<std::size_t> crosses;                             ///< see `Constriction::crosses()`
    std::vector<std::size_t> crosses_oddly;                       ///< see `Constriction::crosses_oddly()`
    std::vector<std::size_t> rivals;                              ///< see `Constriction::rivals()`
  };

  /// an empty curve
  Constriction() : m_data(std::make_shared<const Data>()) {}
  /// the curve with these data, which are not checked
  explicit Constriction(Data data) : m_data(std::make_shared<const Data>(std::move(data))) {}

  /// the closed sequence of points; the first is not repeated, any two consecutive ones lie in one face
  const std::vector<Location>& locations() const { return m_data->locations; }

  /// the vertices that the curve passes through, in the order of `locations()`
  const std::vector<Pivot>& pivots() const { return m_data->pivots; }

  /// the seeds that led to this curve, the first to arrive first
  const std::vector<Seed>& seeds() const { return m_data->seeds; }

  /// in the unit of the mesh's coordinates
  double length() const { return m_data->length; }

  /// length / pi, in the unit of the mesh's coordinates: the diameter of the circle that is as long
  double diameter() const { return m_data->length / CGAL_PI; }

  /// the centroid of the curve, as of a wire that lies along it: the mean of its points by length, so that it does not
  /// matter how many `locations()` are where. In the mesh's coordinates. Around a limb it is on its axis, not on the
  /// surface.
  const std::array<double, 3>& centroid() const { return m_data->centroid; }

  /// the unit vector along the curve's area vector, half of the sum of the cross products of consecutive points: the
  /// direction in which its shadow has the largest area, and from whose tip it is seen to run counterclockwise. It
  /// is normal to the plane of a flat curve. (0, 0, 0) for a curve that encloses no area in any direction, as one that
  /// runs along both sides of a sheet: whose area vector is no longer than 10^-12 times half of its squared length.
  const std::array<double, 3>& normal() const { return m_data->normal; }

  /// the width of the flat band of parallel copies of which this is the canonical one; 0 if there is none
  double flat_band_width() const { return m_data->flat_band_width; }

  /// whether the connected component of the mesh falls apart when it is cut along the curve, its holes filled before
  bool is_separating() const { return m_data->separating; }

  /// the homology class of the curve modulo 2: the numbers, ascending, of those cycles of a basis of the mesh's first
  /// homology group that the curve crosses an odd number of times. It is empty if the curve separates. Curves none of
  /// which crosses another one separate together if each number occurs in an even number of their classes. Comparable
  /// between the curves of one call.
  const std::vector<std::size_t>& homology_class() const { return m_data->homology_class; }

  /// areas on the left and on the right of the curve within its connected component. Of a non-separating curve both
  /// are the area of the component.
  const std::array<double, 2>& areas() const { return m_data->areas; }

  /// genera of the parts on the left and on the right of the curve within its connected component, with their
  /// boundary closed, holes of the mesh too. Of a non-separating curve both are that of the component cut along it, one
  /// less than its own.
  const std::array<std::size_t, 2>& genera() const { return m_data->genera; }

  /// length^2 / (4 pi A), with A the smaller of the two areas, to which those of flat fillings of the holes are added;
  /// infinite if there is nothing on one side but a hole
  double isoperimetric_ratio() const { return m_data->isoperimetric_ratio; }

  /// how much it is like a circle: 4 pi A / length^2, with A the area of the largest of its shadows on a plane, which
  /// is the length of its area vector. 1 for a circle, pi / 4 for a square; less for one that lies aslant, around an
  /// arm and a shoulder, and is bent in space.
  double roundness() const { return m_data->roundness; }

  /// what it chokes: what at least three quarters of the turning of the curve say
  Side side() const { return m_data->side; }

  /// whether the curve runs along the boundary of one hole for most of its length: `boundary_share()` is greater than
  /// 1/2
  bool is_rim() const { return m_data->rim; }

  /// the greatest share of the length of the curve that runs along the boundary of one hole: along its edges; and, if
  /// there is hardly anything on the side of the hole, less than the area of a disc of that perimeter, also through
  /// faces from one of its vertices to another, where the boundary is jagged but no more than twice as long
  double boundary_share() const { return m_data->boundary_share; }

  /// what has been proved of the curve
  const Certificate& certificate() const { return m_data->certificate; }

  /// how much longer the curve must become, relative to its length, before it can slide to where it is shorter or off
  /// over a point; see `compute_prominences()`. NaN if it has not been computed.
  double prominence() const { return m_data->prominence; }

  /// the area that the curve must sweep at least to become the one that it is `dominated_by()`, divided by the squared
  /// length of the curve; infinite if it is dominated by none, or by one of another homology class. Of mountains that
  /// is how far one must go to a higher place. NaN if it has not been computed.
  double isolation() const { return m_data->isolation; }

  /// the constriction that the curve slides to when it is made longer by its prominence, given by its place in the
  /// sequence that this one was written to the output in. It is no longer than this one. None if the curve
  /// `slides_off()`, or if it cannot become shorter: then it does not separate, and the prominence tells how long it is
  /// when its two sides, swept, have met.
  const std::optional<std::size_t>& dominated_by() const { return m_data->dominated_by; }

  /// the vertex over which the curve slides off, shortening to a point, when it is made longer by its prominence; none
  /// if it does not separate, or is `dominated_by()` a constriction
  const std::optional<vertex_descriptor>& slides_off() const { return m_data->slides_off; }

  /// constrictions that the curve crosses, there and back, given by their places as above. Of two that cross each other
  /// one names the other, as a rule the longer the shorter. Those of negligible prominence, less than 0.01, need not be
  /// named.
  const std::vector<std::size_t>& crosses() const { return m_data->crosses; }

  /// the shorter constrictions that the curve crosses an odd number of times, as an equator of a torus crosses a
  /// meridian, given by their places as above. Those of negligible prominence are left out, and neither separates.
  const std::vector<std::size_t>& crosses_oddly() const { return m_data->crosses_oddly; }

  /// the constrictions that it crosses there and back, and of which it would be arbitrary to prefer one: neither is
  /// more than 1.2 times as prominent as the other, and each must sweep an area of at least 0.15 length^2 to become
  /// the other. Of a body with a plane of symmetry a curve that lies aslant and its mirror image are such; see
  /// `compute_prominences()`.
  const std::vector<std::size_t>& rivals() const { return m_data->rivals; }

  /// all of the above
  const Data& data() const { return *m_data; }

  /// writes the points of the curve, in the order of `locations()`, to `out`.
  ///
  /// \param tm the mesh that the constriction was computed on
  /// \param vpm its vertex point map
  /// \param out an output iterator that takes the value type of `vpm`
  /// \cost linear in the number of locations
  template <class VertexPointMap, class OutputIterator>
  OutputIterator points(const TriangleMesh& tm, VertexPointMap vpm, OutputIterator out) const
  {
    typedef typename boost::property_traits<VertexPointMap>::value_type Point;
    typedef typename Kernel_traits<Point>::Kernel::FT FT;
    for(const Location& l : m_data->locations)
    {
      if(l.is_pivot)
        *out++ = Point(get(vpm, l.vertex));
      else
      {
        const Point p = get(vpm, source(l.halfedge, tm));
        const Point q = get(vpm, target(l.halfedge, tm));
        *out++ = Point(p + FT(l.parameter) * (q - p));
      }
    }
    return out;
  }

  /// as above, with the mesh's own points.
  template <class OutputIterator>
  OutputIterator points(const TriangleMesh& tm, OutputIterator out) const
  {
    return points(tm, get(CGAL::vertex_point, tm), out);
  }

  /// writes the locations of the curve, in the order of `locations()`, to `out` as `Face_location`s. The face of a
  /// crossing is the one that the curve comes from.
  ///
  /// \param tm the mesh that the constriction was computed on
  /// \param out an output iterator that takes `Face_location`
  /// \cost linear in the number of locations
  template <class OutputIterator>
  OutputIterator face_locations(const TriangleMesh& tm, OutputIterator out) const
  {
    for(const Location& l : m_data->locations)
    {
      halfedge_descriptor h = l.is_pivot ? halfedge(l.vertex, tm) : l.halfedge;
      if(face(h, tm) == boost::graph_traits<TriangleMesh>::null_face()) // of a vertex on the boundary
        h = prev(opposite(h, tm), tm);
      const face_descriptor f = face(h, tm);
      Face_location location(f, {0, 0, 0});
      halfedge_descriptor hf = halfedge(f, tm);
      for(int i = 0; i < 3; ++i, hf = next(hf, tm))
      {
        // a vertex is the target of its halfedge h, a crossing lies between the source and the target of h
        if(l.is_pivot)
        {
          if(source(hf, tm) == l.vertex)
            location.second[i] = 1;
        }
        else if(hf == h)
          location.second[i] = 1 - l.parameter;
        else if(hf == next(h, tm))
          location.second[i] = l.parameter;
      }
      *out++ = location;
    }
    return out;
  }

private:
  std::shared_ptr<const Data> m_data;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CONSTRICTION_H
