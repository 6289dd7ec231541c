// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Collapse_passes.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Face_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Plane_quadric.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify_in_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace test_collapse_passes {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::internal::Collapse_passes;
using SMC::internal::Corner_table;
using test_meshes::Soup;
typedef test_meshes::Kernel::Point_3 Point;
typedef test_meshes::Kernel::Vector_3 Vector;

constexpr std::size_t to_the_end = std::numeric_limits<std::size_t>::max() / 2;

SMC::internal::Imported_mesh<test_meshes::Mesh> imported(const test_meshes::Mesh& mesh)
{
  return {mesh, mesh.points(), get(boost::vertex_index, mesh)};
}

SMC::Progressive_mesh progressive(const Soup& soup)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
  auto input = imported(mesh);
  return SMC::Progressive_mesh(std::move(input.table), std::move(input.points));
}

// A closed surface after passes; all of its vertices are inside.
struct Simplified
{
  Corner_table table;
  std::vector<Point> points;
  SMC::Collapse_record record;

  explicit Simplified(const Soup& soup, std::size_t collapses = to_the_end)
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    const auto input = imported(mesh);
    table = input.table;
    points = input.points;
    std::vector<Index> names(points.size());
    std::iota(names.begin(), names.end(), Index(0));
    Collapse_passes(table, points, points.size(), names, true, record).run(collapses);
  }

  std::size_t number_of_faces() const
  {
    std::size_t result = 0;
    for(Index f = 0; f < table.halfedges.size() / 3; ++f)
      result += !Collapse_passes::is_out(table, f);
    return result;
  }
};

std::vector<Soup> closed_soups()
{
  std::vector<Soup> result = {test_meshes::tetrahedron(), test_meshes::two_holes(), test_meshes::boxes_with_tube(6),
                              test_meshes::joined(test_meshes::dumbbell(0.05, 4), test_meshes::torus(0.1, 5), 30)};
  for(unsigned seed = 1; seed <= 5; ++seed)
  {
    result.push_back(test_meshes::torus(0.05 * seed, seed));
    result.push_back(test_meshes::relabelled(test_meshes::chain_of_necks(0.05 * seed, seed), seed));
    result.push_back(test_meshes::jittered(test_meshes::branches(2), 0.05 * seed, seed));
  }
  return result;
}

Vector normal(const Point& p, const Point& a, const Point& b) { return CGAL::cross_product(a - p, b - p); }

// Whether the collapse of an edge, whose ends share two neighbours, keeps the surface a 2-manifold.
bool is_link_condition_met(const SMC::Progressive_mesh& pm, Index h)
{
  std::set<Index> neighbours;
  Index k = h;
  do
  {
    neighbours.insert(pm.target(k));
    k = pm.ccw(k);
  } while(k != h);
  std::size_t common = 0, degree = 0;
  const Index begin = k = pm.opposite(h);
  do
  {
    common += neighbours.count(pm.target(k));
    ++degree;
    k = pm.ccw(k);
  } while(k != begin);
  return common == 2 && neighbours.size() + degree > 6;
}

// How many faces around v, but for those of the edge to `other`, turn over when v moves to p.
std::size_t faces_turned(const SMC::Progressive_mesh& pm, Index v, Index other, const Point& p)
{
  std::size_t result = 0;
  const Index begin = pm.outgoing(v);
  Index h = begin;
  do
  {
    const Index a = pm.target(h), b = pm.target(pm.ccw(h));
    if(a != other && b != other)
    {
      const Vector before = normal(pm.point(v), pm.point(a), pm.point(b));
      result += before != CGAL::NULL_VECTOR && !(before * normal(p, pm.point(a), pm.point(b)) > 0);
    }
    h = pm.ccw(h);
  } while(h != begin);
  return result;
}

// Appends each collapse if it may be made.
void expect_valid(SMC::Progressive_mesh& pm, const std::vector<SMC::Edge_collapse>& collapses)
{
  for(const SMC::Edge_collapse& c : collapses)
  {
    ASSERT_TRUE(pm.is_vertex(c.kept));
    ASSERT_TRUE(pm.is_vertex(c.removed));
    const Index h = pm.halfedge(c.removed, c.kept);
    ASSERT_NE(h, SMC::null_index);
    ASSERT_TRUE(is_link_condition_met(pm, h));
    EXPECT_EQ(faces_turned(pm, c.removed, c.kept, c.point), 0u);
    EXPECT_EQ(faces_turned(pm, c.kept, c.removed, c.point), 0u);
    pm.append_collapse(c);
  }
}

TEST(CollapsePasses, AProgressiveMeshFollowsTheRecord)
{
  for(const Soup& soup : closed_soups())
  {
    SMC::Progressive_mesh pm = progressive(soup);
    for(std::size_t collapses : {std::size_t(0), std::size_t(1), soup.points.size() / 2, to_the_end})
    {
      const Simplified s(soup, collapses);
      EXPECT_LE(s.record.collapses.size(), collapses);
      pm = progressive(soup);
      expect_valid(pm, s.record.collapses);
      for(Index f = 0; f < pm.number_of_face_ids(); ++f)
      {
        ASSERT_EQ(pm.is_face(f), !Collapse_passes::is_out(s.table, f));
        for(Index h = 3 * f; pm.is_face(f) && h < 3 * f + 3; ++h)
        {
          EXPECT_EQ(s.table.halfedges[h].source, pm.source(h));
          EXPECT_EQ(s.table.halfedges[h].opposite, pm.opposite(h));
          EXPECT_EQ(s.points[pm.source(h)], pm.point(pm.source(h)));
        }
      }
    }
  }
}

TEST(CollapsePasses, AsManyCollapsesAreMadeAsAreAskedForIfSoManyMayBeMade)
{
  const Soup torus = test_meshes::torus(0.1, 1);
  for(std::size_t n : {1, 2, 10, 100, 200})
    EXPECT_EQ(Simplified(torus, n).record.collapses.size(), n);
  EXPECT_GT(Simplified(torus).record.collapses.size(), torus.points.size() * 9 / 10);
  EXPECT_EQ(Simplified(test_meshes::tetrahedron()).record.collapses.size(), 0u);
}

// The value of the quadric of an edge at its best point.
double cost(const std::vector<SMC::internal::Plane_quadric>& quadrics, const std::vector<Point>& points, Index u,
            Index v)
{
  const auto homogeneous = [&points](Index i) {
    return SMC::internal::Homogeneous{{points[i].x(), points[i].y(), points[i].z(), 1}};
  };
  SMC::internal::Plane_quadric q = quadrics[u];
  q += quadrics[v];
  SMC::internal::Homogeneous p = q.best_point(homogeneous(u), homogeneous(v));
  const double w = p[3];
  for(double& x : p)
    x /= w;
  return q(p, p);
}

// On bodies where the cheapest collapse may be made: no neck is thin.
TEST(CollapsePasses, TheCheapestEdgeIsCollapsedFirst)
{
  for(unsigned seed = 1; seed <= 10; ++seed)
  {
    const Soup soup = test_meshes::torus(0.02, seed);
    const Simplified s(soup, 1);
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    const auto input = imported(mesh);
    std::vector<SMC::internal::Plane_quadric> quadrics(input.points.size());
    const auto point = [&input](Index h) -> const Point& { return input.points[input.table.halfedges[h].source]; };
    for(Index h = 0; h < input.table.halfedges.size(); h += 3)
    {
      const Vector n = normal(point(h), point(h + 1), point(h + 2)) /
                       std::sqrt(normal(point(h), point(h + 1), point(h + 2)).squared_length());
      for(Index i = h; i < h + 3; ++i)
        quadrics[input.table.halfedges[i].source] +=
            SMC::internal::Plane_quadric(n.x(), n.y(), n.z(), -(n * (point(h) - CGAL::ORIGIN)));
    }
    for(std::size_t v = 0; v < quadrics.size(); ++v)
      for(int i = 0; i < 3; ++i)
        quadrics[v] += Collapse_passes::weight_of_place *
                       SMC::internal::Plane_quadric(i == 0, i == 1, i == 2, -input.points[v][i]);
    double least = std::numeric_limits<double>::max();
    for(Index h = 0; h < input.table.halfedges.size(); ++h)
      least = (std::min)(least, cost(quadrics, input.points, input.table.halfedges[h].source,
                                     input.table.halfedges[Corner_table::next(h)].source));
    ASSERT_EQ(s.record.collapses.size(), 1u);
    EXPECT_NEAR(cost(quadrics, input.points, s.record.collapses[0].removed, s.record.collapses[0].kept), least,
                1e-5 * least);
  }
}

// An hourglass of three rings of three vertices, the second of which is its thin neck, and two tips. What is cheapest is
// to make the neck thinner.
Soup hourglass()
{
  Soup soup;
  for(int ring = 0; ring < 3; ++ring)
    for(int i = 0; i < 3; ++i)
    {
      const double radius = ring == 1 ? 0.1 : 10, phi = 2 * CGAL_PI * i / 3;
      soup.points.push_back({{radius * std::cos(phi), radius * std::sin(phi), 10.0 * ring}});
    }
  soup.points.push_back({{0, 0, -5}});
  soup.points.push_back({{0, 0, 25}});
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t k = (i + 1) % 3;
    soup.faces.push_back({{k, i, 9}});
    for(std::size_t ring : {0, 3})
    {
      soup.faces.push_back({{ring + i, ring + k, ring + 3 + i}});
      soup.faces.push_back({{ring + k, ring + 3 + k, ring + 3 + i}});
    }
    soup.faces.push_back({{6 + i, 6 + k, 10}});
  }
  return soup;
}

TEST(CollapsePasses, ANonFaceTriangleIsNotedOnceWhereACollapseIsRefused)
{
  const Simplified s(hourglass(), 1);
  ASSERT_EQ(s.record.refused_seeds.size(), 1u);
  EXPECT_EQ(s.record.refused_seeds[0].vertices, (std::vector<Index>{3, 4, 5}));
  EXPECT_EQ(s.record.refused_seeds[0].level, 0u);
  EXPECT_EQ(s.record.refused_seeds[0].origin, SMC::Seed_origin::NON_FACE_TRIANGLE);
}

TEST(CollapsePasses, RefusedSeedsAreNonFaceTrianglesOfTheirLevels)
{
  std::size_t seeds = 0;
  for(const Soup& soup : closed_soups())
  {
    const Simplified s(soup);
    SMC::Progressive_mesh pm = progressive(soup);
    pm.append_collapses(s.record.collapses, [](const SMC::Edge_collapse&) { return true; });
    std::set<std::vector<Index>> known;
    seeds += s.record.refused_seeds.size();
    for(const SMC::Seed_curve& seed : s.record.refused_seeds)
    {
      EXPECT_TRUE(known.insert(seed.vertices).second);
      pm.go_to_level(seed.level);
      ASSERT_EQ(seed.vertices.size(), 3u);
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Index h = pm.halfedge(seed.vertices[i], seed.vertices[(i + 1) % 3]);
        ASSERT_NE(h, SMC::null_index);
        EXPECT_NE(pm.target(pm.next(h)), seed.vertices[(i + 2) % 3]);
        EXPECT_NE(pm.target(pm.next(pm.opposite(h))), seed.vertices[(i + 2) % 3]);
      }
    }
  }
  EXPECT_GE(seeds, 20u);
}

// The area of a face, as a share of that of an equilateral triangle with its longest edge.
double share_of_equilateral(const Simplified& s, Index f)
{
  std::array<Point, 3> p;
  for(Index i = 0; i < 3; ++i)
    p[i] = s.points[s.table.halfedges[3 * f + i].source];
  const double longest = (std::max)(
      {CGAL::squared_distance(p[0], p[1]), CGAL::squared_distance(p[1], p[2]), CGAL::squared_distance(p[2], p[0])});
  return 2 * std::sqrt(normal(p[0], p[1], p[2]).squared_length() / 3) / longest;
}

double area(const Corner_table& table, const std::vector<Point>& points)
{
  double result = 0;
  for(Index h = 0; h < table.halfedges.size(); h += 3)
    if(!Collapse_passes::is_out(table, h / 3))
      result += std::sqrt(normal(points[table.halfedges[h].source], points[table.halfedges[h + 1].source],
                                 points[table.halfedges[h + 2].source])
                              .squared_length()) /
                2;
  return result;
}

// Nearly nothing is lost by as many collapses as there are vertices in flat regions, and what is left is evenly spread
// over them: no face is much longer than wide.
TEST(CollapsePasses, AFlatBodyKeepsItsShape)
{
  const Soup box = test_meshes::box(24, 20, 16);
  const Simplified s(box, box.points.size() - 100);
  EXPECT_EQ(s.record.collapses.size(), box.points.size() - 100);
  EXPECT_NEAR(area(s.table, s.points), 2.0 * (24 * 20 + 24 * 16 + 20 * 16), 0.01);
  double sum = 0;
  for(Index f = 0; f < s.table.halfedges.size() / 3; ++f)
    if(!Collapse_passes::is_out(s.table, f))
      sum += share_of_equilateral(s, f);
  EXPECT_GT(sum / static_cast<double>(s.number_of_faces()), 0.5);
}

// Faces without an area have no normal to keep.
TEST(CollapsePasses, FacesWithoutAnAreaDoNotStayInTheWay)
{
  Soup soup = test_meshes::box(6, 6, 6);
  const std::size_t faces = soup.faces.size();
  for(std::size_t f = 0; f < faces; f += 7) // a vertex in the middle of an edge makes two such faces
  {
    const test_meshes::Triangle t = soup.faces[f];
    const auto is_other = [&t](const test_meshes::Triangle& u) {
      return std::count(u.begin(), u.end(), t[0]) != 0 && std::count(u.begin(), u.end(), t[1]) != 0 && u != t;
    };
    const auto other = std::find_if(soup.faces.begin(), soup.faces.end(), is_other);
    const std::size_t apex = (*other)[0] + (*other)[1] + (*other)[2] - t[0] - t[1], middle = soup.points.size();
    test_meshes::Position p;
    for(std::size_t i = 0; i < 3; ++i)
      p[i] = (soup.points[t[0]][i] + soup.points[t[1]][i]) / 2;
    soup.points.push_back(p);
    soup.points.push_back(p);
    for(std::size_t i = 0; i < 3; ++i)
      soup.points.back()[i] = (p[i] + soup.points[t[0]][i]) / 2;
    const std::size_t beside = middle + 1; // between t[0] and the middle, on the same edge
    soup.faces[f] = {{middle, t[1], t[2]}};
    *other = {{t[1], middle, apex}};
    soup.faces.push_back({{t[0], middle, t[2]}});
    soup.faces.push_back({{middle, beside, apex}});
    soup.faces.push_back({{beside, t[0], apex}});
    soup.faces.push_back({{t[0], beside, middle}}); // without an area
  }
  SMC::Progressive_mesh pm = progressive(soup);
  const Simplified s(soup, soup.points.size() - 60);
  EXPECT_EQ(s.record.collapses.size(), soup.points.size() - 60);
  expect_valid(pm, s.record.collapses);
  for(Index h = 0; h < s.table.halfedges.size(); ++h)
  {
    const Index u = s.table.halfedges[h].source, v = s.table.halfedges[Corner_table::next(h)].source;
    EXPECT_TRUE(Collapse_passes::is_out(s.table, h / 3) || s.points[u] != s.points[v]);
  }
}

// Costs grow with the square of lengths, far beyond what a float can hold.
TEST(CollapsePasses, TheUnitOfLengthDoesNotMatter)
{
  const Soup soup = test_meshes::torus(0.1, 3);
  const Simplified one(soup);
  for(int exponent : {-64, 64})
  {
    const double unit = std::ldexp(1, exponent);
    const Simplified other(test_meshes::scaled(soup, unit));
    ASSERT_EQ(other.record.collapses.size(), one.record.collapses.size());
    for(std::size_t i = 0; i < one.record.collapses.size(); ++i)
    {
      const SMC::Edge_collapse &a = one.record.collapses[i], &b = other.record.collapses[i];
      EXPECT_EQ(b.removed, a.removed);
      EXPECT_EQ(b.kept, a.kept);
      EXPECT_EQ(b.point, CGAL::ORIGIN + unit * (a.point - CGAL::ORIGIN));
    }
  }
}

// The blocks of closed surfaces and of such with holes.
TEST(CollapsePasses, TheBorderOfABlockStaysAsItIs)
{
  std::size_t collapses = 0;
  for(unsigned seed = 1; seed <= 6; ++seed)
  {
    const Soup torus = test_meshes::relabelled(test_meshes::torus(0.1, seed), seed);
    const test_meshes::Mesh mesh =
        test_meshes::make_mesh(seed % 2 == 0 ? torus : open_meshes::with_random_holes(torus, seed, seed));
    const auto input = imported(mesh);
    SMC::internal::Surface_in_blocks whole;
    whole.table = input.table;
    whole.points = input.points;
    whole.faces.resize(input.number_of_faces());
    std::iota(whole.faces.begin(), whole.faces.end(), Index(0));
    const SMC::internal::Halved_faces halved(whole.table, whole.points, whole.faces, 150);
    const SMC::internal::Face_blocks blocks(whole.table, halved.order(), halved.first());
    std::vector<Index> number(whole.points.size(), SMC::null_index);
    for(Index b = 0; b < blocks.size(); ++b)
    {
      const SMC::internal::Face_block before = make_face_block(whole, blocks, b, number);
      SMC::internal::Partial_surface after = before.surface;
      const std::size_t inside = before.number_of_vertices_inside;
      SMC::Collapse_record record;
      Collapse_passes(after.table, after.points, inside, after.vertices, false, record).run(to_the_end);
      collapses += record.collapses.size();
      EXPECT_TRUE(std::equal(before.surface.points.begin() + static_cast<std::ptrdiff_t>(inside),
                             before.surface.points.end(), after.points.begin() + static_cast<std::ptrdiff_t>(inside)));
      for(Index h = 0; h < after.table.halfedges.size(); ++h)
      {
        const Index u = before.surface.table.halfedges[h].source,
                    v = before.surface.table.halfedges[Corner_table::next(h)].source;
        if(u < inside || v < inside)
          continue;
        EXPECT_FALSE(Collapse_passes::is_out(after.table, h / 3));
        EXPECT_EQ(after.table.halfedges[h].source, u);
        EXPECT_EQ(after.table.halfedges[Corner_table::next(h)].source, v);
        EXPECT_EQ(after.table.halfedges[h].opposite, before.surface.table.halfedges[h].opposite);
      }
    }
  }
  EXPECT_GE(collapses, 500u);
}

} // namespace test_collapse_passes
