// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/open_meshes.h"
#include "include/sanitizers.h"
#include "include/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

// Branching tubes whose inlets are open, with a neck before each inlet.
namespace test_vessels {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;
using test_meshes::Position;
using test_meshes::Soup;

typedef SMC::Constriction<Mesh> Constriction;

struct Box
{
  std::array<int, 3> low, high;

  bool has_cell(int i, int j, int k) const
  {
    const std::array<int, 3> cell = {{i, j, k}};
    for(std::size_t a = 0; a < 3; ++a)
      if(cell[a] < low[a] || cell[a] >= high[a])
        return false;
    return true;
  }

  bool has_point(const Position& p, double tolerance) const
  {
    for(std::size_t a = 0; a < 3; ++a)
      if(p[a] < low[a] - tolerance || p[a] > high[a] + tolerance)
        return false;
    return true;
  }
};

// A trunk along x, 3 x 3 cells wide, with branches on both sides of it. Each branch, and each end of the trunk, is a
// tube of one cell's width and then one of 3 x 3 cells that is open at its end.
class Vessel
{
public:
  Vessel(int inlets, unsigned seed)
  {
    std::mt19937 random(seed);
    const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const int branches = inlets - 2, slots = (branches + 1) / 2 + 1 + below(2);
    m_length = 4 * slots + 12;
    add({{{4, 7, 0}}, {{m_length - 4, 10, 3}}});
    add_inlet({{{2, 8, 1}}, {{4, 9, 2}}}, {{{0, 7, 0}}, {{2, 10, 3}}}, {{{0, 7, 0}}, {{0, 10, 3}}});
    add_inlet({{{m_length - 4, 8, 1}}, {{m_length - 2, 9, 2}}}, {{{m_length - 2, 7, 0}}, {{m_length, 10, 3}}},
              {{{m_length, 7, 0}}, {{m_length, 10, 3}}});
    std::vector<int> places;
    for(int i = 0; i < 2 * slots; ++i)
      places.push_back(i);
    for(std::size_t i = places.size(); i-- > 1;)
      std::swap(places[i], places[static_cast<std::size_t>(below(static_cast<int>(i) + 1))]);
    for(int b = 0; b < branches; ++b)
    {
      const int place = places[static_cast<std::size_t>(b)], x = 6 + 4 * (place / 2);
      const int neck = 1 + below(3), length = 2 + below(2);
      if(place % 2 == 0)
        add_inlet({{{x, 10, 1}}, {{x + 1, 10 + neck, 2}}}, {{{x - 1, 10 + neck, 0}}, {{x + 2, 10 + neck + length, 3}}},
                  {{{x - 1, 10 + neck + length, 0}}, {{x + 2, 10 + neck + length, 3}}});
      else
        add_inlet({{{x, 7 - neck, 1}}, {{x + 1, 7, 2}}}, {{{x - 1, 7 - neck - length, 0}}, {{x + 2, 7 - neck, 3}}},
                  {{{x - 1, 7 - neck - length, 0}}, {{x + 2, 7 - neck - length, 3}}});
    }
  }

  // A pouch of 4 x 4 x 3 cells above the trunk, on a neck of 2 x 2 cells.
  void add_pouch()
  {
    const int x = m_length / 2 - 1;
    m_pouch_neck = {{{x, 7, 3}}, {{x + 2, 9, 4}}};
    add(m_pouch_neck);
    add({{{x - 1, 6, 4}}, {{x + 3, 10, 7}}});
  }

  Mesh mesh(double jitter, unsigned seed) const
  {
    const Soup closed = test_meshes::voxels({{m_length, 17, 8}}, [this](int i, int j, int k) {
      return std::any_of(m_boxes.begin(), m_boxes.end(), [&](const Box& b) { return b.has_cell(i, j, k); });
    });
    const Soup open = open_meshes::without_faces(closed, [&](const test_meshes::Triangle& t) {
      return std::any_of(m_openings.begin(), m_openings.end(), [&](const Box& opening) {
        return std::all_of(t.begin(), t.end(), [&](std::size_t v) { return opening.has_point(closed.points[v], 0); });
      });
    });
    return test_meshes::make_mesh(test_meshes::jittered(open, jitter, seed));
  }

  const std::vector<Box>& necks() const { return m_necks; }
  const Box& pouch_neck() const { return m_pouch_neck; }
  std::size_t number_of_openings() const { return m_openings.size(); }

private:
  void add(const Box& box) { m_boxes.push_back(box); }

  void add_inlet(const Box& neck, const Box& tube, const Box& opening)
  {
    add(neck);
    add(tube);
    m_necks.push_back(neck);
    m_openings.push_back(opening);
  }

  int m_length;
  std::vector<Box> m_boxes, m_necks, m_openings;
  Box m_pouch_neck;
};

std::vector<const Constriction*> around(const Box& neck, double jitter, const Mesh& mesh,
                                        const std::vector<Constriction>& curves)
{
  std::vector<const Constriction*> result;
  for(const Constriction& c : curves)
  {
    std::vector<Mesh::Point> points;
    c.points(mesh, std::back_inserter(points));
    if(std::all_of(points.begin(), points.end(), [&](const Mesh::Point& p) {
         return neck.has_point({{p.x(), p.y(), p.z()}}, 2 * jitter);
       }))
      result.push_back(&c);
  }
  return result;
}

TEST(Vessels, EachOf3To20InletsHasItsNeck)
{
  const double jitter = 0.05;
  const int step = sanitizers::are_on ? 8 : 1;
  for(int inlets = 3; inlets <= 20; inlets += step)
  {
    SCOPED_TRACE(inlets);
    const unsigned seed = static_cast<unsigned>(inlets);
    const Vessel vessel(inlets, seed);
    ASSERT_EQ(vessel.number_of_openings(), static_cast<std::size_t>(inlets));
    const Mesh mesh = vessel.mesh(jitter, seed);
    const std::vector<Constriction> curves = detection::detect(mesh);
    for(const Box& neck : vessel.necks())
    {
      const std::vector<const Constriction*> found = around(neck, jitter, mesh, curves);
      ASSERT_FALSE(found.empty()) << "at " << neck.low[0] << ' ' << neck.low[1] << ' ' << neck.low[2];
      EXPECT_TRUE(found[0]->certificate().is_certified());
      EXPECT_TRUE(found[0]->is_separating());
      EXPECT_FALSE(found[0]->is_rim());
      EXPECT_NEAR(found[0]->length(), 4, 0.4);
      EXPECT_GT(found[0]->prominence(), 0.5);
    }
  }
}

// As an aneurysm: nothing but the pouch is on the other side of its neck.
TEST(Vessels, APouchOnABranchingOpenTubeHasItsNeck)
{
  const double jitter = 0.05, area_of_pouch = 4 * 4 + 4 * 12 + 4 * 4 - 2 * 2;
  for(int inlets : {3, 6, 12})
  {
    SCOPED_TRACE(inlets);
    const unsigned seed = 100 + static_cast<unsigned>(inlets);
    Vessel vessel(inlets, seed);
    vessel.add_pouch();
    const Mesh mesh = vessel.mesh(jitter, seed);
    const std::vector<Constriction> curves = detection::detect(mesh);
    const std::vector<const Constriction*> found = around(vessel.pouch_neck(), jitter, mesh, curves);
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(found[0]->certificate().is_certified());
    ASSERT_TRUE(found[0]->is_separating());
    EXPECT_NEAR(found[0]->length(), 8, 0.6);
    const double area = std::min(found[0]->areas()[0], found[0]->areas()[1]);
    EXPECT_GT(area, 0.95 * area_of_pouch);
    EXPECT_LT(area, 1.05 * area_of_pouch + 8); // the tube of the neck may belong to it
    EXPECT_GT(found[0]->prominence(), 0.3);
    for(const Box& neck : vessel.necks())
      EXPECT_FALSE(around(neck, jitter, mesh, curves).empty());
  }
}

} // namespace test_vessels
