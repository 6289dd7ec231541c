// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Detected_hierarchy.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <vector>

// What becomes of curves that are corrected or dropped after others have been led to them.
namespace test_detected_hierarchy {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using internal::Found_curve;
using SMC::Index;
using SMC::null_index;
using test_meshes::Soup;

const std::size_t around = 8; // vertices of a ring

// Rings of these radii and heights around the z axis, with an apex at either end. A ring between two wider ones is a
// neck. The barrier between two necks is as high as the widest ring between them; of necks of the same length that with
// the least numbers stands for all.
Soup tube(const std::vector<std::array<double, 2>>& rings)
{
  return test_meshes::revolution_of_profile(rings, rings.front()[1] - 0.2, rings.back()[1] + 0.2,
                                            static_cast<int>(around), 0, 0);
}

// The same with rings at equal distances.
Soup even_tube(const std::vector<double>& radii)
{
  std::vector<std::array<double, 2>> rings;
  for(double r : radii)
    rings.push_back({{r, 2. * static_cast<double>(rings.size())}});
  return tube(rings);
}

class Necks
{
public:
  explicit Necks(const std::vector<double>& radii) : Necks(even_tube(radii)) {}

  explicit Necks(const Soup& soup) : m_pm(test_meshes::make_progressive(soup)) {}

  // Merges a ring into another one, which gets this radius.
  void merge(std::size_t ring, std::size_t other, double radius)
  {
    for(std::size_t j = 0; j < around; ++j)
    {
      const Index kept = vertex(other, j);
      const auto p = m_pm.point(kept);
      const double scale = radius / std::hypot(p.x(), p.y());
      m_pm.append_collapse({vertex(ring, j), kept, {p.x() * scale, p.y() * scale, p.z()}});
    }
  }

  // Measures on what has become of the tube, too.
  void add_level()
  {
    m_levels.emplace_back(m_pm);
    m_pm.go_to_level(0);
  }

  // Finds the curve along a ring.
  void find(std::size_t ring)
  {
    std::vector<Index> path;
    for(std::size_t j = 0; j < around; ++j)
      path.push_back(vertex(ring, j));
    const Index c = m_network.add_curve(m_seeds.size(), path);
    m_found.push_back({c, m_network.length(c), 0, SMC::Certificate()});
    m_refined.push_back({internal::curve_of_arcs(arcs_of_curve(m_network, c)), {m_seeds.size()}, false});
    m_seeds.push_back({0, path, SMC::Seed_origin::USER});
  }

  // What is done with a curve along a ring when it is certified: it is moved to another ring, or dropped.
  void correct(std::size_t ring, std::size_t other) { m_corrected[ring] = other; }
  void drop(std::size_t ring) { m_corrected[ring] = dropped; }

  // Closes the hierarchy; returns the number of seeds that are skipped.
  std::size_t close()
  {
    return m_hierarchy.close<CGAL::Sequential_tag>(
        m_found, m_refined, m_seeds, [this](std::vector<Found_curve>& curves) { certify(curves); }, [](std::size_t) {});
  }

  // The rings that have been certified, in this order.
  const std::vector<std::size_t>& certified() const { return m_certified; }

  // The rings that are found, in the order of their lengths.
  std::vector<std::size_t> rings() const
  {
    std::vector<std::size_t> result;
    for(const Found_curve& f : m_found)
      result.push_back(ring(f.curve));
    return result;
  }

  // What is told of a ring that is found.
  internal::Hierarchy_entry entry(std::size_t ring) const
  {
    const std::vector<std::size_t> all = rings();
    return m_hierarchy.entries(
        m_found)[static_cast<std::size_t>(std::find(all.begin(), all.end(), ring) - all.begin())];
  }

  // The ring that dominates one; `dropped` if none does.
  std::size_t dominating(std::size_t ring) const
  {
    const internal::Hierarchy_entry e = entry(ring);
    return e.dominated_by ? rings()[*e.dominated_by] : dropped;
  }

  static constexpr std::size_t dropped = static_cast<std::size_t>(-1);

private:
  static Index vertex(std::size_t ring, std::size_t j) { return static_cast<Index>(ring * around + j); }

  // along which a curve runs
  std::size_t ring(Index curve) const
  {
    const std::vector<internal::Arc> arcs = arcs_of_curve(m_network, curve);
    const std::size_t result = arcs.front().from / around;
    for(const internal::Arc& a : arcs)
      EXPECT_EQ(a.from / around, result);
    return result;
  }

  void certify(std::vector<Found_curve>& curves)
  {
    std::vector<Found_curve> kept;
    for(Found_curve f : curves)
    {
      m_certified.push_back(ring(f.curve));
      const auto corrected = m_corrected.find(m_certified.back());
      if(corrected != m_corrected.end() && corrected->second == dropped)
      {
        m_network.remove(f.curve);
        continue;
      }
      if(corrected != m_corrected.end())
      {
        std::vector<internal::Arc> arcs(around);
        for(std::size_t j = 0; j < around; ++j)
        {
          arcs[j].from = vertex(corrected->second, j);
          arcs[j].to = vertex(corrected->second, (j + 1) % around);
          arcs[j].along = m_pm.halfedge(arcs[j].from, arcs[j].to);
          measure(m_pm, arcs[j]);
        }
        m_network.set_arcs(f.curve, arcs);
        f.length = m_network.length(f.curve);
      }
      kept.push_back(f);
    }
    curves.swap(kept);
  }

  SMC::Progressive_mesh m_pm;
  internal::Curve_network m_network{m_pm, false};
  std::deque<internal::Measuring_level> m_levels;
  internal::Surface_sides m_sides{m_pm};
  internal::Detected_hierarchy m_hierarchy{m_pm, m_levels, m_sides, m_network};
  std::vector<Found_curve> m_found;
  std::vector<SMC::Refined_curve> m_refined;
  std::vector<SMC::Seed_curve> m_seeds;
  std::map<std::size_t, std::size_t> m_corrected;
  std::vector<std::size_t> m_certified;
};

// The necks of radius 0.5, 0.4 and 0.3, each of which slides to the next one.
const std::vector<double> three_necks = {0.2, 1, 0.5, 0.6, 0.4, 0.7, 0.3, 1, 0.2};

TEST(DetectedHierarchy, EachNeckSlidesToTheNext)
{
  Necks n(three_necks);
  n.find(2);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{6, 4, 2}));
  EXPECT_EQ(n.certified(), (std::vector<std::size_t>{4, 6}));
  EXPECT_EQ(n.dominating(2), 4u);
  EXPECT_EQ(n.dominating(4), 6u);
  EXPECT_EQ(n.dominating(6), Necks::dropped);
  EXPECT_NE(n.entry(6).slides_off, null_index);
  EXPECT_NEAR(n.entry(2).prominence, 0.6 / 0.5 - 1, 0.02);
  EXPECT_NEAR(n.entry(4).prominence, 0.7 / 0.4 - 1, 0.02);
  EXPECT_NEAR(n.entry(6).prominence, 1 / 0.3 - 1, 0.02);
}

// The first neck and the second one are twins, which correction makes one. It has the higher of both barriers.
TEST(DetectedHierarchy, ACurveWhoseEndIsCorrectedToItselfGoesOnFromThere)
{
  Necks n(three_necks);
  n.find(2);
  n.correct(4, 2);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{6, 2}));
  EXPECT_EQ(n.certified(), (std::vector<std::size_t>{4, 6}));
  EXPECT_EQ(n.dominating(2), 6u);
  EXPECT_NEAR(n.entry(2).prominence, 0.7 / 0.4 - 1, 0.02);
}

// As the second neck slides off, that the first one does so, too, has to be measured.
TEST(DetectedHierarchy, ACurveWhoseOnlyEndIsCorrectedToItselfIsMeasuredWithoutTies)
{
  Necks n({0.2, 1, 0.4, 0.6, 0.4, 1, 0.2});
  n.find(4);
  n.correct(2, 4);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{4}));
  EXPECT_EQ(n.certified(), (std::vector<std::size_t>{2}));
  EXPECT_EQ(n.dominating(4), Necks::dropped);
  EXPECT_NE(n.entry(4).slides_off, null_index);
  EXPECT_NEAR(n.entry(4).prominence, 1 / 0.4 - 1, 0.02);
}

// Five equal necks. The third one slides to the second one, and that to the first one. Correction moves these to the
// other side of the third one, so that it stands for all.
TEST(DetectedHierarchy, OfCurvesOfTheSameLengthThatSlideToEachOtherTheFirstTakesTheOthers)
{
  Necks n({0.2, 1, 0.4, 0.6, 0.4, 0.7, 0.4, 0.8, 0.4, 0.9, 0.4, 1, 0.2});
  n.find(6);
  n.correct(4, 8);
  n.correct(2, 10);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{6, 8, 10}));
  EXPECT_EQ(n.dominating(6), Necks::dropped);
  EXPECT_NE(n.entry(6).slides_off, null_index);
  EXPECT_NEAR(n.entry(6).prominence, 1 / 0.4 - 1, 0.03);
  EXPECT_EQ(n.dominating(8), 6u);
  EXPECT_NEAR(n.entry(8).prominence, 0.7 / 0.4 - 1, 0.02);
  EXPECT_EQ(n.dominating(10), Necks::dropped);
  EXPECT_NE(n.entry(10).slides_off, null_index);
}

// A radius of nearly 0.4. Lengths count as equal if this number differs by less than 1.
double nearly(double number) { return 0.4 * (1 + number * 1e-9); }

// Three necks of which the last one slides to the second one, as that stands for both, this to the first one likewise,
// and the first one to the last one, which is shorter.
const std::vector<double> ring_of_necks = {0.2, 1, nearly(1.4), 0.45, nearly(0.7), 0.45, nearly(0), 0.6, 0.5, 1, 0.2};

TEST(DetectedHierarchy, AWayThatComesBackToWhatWasDroppedEnds)
{
  Necks n(ring_of_necks);
  n.find(8);
  for(std::size_t ring : {2, 4, 6})
    n.drop(ring);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{8}));
  EXPECT_EQ(n.certified(), (std::vector<std::size_t>{6, 4, 2, 6}));
  EXPECT_EQ(n.dominating(8), Necks::dropped);
  EXPECT_NE(n.entry(8).slides_off, null_index);
  EXPECT_NEAR(n.entry(8).prominence, 0.6 / 0.5 - 1, 0.02);
}

// Beside each of the three necks there is a wider one that slides to it.
TEST(DetectedHierarchy, WaysAlongARingOfCurvesThatAreDroppedAtOnceEnd)
{
  const std::vector<double> radii = {0.2,         1,   0.5, 0.55, nearly(1.4), 0.6, 0.5, 0.55,
                                     nearly(0.7), 0.6, 0.5, 0.55, nearly(0),   1,   0.2};
  Necks n(radii);
  for(std::size_t ring : {2, 6, 10})
    n.find(ring);
  for(std::size_t ring : {4, 8, 12})
    n.drop(ring);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{2, 6, 10}));
  EXPECT_EQ(n.certified().size(), 3u);
  for(std::size_t ring : {2, 6, 10})
  {
    EXPECT_EQ(n.dominating(ring), Necks::dropped);
    EXPECT_TRUE(n.entry(ring).has_end);
    EXPECT_NEAR(n.entry(ring).prominence, 0.55 / 0.5 - 1, 0.02);
  }
}

// From the neck of radius 0.5 the way goes to ring 8, to ring 6, to ring 4, to ring 2, and from there back to ring 8. Of
// these, 8 and 4 hardly hold. Of both the first one stands for all.
TEST(DetectedHierarchy, OfSkippedCurvesThatFormARingTheFirstOneIsMeasuredWithoutTies)
{
  Necks n({0.2, 1, nearly(1.2), 0.401, nearly(0.8), 0.45, nearly(0.5), 0.401, nearly(0), 0.6, 0.5, 1, 0.2});
  n.find(10);
  n.drop(6);
  n.drop(2);
  EXPECT_EQ(n.close(), 2u); // two slide to ring 8
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{4, 10}));
  EXPECT_EQ(n.certified(), (std::vector<std::size_t>{6, 2, 4}));
  EXPECT_EQ(n.dominating(10), 4u);
  EXPECT_EQ(n.dominating(4), Necks::dropped);
  EXPECT_NE(n.entry(4).slides_off, null_index);
}

// Two necks beside each other become one on a level, where the bulge between them is missing. The shorter one keeps
// what is measured there, and of the other one it is told what parts them on the input. Of a neck that is alone at its
// place the bulge beside it, which is wider on the level, is measured there.
TEST(DetectedHierarchy, CurvesThatBecomeOneOnALevelArePartedOnTheInput)
{
  Necks n(tube({{{0.2, 0}},
                {{1, 2}},
                {{0.4, 4}},
                {{0.412, 4.03}},
                {{0.4008, 4.06}},
                {{0.8, 6}},
                {{0.5, 8}},
                {{0.515, 9}},
                {{0.515, 9.2}},
                {{0.45, 10}},
                {{1, 12}},
                {{0.2, 14}}}));
  for(std::size_t ring : {3, 2})
    n.merge(ring, 4, 0.4008);
  n.merge(8, 7, 0.55);
  n.add_level();
  for(std::size_t ring : {4, 2, 6, 9})
    n.find(ring);
  EXPECT_EQ(n.close(), 0u);
  EXPECT_EQ(n.rings(), (std::vector<std::size_t>{2, 4, 9, 6}));
  EXPECT_NEAR(n.entry(2).prominence, 1 / 0.4 - 1, 0.03);
  EXPECT_NEAR(n.entry(4).prominence, 0.412 / 0.4008 - 1, 0.002);
  EXPECT_EQ(n.dominating(4), 2u);
  EXPECT_NEAR(n.entry(6).prominence, 0.55 / 0.5 - 1, 0.01);
  EXPECT_EQ(n.dominating(6), 9u);
}

} // namespace test_detected_hierarchy
