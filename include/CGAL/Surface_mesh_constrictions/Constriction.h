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

  /// Everything that is known of the curve. Fill it to make a curve of your own, for `certify_constriction()` say.
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
    /// see `Constriction::prominence_interval()`
    std::array<double, 2> prominence_interval = {
        {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()}};
    double isolation = std::numeric_limits<double>::quiet_NaN(); ///< see `Constriction::isolation()`
    double cap_area = std::numeric_limits<double>::quiet_NaN();  ///< see `Constriction::cap_area()`
    /// see `Constriction::side_girths()`
    std::array<double, 2> side_girths = {
        {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()}};
    std::optional<std::size_t> dominated_by;     ///< see `Constriction::dominated_by()`
    std::optional<vertex_descriptor> slides_off; ///< see `Constriction::slides_off()`
    std::vector<std::size_t> crosses;            ///< see `Constriction::crosses()`
    std::vector<std::size_t> crosses_oddly;      ///< see `Constriction::crosses_oddly()`
    std::vector<std::size_t> rivals;             ///< see `Constriction::rivals()`
  };

  /// an empty curve
  Constriction() : m_data(std::make_shared<const Data>()) {}
  /// the curve with these data, which are not checked
  explicit Constriction(Data data) : m_data(std::make_shared<const Data>(std::move(data))) {}

  /// the closed sequence of points; the first is not repeated, any two consecutive ones lie in one face. A curve that
  /// was detected starts at the first of its vertices, unless its certificate names a place that violates a condition;
  /// this start and the direction depend on the numbering of the mesh alone, not on the search.
  const std::vector<Location>& locations() const { return m_data->locations; }

  /// the vertices that the curve passes through, in the order of `locations()`
  const std::vector<Pivot>& pivots() const { return m_data->pivots; }

  /// the seeds that led to this curve, the first to arrive first
  const std::vector<Seed>& seeds() const { return m_data->seeds; }

  /// the length, in the unit of the mesh's coordinates
  double length() const { return m_data->length; }

  /// length / pi, in the unit of the mesh's coordinates: the diameter of a circle of the same length
  double diameter() const { return m_data->length / CGAL_PI; }

  /// the centroid of the curve, in the mesh's coordinates: the centre of mass of a wire along it, so that it does not
  /// depend on how many `locations()` a piece has. Of a curve around a limb it lies on the axis of the limb, not on the
  /// surface.
  const std::array<double, 3>& centroid() const { return m_data->centroid; }

  /// the unit vector along the curve's area vector, which is half of the sum of the cross products of consecutive
  /// points. The projection of the curve along it has the largest area, and seen from its tip the curve runs
  /// counterclockwise. It is normal to the plane of a flat curve. It is (0, 0, 0) if the area vector is no longer than
  /// 10^-12 times half of the squared length, as for a curve that runs along both sides of a sheet.
  const std::array<double, 3>& normal() const { return m_data->normal; }

  /// the width of the flat band of parallel copies of which this curve is the canonical one, in the unit of the mesh's
  /// coordinates; 0 if it lies in no band
  double flat_band_width() const { return m_data->flat_band_width; }

  /// whether a cut along the curve divides its connected component of the mesh, with the holes of the mesh filled
  bool is_separating() const { return m_data->separating; }

  /// the homology class of the curve modulo 2: the numbers, ascending, of those cycles of a basis of the mesh's first
  /// homology group that the curve crosses an odd number of times. It is empty if the curve separates. Several curves
  /// that do not cross each other separate together if each number occurs in an even number of their classes. Only
  /// classes of curves from the same call can be compared.
  const std::vector<std::size_t>& homology_class() const { return m_data->homology_class; }

  /// the areas on the left and on the right of the curve within its connected component, in the squared unit of the
  /// mesh's coordinates. Of a non-separating curve both are the area of the component.
  const std::array<double, 2>& areas() const { return m_data->areas; }

  /// the genera of the parts on the left and on the right of the curve within its connected component, with their
  /// boundaries and the holes of the mesh closed. Of a non-separating curve both are the genus of the component when it
  /// is cut along the curve, which is one less than before.
  const std::array<std::size_t, 2>& genera() const { return m_data->genera; }

  /// length^2 / (4 pi A), with A the smaller of the two areas, to which those of flat fillings of the holes are added;
  /// infinite if there is nothing on one side but a hole
  double isoperimetric_ratio() const { return m_data->isoperimetric_ratio; }

  /// how much the curve is like a circle: 4 pi A / length^2, where A is the length of its area vector, which is the
  /// area of its largest projection to a plane. It is 1 for a circle, pi / 4 for a square, and less for a curve that is
  /// bent in space, as one that lies aslant around an arm and a shoulder.
  double roundness() const { return m_data->roundness; }

  /// the side that the curve chokes, if at least three quarters of its turning point there; else `Side::MIXED`
  Side side() const { return m_data->side; }

  /// whether the curve runs along the boundary of one hole for most of its length: `boundary_share()` is greater than
  /// 1/2
  bool is_rim() const { return m_data->rim; }

  /// the greatest share of the length of the curve that runs along the boundary of one hole. An arc along edges of the
  /// boundary counts. If the area on the side of the hole is less than that of a disc of the same perimeter, an arc
  /// through faces from one vertex of a jagged boundary to another counts, too, unless the boundary between them is
  /// more than twice as long.
  double boundary_share() const { return m_data->boundary_share; }

  /// what exact arithmetic has proved of the curve
  const Certificate& certificate() const { return m_data->certificate; }

  /// how much longer the curve must become, relative to its length, before it can slide to a shorter place or off over
  /// a point; see `compute_prominences()`. NaN if it has not been computed.
  double prominence() const { return m_data->prominence; }

  /// a proved lower bound and an upper bound of the prominence; see `bound_prominences()`. NaN if they have not been
  /// computed.
  const std::array<double, 2>& prominence_interval() const { return m_data->prominence_interval; }

  /// the least area that the curve must sweep to become the one that it is `dominated_by()`, divided by the squared
  /// length of the curve; infinite if it is dominated by none, or by one of another homology class. The isolation of a
  /// mountain, likewise, is how far it is to a higher place. NaN if it has not been computed.
  double isolation() const { return m_data->isolation; }

  /// the area of a cap that closes a cut along the curve: that of the lumen of a vessel, say. NaN if it has not been
  /// computed, see `measure_constrictions()`.
  double cap_area() const { return m_data->cap_area; }

  /// the lengths of the longest parallel curves on the left and on the right: how far it is around the body on each
  /// side where it is widest. NaN if they have not been computed, see `measure_constrictions()`.
  const std::array<double, 2>& side_girths() const { return m_data->side_girths; }

  /// the constriction that the curve slides to when it is made longer by its prominence, given by its place in the
  /// output sequence that has this curve. It is no longer than this one. None if the curve `slides_off()`, or if it
  /// cannot become shorter. A curve that cannot become shorter does not separate; its prominence tells how long it is
  /// when its two sides, swept, have met.
  const std::optional<std::size_t>& dominated_by() const { return m_data->dominated_by; }

  /// the vertex over which the curve slides off when it is made longer by its prominence, and shortens to a point; none
  /// if it does not separate, or is `dominated_by()` a constriction
  const std::optional<vertex_descriptor>& slides_off() const { return m_data->slides_off; }

  /// constrictions that the curve crosses there and back, that is an even number of times, given by their places as
  /// above. Of two that cross each other one lists the other, as a rule the longer one the shorter. Those of negligible
  /// prominence, less than 0.01, need not be listed.
  const std::vector<std::size_t>& crosses() const { return m_data->crosses; }

  /// the shorter constrictions that the curve crosses an odd number of times, as an equator of a torus crosses a
  /// meridian, given by their places as above. Those of negligible prominence are left out, and neither separates.
  const std::vector<std::size_t>& crosses_oddly() const { return m_data->crosses_oddly; }

  /// the constrictions that the curve crosses there and back and that are as good as it: neither of the two is more
  /// than 1.2 times as prominent as the other, and the longer one must sweep an area of at least 0.15 length^2 to
  /// become the other. To prefer one of them would be arbitrary. On a body with a plane of symmetry a curve that lies
  /// aslant and its mirror image are rivals; see `compute_prominences()`.
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
