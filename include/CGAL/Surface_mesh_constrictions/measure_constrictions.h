// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_MEASURE_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_MEASURE_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/triangulate_cap.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curves_on_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Parallel_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Caps of curves with more points than this are spanned by so many points of the curve.
constexpr std::size_t most_cap_corners = 256;

// The least area of a triangulation of a curve: of its points or, if there are many, of points at equal distances along
// it.
inline double cap_area(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Vector3> points;
  for(const Trace_point& p : trace)
    points.push_back(position(pm, p));
  Cap_polygon polygon;
  const auto add = [&polygon](const Vector3& x) { polygon.emplace_back(x.x, x.y, x.z); };
  if(points.size() <= most_cap_corners)
    std::for_each(points.begin(), points.end(), add);
  else
  {
    const double step = length(pm, trace) / most_cap_corners;
    double before = 0; // along the curve, of the point with the number i
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Vector3 &p = points[i], &q = points[(i + 1) % points.size()];
      const double edge = norm(q - p);
      for(; polygon.size() < most_cap_corners && polygon.size() * step <= before + edge;)
        add(p + (edge > 0 ? (polygon.size() * step - before) / edge : 0) * (q - p));
      before += edge;
    }
  }
  double area = 0;
  for(const auto& t : least_triangulation(polygon, [](std::size_t, std::size_t) { return false; }))
  {
    const auto normal = cross_product(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]);
    area += std::sqrt(normal.squared_length()) / 2;
  }
  return area;
}

// What `measure_constrictions()` does with arguments of the right kind.
template <class TriangleMesh, class ConstrictionRange, class OutputIterator, class NamedParameters>
OutputIterator measure_constrictions_checked(const TriangleMesh& tm, const ConstrictionRange& constrictions,
                                             OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);

  const std::vector<Constriction<TriangleMesh>> given(constrictions.begin(), constrictions.end());
  Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const Coordinate_unit unit = imported.unit();
  const Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  const auto curves = curves_on_copy(given, imported, vim, pm);
  const Edge_lengths lengths(pm);
  Parallel_curves parallels(pm, lengths);
  for(std::size_t i = 0; i < given.size(); ++i)
  {
    const std::vector<Trace_point>& trace = curves.traces[i];
    typename Constriction<TriangleMesh>::Data data = given[i].data();
    data.cap_area = unit.restored(cap_area(pm, trace), 2);
    const std::array<double, 2> girths = parallels.longest(trace, length(pm, trace), !data.separating);
    for(std::size_t s = 0; s < 2; ++s)
      data.side_girths[s] = unit.restored(girths[s]);
    *out++ = Constriction<TriangleMesh>(std::move(data));
  }
  return out;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// measures constrictions: the area of the cap that closes a cut along each, and how wide the surface gets beside it.
///
/// The cap is the triangulation of the curve without further vertices that has the least area; of a curve with more than
/// 256 points, that of 256 points at equal distances along it. It is flat if the curve is.
///
/// A parallel curve is a connected curve of points at one distance from the constriction, measured along the surface
/// on one side. Distances are those of fast marching, so the curves are polygons on the mesh. The girth of a side is the
/// length of the longest one, and at least that of the constriction. It is sampled: at distances that differ by 1/32 of
/// the length of the constriction near it, and by 1/32 of the distance further away. If the curve does not separate,
/// parallel curves count up to the distance at which its two sides meet. So `1 - length() / min(side_girths())` is how
/// much narrower the body is than on its thinner side: a stenosis of so many percent.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param constrictions constrictions of `tm`, as computed on it with the same points
/// \param out the same constrictions in the same order, with `Constriction::cap_area()`, in the square of the unit of
///        the coordinates, and `Constriction::side_girths()`, in the unit
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used, or if locations of a constriction are no curve on it
/// \cost for each curve, O(n log n) for n faces, plus the swept region for a hundred distances or so, plus the cube of
///       the number of corners of the cap
///
/// \sa `detect_constrictions()`
/// \sa `plane_section_at_location()`
template <class TriangleMesh, class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator measure_constrictions(const TriangleMesh& tm, const ConstrictionRange& constrictions, OutputIterator out,
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Mesh_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    return internal::measure_constrictions_checked(tm, constrictions, out, np);
  else
    return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_MEASURE_CONSTRICTIONS_H
