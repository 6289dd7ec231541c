// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PARTS_CHECK_H
#define PARTS_CHECK_H

// Checks what cutting a surface along curves gives, from the meshes that come out.

#include "test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace parts_check {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;

template <class Mesh>
long euler_characteristic(const Mesh& mesh)
{
  return static_cast<long>(vertices(mesh).size()) - static_cast<long>(edges(mesh).size()) +
         static_cast<long>(faces(mesh).size());
}

// Notes which old face each new one comes from.
template <class Mesh>
struct Ancestry : public SMC::Split_visitor_base<Mesh>
{
  typedef typename boost::graph_traits<Mesh>::face_descriptor Face;

  struct Record
  {
    Face current;
    std::map<Face, Face> old_face; // of new faces
    std::size_t splits = 0, open = 0, edge_splits = 0;
  };
  Record* record;

  explicit Ancestry(Record& record) : record(&record) {}
  void edge_split(typename boost::graph_traits<Mesh>::halfedge_descriptor, const Mesh&) const { ++record->edge_splits; }
  void before_subface_creations(Face f, const Mesh&) const
  {
    record->current = f;
    ++record->splits;
    ++record->open;
  }
  void after_subface_created(Face f, const Mesh&) const
  {
    EXPECT_TRUE(record->old_face.emplace(f, record->current).second);
  }
  void after_subface_creations(const Mesh&) const { --record->open; }
};

template <class Mesh>
struct Split_mesh
{
  typedef typename boost::graph_traits<Mesh>::edge_descriptor Edge;
  typedef typename boost::graph_traits<Mesh>::face_descriptor Face;

  std::set<Edge> marked_edges;
  boost::associative_property_map<std::map<Edge, bool>> marks() { return {mark}; }
  std::map<Edge, bool> mark;
  std::map<Face, std::size_t> part;
  std::size_t number_of_parts;
  SMC::Split_curves<Mesh> curves;
  SMC::Surface_parts parts; // as segmented
};

template <class Mesh>
auto normal(typename boost::graph_traits<Mesh>::face_descriptor f, const Mesh& mesh)
{
  const auto vpm = get(CGAL::vertex_point, mesh);
  const auto h = halfedge(f, mesh);
  const auto p = get(vpm, source(h, mesh)), q = get(vpm, target(h, mesh)), r = get(vpm, target(next(h, mesh), mesh));
  return CGAL::cross_product(q - p, r - p);
}

// Whether directions agree, exactly where the numbers are exact; else no face may have its normal turned away whose
// height is more than some rounding errors.
template <class Vector>
bool is_parallel(const Vector& n, const Vector& old_normal, double longest_edge)
{
  typedef typename CGAL::Kernel_traits<Vector>::Kernel::FT FT;
  if constexpr(std::is_same_v<FT, double>)
    return n * old_normal >= 0 || std::sqrt(n.squared_length()) < 1e-13 * longest_edge * longest_edge;
  else
    return CGAL::cross_product(n, old_normal) == CGAL::NULL_VECTOR && n * old_normal > 0;
}

// Segments and splits a closed mesh along curves and checks everything that does not depend on the particular surface.
// Curves with made-up parameters are moved, and do not keep their lengths.
template <class Mesh>
Split_mesh<Mesh> expect_parts(Mesh& mesh, const std::vector<SMC::Constriction<Mesh>>& curves, bool keeps_lengths = true)
{
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor Face;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  const auto vpm = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<std::decay_t<decltype(vpm)>>::value_type Point;
  Split_mesh<Mesh> result;

  std::map<Face, std::size_t> patch;
  result.parts = SMC::segment_by_constrictions(mesh, curves, boost::make_assoc_property_map(patch));
  const SMC::Surface_parts& parts = result.parts;
  EXPECT_EQ(patch.size(), faces(mesh).size());

  const double area = CGAL::to_double(PMP::area(mesh)), volume = CGAL::to_double(PMP::volume(mesh));
  double sum = 0;
  std::size_t number_of_faces = 0;
  for(const SMC::Surface_part& p : parts.parts)
  {
    EXPECT_GT(p.area, 0);
    sum += p.area;
    number_of_faces += p.number_of_faces;
  }
  EXPECT_NEAR(sum, area, 1e-12 * area);
  EXPECT_EQ(number_of_faces, faces(mesh).size());
  const double volume_tolerance = 1e-12 * std::pow(area, 1.5);
  double sum_of_volumes = 0;
  for(const SMC::Surface_part& p : parts.parts)
    sum_of_volumes += p.volume;
  EXPECT_TRUE(!keeps_lengths || std::abs(sum_of_volumes - volume) <= volume_tolerance) << sum_of_volumes - volume;

  // the mesh as it was
  const bool bounds_volume = PMP::does_bound_a_volume(mesh);
  const long characteristic = euler_characteristic(mesh);
  std::map<Vertex, Point> old_points;
  for(auto v : vertices(mesh))
    old_points.emplace(v, get(vpm, v));
  std::map<Face, decltype(normal<Mesh>(*faces(mesh).begin(), mesh))> old_normals;
  for(auto f : faces(mesh))
    old_normals.emplace(f, normal<Mesh>(f, mesh));
  double longest_edge = 0;
  for(auto e : edges(mesh))
    longest_edge = (std::max)(longest_edge, CGAL::to_double(PMP::edge_length(halfedge(e, mesh), mesh)));
  std::vector<std::vector<Point>> points;
  for(const auto& c : curves)
  {
    points.emplace_back();
    c.points(mesh, std::back_inserter(points.back()));
  }

  typename Ancestry<Mesh>::Record record;
  result.curves = SMC::split_along_constrictions(
      mesh, curves, CGAL::parameters::edge_is_constrained_map(result.marks()).visitor(Ancestry<Mesh>(record)));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(euler_characteristic(mesh), characteristic);
  EXPECT_NEAR(CGAL::to_double(PMP::area(mesh)), area, 1e-12 * area);
  EXPECT_NEAR(CGAL::to_double(PMP::volume(mesh)), volume, volume_tolerance);
  for(const auto& [v, p] : old_points)
    EXPECT_EQ(get(vpm, v), p);
  EXPECT_EQ(record.open, 0u);
  EXPECT_EQ(record.old_face.size() + old_normals.size(), faces(mesh).size());
  EXPECT_EQ(record.edge_splits + old_points.size(), vertices(mesh).size());
  for(auto f : faces(mesh))
  {
    const auto created = record.old_face.find(f);
    const Face old_face = created == record.old_face.end() ? f : created->second;
    const auto& old_normal = old_normals.at(old_face);
    EXPECT_TRUE(old_normal == CGAL::NULL_VECTOR || is_parallel(normal<Mesh>(f, mesh), old_normal, longest_edge));
  }

  // the curves
  EXPECT_EQ(result.curves.outcomes.size(), curves.size());
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    EXPECT_EQ(result.curves.outcomes[i].is_used, parts.outcomes[i].is_used);
    EXPECT_EQ(result.curves.outcomes[i].crossed_curve, parts.outcomes[i].crossed_curve);
    const auto& cycle = result.curves.halfedges[i];
    EXPECT_EQ(cycle.size(), result.curves.outcomes[i].is_used ? points[i].size() : 0u);
    double length = 0, expected = 0;
    std::set<Vertex> seen;
    for(std::size_t j = 0; j < cycle.size(); ++j)
    {
      EXPECT_EQ(target(cycle[j], mesh), source(cycle[(j + 1) % cycle.size()], mesh));
      EXPECT_TRUE(seen.insert(target(cycle[j], mesh)).second);
      EXPECT_TRUE(get(result.marks(), edge(cycle[j], mesh)));
      result.marked_edges.insert(edge(cycle[j], mesh));
      length += CGAL::to_double(PMP::edge_length(cycle[j], mesh));
      expected += std::sqrt(CGAL::to_double(CGAL::squared_distance(points[i][j], points[i][(j + 1) % cycle.size()])));
    }
    EXPECT_TRUE(!keeps_lengths || std::abs(length - expected) <= 1e-12 * expected);
  }
  std::set<Vertex> vertices_on_curves;
  std::size_t marks = 0;
  for(const auto& [e, is_marked] : result.mark)
    marks += is_marked;
  EXPECT_EQ(marks, result.marked_edges.size());
  for(auto e : result.marked_edges)
  {
    vertices_on_curves.insert(source(e, mesh));
    vertices_on_curves.insert(target(e, mesh));
  }

  // the parts
  result.number_of_parts = PMP::connected_components(mesh, boost::make_assoc_property_map(result.part),
                                                     CGAL::parameters::edge_is_constrained_map(result.marks()));
  EXPECT_EQ(result.number_of_parts, parts.parts.size());
  std::vector<double> areas(result.number_of_parts, 0), segmented_areas;
  for(auto f : faces(mesh))
    areas[result.part.at(f)] += CGAL::to_double(PMP::face_area(f, mesh));
  for(const SMC::Surface_part& p : parts.parts)
    segmented_areas.push_back(p.area);
  std::sort(areas.begin(), areas.end());
  std::sort(segmented_areas.begin(), segmented_areas.end());
  for(std::size_t p = 0; p < areas.size() && p < segmented_areas.size(); ++p)
    EXPECT_NEAR(areas[p], segmented_areas[p], 1e-12 * area);

  // parts without their boundaries, and the curves, make up the surface
  long total = static_cast<long>(vertices_on_curves.size()) - static_cast<long>(result.marked_edges.size());
  for(const SMC::Surface_part& p : parts.parts)
    total += 2 - 2 * static_cast<long>(p.genus) - static_cast<long>(p.number_of_boundaries);
  EXPECT_EQ(total, characteristic);

  // the parts as closed meshes
  std::vector<Mesh> meshes;
  SMC::extract_parts(mesh, result.marks(), std::back_inserter(meshes));
  EXPECT_EQ(meshes.size(), result.number_of_parts);
  std::multiset<long> characteristics, expected_characteristics;
  for(const SMC::Surface_part& p : parts.parts)
    expected_characteristics.insert(2 - 2 * static_cast<long>(p.genus));
  double sum_of_extracted = 0;
  for(const Mesh& m : meshes)
  {
    sum_of_extracted += CGAL::to_double(PMP::volume(m));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(m));
    EXPECT_TRUE(CGAL::is_triangle_mesh(m));
    EXPECT_TRUE(CGAL::is_closed(m));
    EXPECT_TRUE(!bounds_volume || PMP::does_bound_a_volume(m));
    characteristics.insert(euler_characteristic(m));
  }
  EXPECT_EQ(characteristics, expected_characteristics);
  EXPECT_NEAR(sum_of_extracted, volume, volume_tolerance);
  return result;
}

} // namespace parts_check

#endif // PARTS_CHECK_H
