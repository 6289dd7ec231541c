// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/enumerate_constrictions.h"
#include "include/geodesic_check.h"
#include "include/random_hull.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_completeness {

namespace SMC = CGAL::Surface_mesh_constrictions;
using enumerate_constrictions::Constriction;
using enumerate_constrictions::Enumeration;
using test_meshes::Mesh;
using test_meshes::Soup;

double shortest(const std::vector<Constriction>& curves)
{
  double result = std::numeric_limits<double>::infinity();
  for(const Constriction& c : curves)
    result = std::min(result, c.length());
  return result;
}

// A ring of n vertices on a circle of radius 1 between two of radius `wide` at the heights -1 and 1, closed by apexes.
Soup hourglass(int n, double wide)
{
  test_meshes::Soup_builder b;
  const auto at = [&](int i, double radius, double z) {
    const double phi = 2 * CGAL_PI * (i % n) / n;
    return test_meshes::Position{{radius * std::cos(phi), radius * std::sin(phi), z}};
  };
  for(int i = 0; i < n; ++i)
  {
    b.quad(at(i, wide, -1), at(i + 1, wide, -1), at(i + 1, 1, 0), at(i, 1, 0));
    b.quad(at(i, 1, 0), at(i + 1, 1, 0), at(i + 1, wide, 1), at(i, wide, 1));
    b.triangle(at(i + 1, wide, -1), at(i, wide, -1), {{0, 0, -2}});
    b.triangle(at(i, wide, 1), at(i + 1, wide, 1), {{0, 0, 2}});
  }
  return b.soup;
}

// The waist is a regular polygon. Other curves through its vertices go around an end, which is longer.
TEST(Enumeration, TheShortestConstrictionOfAnHourglassIsItsWaist)
{
  for(int n = 3; n <= 9; ++n)
  {
    const Mesh mesh = test_meshes::make_mesh(hourglass(n, 2));
    const double waist = 2 * n * std::sin(CGAL_PI / n);
    EXPECT_TRUE(Enumeration(mesh, 0.99 * waist).constrictions().empty());
    const Enumeration e(mesh, 1.1 * waist);
    ASSERT_EQ(e.constrictions().size(), 1u);
    EXPECT_NEAR(e.constrictions()[0].length(), waist, 1e-12);
    EXPECT_EQ(e.constrictions()[0].locations().size(), static_cast<std::size_t>(n));
  }
}

TEST(Enumeration, AConvexPolyhedronHasNoSegmentBetweenSaddles)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::random_hull(3, 40));
  const Enumeration e(mesh, 1000);
  EXPECT_EQ(e.number_of_segments(), 0u);
  EXPECT_TRUE(e.constrictions().empty());
}

// All that is enumerated is straight and turns at vertices only, by a check that shares nothing with the enumeration
// but the unfolding of a triangle.
TEST(Enumeration, WhatIsEnumeratedIsClosedGeodesics)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::jittered(test_meshes::two_holes(), 0.1, 0));
  const Enumeration e(mesh, 8);
  EXPECT_GE(e.constrictions().size(), 20u);
  for(const Constriction& c : e.constrictions())
    geodesic_check::expect_closed_geodesic(mesh, c);
}

// How many there are, and how many of them are found.
struct Share
{
  std::size_t found = 0, all = 0;

  void count(bool is_found)
  {
    found += is_found;
    ++all;
  }
  double ratio() const { return static_cast<double>(found) / static_cast<double>(all); }
};

class Completeness : public testing::Test
{
protected:
  // Compares what is detected on a mesh with all strict constrictions that are up to three times as long as the
  // shortest one.
  void compare(const std::string& name, const Soup& soup)
  {
    SCOPED_TRACE(name);
    const Mesh mesh = test_meshes::make_mesh(soup);
    std::vector<Constriction> detected, enumerated;
    SMC::detect_constrictions(mesh, std::back_inserter(detected), SMC::parameters::all_constrictions(true));
    ASSERT_FALSE(detected.empty());
    const double length = shortest(detected), max_length = 3 * length;
    const Enumeration enumeration(mesh, max_length);
    SMC::compute_prominences(mesh, enumeration.constrictions(), std::back_inserter(enumerated));
    EXPECT_NEAR(shortest(enumerated), length, 1e-9);

    std::set<Enumeration::Key> known, found;
    for(const Constriction& c : enumerated)
      known.insert(Enumeration::key(mesh, c));
    for(const Constriction& c : detected)
      if(c.length() < (1 - 1e-9) * max_length &&
         c.certificate().verdict == SMC::Certificate_verdict::STRICT_CONSTRICTION)
      {
        EXPECT_EQ(known.count(Enumeration::key(mesh, c)), 1u) << "of length " << c.length();
        found.insert(Enumeration::key(mesh, c));
      }

    Share all, prominent, short_prominent;
    for(const Constriction& c : enumerated)
    {
      const bool is_found = found.count(Enumeration::key(mesh, c)) != 0;
      all.count(is_found);
      if(c.prominence() >= 0.3)
      {
        prominent.count(is_found);
        if(c.length() <= 1.5 * length)
          short_prominent.count(is_found);
      }
    }
    // A curve that is hardly longer than the shortest one and hard to get off is two shortest paths from most of its
    // points to the opposite ones, so that the cut locus of every root on it has it.
    EXPECT_EQ(short_prominent.found, short_prominent.all);
    record(name, all, prominent);
    m_all.found += all.found;
    m_all.all += all.all;
    m_prominent.found += prominent.found;
    m_prominent.all += prominent.all;
  }

  static void record(const std::string& name, const Share& all, const Share& prominent)
  {
    const auto text = [](const Share& s) { return std::to_string(s.found) + " of " + std::to_string(s.all); };
    RecordProperty(name + "_all", text(all));
    RecordProperty(name + "_prominent", text(prominent));
  }

  Share m_all, m_prominent;
};

TEST_F(Completeness, WhatIsDetectedIsKnownAndMostOfWhatIsProminentIsDetected)
{
  const auto wavy = [](double s) { return 0.7 - 0.3 * std::cos(6 * CGAL_PI * s); };
  for(unsigned seed = 0; seed < 2; ++seed)
  {
    const std::string number = std::to_string(seed);
    compare("dumbbell_" + number, test_meshes::dumbbell(0.05, seed, 12, 10));
    compare("bumpy_" + number, test_meshes::revolution(wavy, 6, 16, 9, 0.15, seed));
    compare("torus_" + number, test_meshes::torus(0.05, seed, 14, 8));
    compare("square_ring_" + number, test_meshes::jittered(test_meshes::square_ring(), 0.1, seed));
    compare("two_holes_" + number, test_meshes::jittered(test_meshes::two_holes(), 0.1, seed));
    compare("boxes_with_tube_" + number, test_meshes::jittered(test_meshes::boxes_with_tube(3), 0.1, seed));
    compare("branches_" + number, test_meshes::jittered(test_meshes::branches(), 0.08, seed));
  }
  for(unsigned seed = 0; seed < 4; ++seed)
    compare("random_revolution_" + std::to_string(seed),
            test_meshes::revolution(
                [seed](double s) { return 0.6 + 0.35 * std::sin(5 * CGAL_PI * s + seed) * std::cos(3 * s + seed); }, 5,
                14, 10, 0.12, seed));

  record("total", m_all, m_prominent);
  // Of those that a rubber band leaves only when it is stretched by 30 percent one in ten may be missed: long ones that
  // are no two shortest paths. Of all, many are copies of each other a few faces apart, and the search does not try for
  // them.
  EXPECT_GE(m_prominent.ratio(), 0.9);
  EXPECT_GE(m_all.ratio(), 0.4);
}

} // namespace test_completeness
