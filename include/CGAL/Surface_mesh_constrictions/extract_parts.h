// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_EXTRACT_PARTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_EXTRACT_PARTS_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/fill_hole.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The triangles of a mesh opened along marked edges: a vertex there becomes one for each fan of faces between two of
// them.
template <class TriangleMesh, class EdgeIsConstrainedMap>
class Opened_mesh
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

public:
  Opened_mesh(const TriangleMesh& tm, EdgeIsConstrainedMap marks) : m_tm(tm), m_marks(marks) {}

  void add(face_descriptor f)
  {
    std::array<std::size_t, 3> triangle;
    halfedge_descriptor h = halfedge(f, m_tm);
    for(std::size_t& v : triangle)
    {
      v = vertex(h);
      h = next(h, m_tm);
    }
    triangles.push_back(triangle);
    for(std::size_t i = 0; i < 3; ++i, h = next(h, m_tm))
      if(is_marked(h))
        cuts.emplace(triangle[(i + 2) % 3], triangle[i]);
  }

  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<vertex_descriptor> vertices; // of the mesh, of each vertex here
  std::set<std::pair<std::size_t, std::size_t> > cuts; // the sides of triangles at marked edges, by their ends

private:
  bool is_marked(halfedge_descriptor h) const { return get(m_marks, edge(h, m_tm)); }

  // where a fan of faces ends
  bool is_end(halfedge_descriptor h) const { return is_marked(h) || CGAL::is_border_edge(h, m_tm); }

  // The vertex at the end of a halfedge, the same for all of its fan.
  std::size_t vertex(halfedge_descriptor h)
  {
    const auto known = m_vertex.find(h);
    if(known != m_vertex.end())
      return known->second;
    halfedge_descriptor first = h;
    while(!is_end(first))
    {
      first = prev(opposite(first, m_tm), m_tm);
      if(first == h)
        break;
    }
    const std::size_t v = vertices.size();
    vertices.push_back(target(h, m_tm));
    h = first;
    do
    {
      m_vertex[h] = v;
      const halfedge_descriptor n = next(h, m_tm);
      if(is_end(n))
        break;
      h = opposite(n, m_tm);
    } while(h != first);
    return v;
  }

  const TriangleMesh& m_tm;
  EdgeIsConstrainedMap m_marks;
  std::unordered_map<halfedge_descriptor, std::size_t> m_vertex;
};

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// makes a mesh of each part into which marked edges divide a mesh, and closes the holes along them: meshes for
/// printing or simulation.
///
/// The mesh is opened along the marked edges. A vertex there is doubled, so that parts that touch themselves or others
/// become manifold, and a part on both sides of a curve, as of a torus along a meridian, gets two holes. Each hole is
/// filled by `CGAL::Polygon_mesh_processing::triangulate_hole()`, or, if that finds no triangulation, by the cone to
/// the mean of its vertices. Holes of the mesh stay open, and so does what lies partly along a hole of the mesh and
/// partly along marked edges, unless `with_filled_holes` asks for these. Where the surface is strongly bent around a
/// curve a filling may intersect the part.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`, default constructible
/// \tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` with the edges of `tm` as key type and `bool` as value
///         type
/// \tparam OutputIterator takes `TriangleMesh`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh
/// \param edge_is_constrained_map marks closed curves, as `split_along_constrictions()` does
/// \param out the parts in the order of `CGAL::Polygon_mesh_processing::connected_components()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is that of the points of `TriangleMesh`}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{with_caps}
///     \cgalParamDescription{whether holes along marked edges are filled; a function of
///                           `CGAL::Surface_mesh_constrictions::parameters`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{with_filled_holes}
///     \cgalParamDescription{whether other holes are filled, those that the mesh has; a function of
///                           `CGAL::Surface_mesh_constrictions::parameters`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \cost linear in the size of the mesh, plus that of filling the holes
template <class TriangleMesh, class EdgeIsConstrainedMap, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator extract_parts(const TriangleMesh& tm, EdgeIsConstrainedMap edge_is_constrained_map, OutputIterator out,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace PMP = Polygon_mesh_processing;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const bool with_caps = choose_parameter(get_parameter(np, internal_np::with_caps), true);
  const bool with_filled_holes = choose_parameter(get_parameter(np, internal_np::with_filled_holes), false);

  const auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), tm);
  const std::size_t n =
      PMP::connected_components(tm, component, CGAL::parameters::edge_is_constrained_map(edge_is_constrained_map));
  std::vector<std::vector<typename Graph_traits::face_descriptor>> faces_of_part(n);
  for(auto f : faces(tm))
    faces_of_part[get(component, f)].push_back(f);

  for(const auto& faces : faces_of_part)
  {
    internal::Opened_mesh<TriangleMesh, EdgeIsConstrainedMap> opened(tm, edge_is_constrained_map);
    for(auto f : faces)
      opened.add(f);
    std::vector<typename boost::property_traits<std::decay_t<decltype(vpm)>>::value_type> points;
    for(auto v : opened.vertices)
      points.push_back(get(vpm, v));
    TriangleMesh part;
    PMP::polygon_soup_to_polygon_mesh(points, opened.triangles, part);
    if(with_caps || with_filled_holes)
    {
      // vertices of the part have the numbers of the soup
      std::unordered_map<typename Graph_traits::vertex_descriptor, std::size_t> number;
      for(auto v : vertices(part))
        number.emplace(v, number.size());
      const auto is_cut = [&](auto h) { // along the border, so against the side of a triangle
        return opened.cuts.count({number.at(target(h, part)), number.at(source(h, part))}) != 0;
      };
      std::vector<typename Graph_traits::halfedge_descriptor> border;
      for(auto h : halfedges(part))
        if(is_border(h, part))
          border.push_back(h);
      for(auto h : border)
        if(is_border(h, part))
        {
          const auto hole = halfedges_around_face(h, part);
          const bool is_cap = std::all_of(hole.begin(), hole.end(), is_cut);
          if(is_cap ? with_caps : with_filled_holes)
            internal::fill_hole(h, part);
        }
    }
    *out++ = std::move(part);
  }
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_EXTRACT_PARTS_H
