// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

// Sweeps on flat surfaces from straight closed lines, where the distance is that of parallel lines.
namespace test_distance_sweep {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using internal::Distance_sweep;
using internal::Strip;
using SMC::Index;
using SMC::null_index;
using test_meshes::Soup;

const double infinity = std::numeric_limits<double>::infinity();

// A surface in the plane, with several layers, folded along edges; with the height of each vertex above the start as if
// the surface were unfolded.
struct Flat_surface
{
  Soup soup;
  std::vector<double> heights;
};

class Builder
{
public:
  // `size` of the squares of rows, whose vertices are moved by up to 0.2 of it along the sweep, and across it if
  // `moves_x`, but for those of row 0 and of the two beside it.
  Builder(unsigned seed, double size, bool moves_x) : m_random(seed), m_size(size), m_moves_x(moves_x) {}

  // The vertex of a key, at unfolded coordinates in squares; it may be moved along the axes.
  std::size_t vertex(const std::array<int, 3>& key, int i, int j, double fold_x, double fold_y, bool moves_x,
                     bool moves_y)
  {
    const auto known = m_vertices.emplace(key, surface.heights.size());
    if(known.second)
    {
      const bool is_near = std::abs(j) <= 1;
      const double dx = moves_x && m_moves_x && !is_near ? m_random.real(-0.2, 0.2) : 0;
      const double dy = (moves_y && !is_near ? m_random.real(-0.2, 0.2) : 0) * m_size;
      surface.soup.points.push_back({{std::abs(i + dx - fold_x), std::abs(j * m_size + dy - fold_y), 0}});
      surface.heights.push_back(j * m_size + dy);
      m_is_rim.push_back(key[0] == 0);
    }
    return known.first->second;
  }

  // Its corners, clockwise. They are made in this order, with every compiler.
  void quad(const std::array<std::size_t, 4>& corners)
  {
    const std::size_t d = corners[0], c = corners[1], b = corners[2], a = corners[3];
    // a diagonal between two vertices of the rim would be that of the other layer as well
    const bool is_other = m_is_rim[b] && m_is_rim[d]   ? false
                          : m_is_rim[a] && m_is_rim[c] ? true
                                                       : m_random.integer(2) == 0;
    surface.soup.faces.push_back(is_other ? test_meshes::Triangle{{a, b, d}} : test_meshes::Triangle{{a, b, c}});
    surface.soup.faces.push_back(is_other ? test_meshes::Triangle{{b, c, d}} : test_meshes::Triangle{{a, c, d}});
  }

  Flat_surface surface;

private:
  seeded_random::Random m_random;
  double m_size;
  bool m_moves_x;
  std::map<std::array<int, 3>, std::size_t> m_vertices; // the first number is that of the layer, or 0 for all
  std::vector<bool> m_is_rim;
};

// Some squares of the plane, from both sides: a front and a back that are joined along the rim.
template <class Is_inside>
Flat_surface doubled(int width, int low, int high, double size, unsigned seed, const Is_inside& is_inside,
                     bool moves_x = false)
{
  Builder b(seed, size, moves_x);
  const auto inside = [&](int i, int j) { return i >= 0 && i < width && j >= low && j < high && is_inside(i, j); };
  const auto at = [&](int layer, int i, int j) {
    const bool left = inside(i - 1, j) != inside(i, j) || inside(i - 1, j - 1) != inside(i, j - 1);
    const bool below = inside(i, j - 1) != inside(i, j) || inside(i - 1, j - 1) != inside(i - 1, j);
    return b.vertex({{left || below ? 0 : layer, i, j}}, i, j, -1000, -1000, !left, !below);
  };
  for(int i = 0; i < width; ++i)
    for(int j = low; j < high; ++j)
      if(inside(i, j))
      {
        b.quad({{at(2, i, j + 1), at(2, i + 1, j + 1), at(2, i + 1, j), at(2, i, j)}});
        b.quad({{at(1, i + 1, j), at(1, i + 1, j + 1), at(1, i, j + 1), at(1, i, j)}});
      }
  return b.surface;
}

// A torus: both directions are closed, and folded twice.
Flat_surface torus(int width, int height, double size, unsigned seed, bool moves_x = false)
{
  Builder b(seed, size, moves_x);
  const auto at = [&](int i, int j) {
    i %= 2 * width;
    const int row = j > height ? j - 2 * height : j; // from -height to height, the first of which is the last one
    const bool is_fold_x = i == 0 || i == width, is_fold_y = j % height == 0;
    return b.vertex({{1, i, j % (2 * height)}}, i, row, width, 0, !is_fold_x, !is_fold_y);
  };
  for(int i = 0; i < 2 * width; ++i)
    for(int j = 0; j < 2 * height; ++j)
      b.quad({{at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), at(i, j)}});
  return b.surface;
}

typedef std::vector<internal::Trace_point> Trace;

class Sweep
{
public:
  explicit Sweep(const Flat_surface& surface)
    : m_pm(SMC::make_progressive_mesh(test_meshes::make_mesh(surface.soup), {})), m_heights(surface.heights),
      m_lengths(m_pm), m_sweep(m_pm, m_lengths)
  {}

  // The line at a height; above it is its left side. At height 0 it runs along edges.
  Trace line(double height) const { return height == 0 ? along_row() : across(height); }

  // Whether a halfedge leads into what lies less than this far from the line on a side.
  bool leads_in(Index h, double height, std::size_t s, double distance) const
  {
    const double sign = s == 0 ? 1 : -1, from = sign * (m_heights[m_pm.source(h)] - height),
                 to = sign * (m_heights[m_pm.target(h)] - height);
    return is_short(h) && from > distance && to <= distance;
  }

  // The boundary at a level consists of curves of consecutive halfedges, and of all halfedges that lead in.
  void check_boundary(std::size_t s, std::size_t level, double height, std::size_t number_of_curves)
  {
    const double distance = m_sweep.distance_of_level(level);
    const std::vector<Strip> strips = m_sweep.boundary(s, level);
    EXPECT_EQ(strips.size(), number_of_curves);
    std::size_t size = 0;
    for(const Strip& strip : strips)
    {
      size += strip.size();
      for(std::size_t i = 0; i < strip.size(); ++i)
      {
        EXPECT_TRUE(leads_in(strip[i], height, s, distance));
        EXPECT_EQ(m_pm.face(m_pm.opposite(strip[i])), m_pm.face(strip[(i + 1) % strip.size()]));
      }
    }
    std::size_t expected = 0;
    for(Index h = 0; h < m_pm.number_of_halfedge_ids(); ++h)
      expected += leads_in(h, height, s, distance);
    EXPECT_EQ(size, expected);
  }

  const SMC::Progressive_mesh& surface() const { return m_pm; }
  Distance_sweep& sweep() { return m_sweep; }

private:
  // not one that the closed direction of a torus leads back along
  bool is_short(Index h) const { return std::abs(m_heights[m_pm.target(h)] - m_heights[m_pm.source(h)]) < 2; }

  Trace along_row() const
  {
    Index v = 0;
    while(m_heights[v] != 0)
      ++v;
    Trace result;
    do
    {
      result.push_back({v, null_index, 0});
      Index h = m_pm.outgoing(v);
      while(m_heights[m_pm.target(h)] != 0 || m_heights[m_pm.source(m_pm.prev(h))] < 0)
        h = m_pm.ccw(h);
      v = m_pm.target(h);
    } while(v != result.front().pivot);
    return result;
  }

  Trace across(double height) const
  {
    const auto is_crossed = [&](Index h) { return leads_in(m_pm.opposite(h), height, 0, 0); };
    Index h = 0;
    while(!is_crossed(h))
      ++h;
    Trace result;
    do
    {
      const double from = m_heights[m_pm.source(h)], to = m_heights[m_pm.target(h)];
      result.push_back({null_index, h, (height - from) / (to - from)});
      const Index o = m_pm.opposite(h);
      h = is_crossed(m_pm.next(o)) ? m_pm.next(o) : m_pm.prev(o);
    } while(h != result.front().halfedge);
    return result;
  }

  SMC::Progressive_mesh m_pm;
  std::vector<double> m_heights;
  internal::Edge_lengths m_lengths;
  Distance_sweep m_sweep;
};

const double size = 0.5; // of the squares, along the direction of the sweeps

TEST(DistanceSweep, OnBothSidesOfAFlatTubeLevelsAreAsLongAsTheStart)
{
  for(unsigned seed = 0; seed < 5; ++seed)
    for(double height : {0., 0.3 * size})
    {
      Sweep s(doubled(4, -6, 8, size, seed, [](int, int) { return true; }));
      s.sweep().start(s.line(height), 8, false);
      for(std::size_t side = 0; side < 2; ++side)
      {
        EXPECT_TRUE(s.sweep().can_leave(side));
        const double end = side == 0 ? 8 * size - height : 6 * size + height;
        double length = s.sweep().advance(side);
        std::size_t level = 1;
        for(; s.sweep().distance(side) < end - 1e-9; ++level)
        {
          EXPECT_EQ(s.sweep().level(side), level);
          EXPECT_FALSE(s.sweep().is_used_up(side));
          EXPECT_NEAR(length, 8, 1e-9) << s.sweep().distance(side);
          s.check_boundary(side, level, height, 1);
          const std::vector<double> curves = s.sweep().curve_lengths(side, level, length);
          ASSERT_EQ(curves.size(), 1u);
          EXPECT_NEAR(curves[0], 8, 1e-9);
          length = s.sweep().advance(side);
        }
        EXPECT_GT(level, 50u);
        length = s.sweep().advance(side);
        EXPECT_TRUE(s.sweep().is_used_up(side));
        EXPECT_NEAR(length, 0, 1e-9);
        EXPECT_TRUE(s.sweep().boundary(side, level + 1).empty());
        s.check_boundary(side, level / 2, height, 1);
      }
    }
}

// A square beside the start is a hole, a third of whose rim is part of the start. The rest of the rim is swept from both
// sides; what has been swept, or what has not, is part of the boundary, whichever is shorter.
TEST(DistanceSweep, WhereTheStartRunsAlongAHoleThisPartOfItsRimIsSwept)
{
  for(std::size_t side = 0; side < 2; ++side)
  {
    const int rows = 6;
    Flat_surface surface = doubled(4, -rows, rows, size, 0, [](int, int) { return true; });
    // each square has four faces, two of which are on the back
    const std::ptrdiff_t square = 1 * 2 * rows + rows - static_cast<std::ptrdiff_t>(side);
    surface.soup.faces.erase(surface.soup.faces.begin() + 4 * square + 2, surface.soup.faces.begin() + 4 * square + 4);
    surface.heights.push_back(side == 0 ? infinity : -infinity); // of the ghost that closes the hole
    Sweep s(surface);
    s.sweep().start(s.line(0), 8, false);
    for(double length = s.sweep().advance(side); s.sweep().distance(side) < size; length = s.sweep().advance(side))
    {
      const double swept = 1 + 2 * s.sweep().distance(side);
      EXPECT_NEAR(length, 7 + (std::min)(swept, 2 + 2 * size - swept), 1e-9) << s.sweep().distance(side);
    }
  }
}

// Above the first squares are two tubes, of length 4 and 6 around.
TEST(DistanceSweep, BehindABranchTheBoundaryConsistsOfTwoCurves)
{
  const int branch = 3;
  for(unsigned seed = 0; seed < 5; ++seed)
  {
    Sweep s(doubled(7, -2, 8, size, seed, [](int i, int j) { return j < branch || i < 2 || i > 3; }));
    s.sweep().start(s.line(0), 14, false);
    for(double length = s.sweep().advance(0); s.sweep().distance(0) < 8 * size; length = s.sweep().advance(0))
    {
      const bool is_behind = s.sweep().distance(0) > branch * size;
      EXPECT_NEAR(length, is_behind ? 10 : 14, 1e-9);
      s.check_boundary(0, s.sweep().level(0), 0, is_behind ? 2 : 1);
      std::vector<double> curves = s.sweep().curve_lengths(0, s.sweep().level(0), length);
      std::sort(curves.begin(), curves.end());
      ASSERT_EQ(curves.size(), is_behind ? 2u : 1u);
      EXPECT_NEAR(curves[0], is_behind ? 4 : 14, 1e-9);
      EXPECT_NEAR(curves.back(), is_behind ? 6 : 14, 1e-9);
    }
  }
}

// Behind the line where they meet, the boundary stays there.
TEST(DistanceSweep, TheSidesOfAMeridianMeetHalfwayAroundATorus)
{
  const int rows = 12;
  for(unsigned seed = 0; seed < 5; ++seed)
    for(double height : {0., 0.3 * size})
    {
      Sweep s(torus(3, rows / 2, size, seed));
      s.sweep().start(s.line(height), 6, true);
      const double end = rows / 2 * size;
      while(s.sweep().distance(0) < (height == 0 ? end - 0.05 : end + 0.5)) // that line must not run along edges
        for(std::size_t side = 0; side < 2; ++side)
        {
          EXPECT_NEAR(s.sweep().advance(side), 6, 1e-9) << s.sweep().distance(side);
          if(s.sweep().distance(side) < end - 2 * size)
          {
            EXPECT_EQ(s.sweep().meeting_distance(), infinity);
            s.check_boundary(side, s.sweep().level(side), height, 1);
          }
        }
      EXPECT_LT(s.sweep().meeting_distance(), end);
      EXPECT_GT(s.sweep().meeting_distance(), end - 2 * size);
    }
}

// Fast marching finds them but for the error of what has gone over edges.
TEST(DistanceFront, DistancesOfAFlatTubeAreThoseOfParallelLines)
{
  for(unsigned seed = 0; seed < 5; ++seed)
    for(double height : {0., 0.3 * size})
    {
      const Flat_surface surface = doubled(
          4, -6, 8, size, seed, [](int, int) { return true; }, true);
      Sweep s(surface);
      const internal::Edge_lengths lengths(s.surface());
      internal::Distance_front front(s.surface(), lengths);
      internal::Front_start left, right;
      front.restart();
      internal::start_front(s.surface(), s.line(height), front, left, right);
      for(std::size_t side = 0; side < 2; ++side)
      {
        const double sign = side == 0 ? 1 : -1;
        double before = 0, error = 0;
        std::size_t number = 0;
        for(Index v = front.settle_next(side); v != null_index; v = front.settle_next(side))
        {
          const double expected = sign * (surface.heights[v] - height);
          EXPECT_GE(front.distance(v, side), expected - 1e-9);
          EXPECT_GE(front.distance(v, side), before);
          EXPECT_EQ(front.reached(side), front.distance(v, side));
          error = (std::max)(error, front.distance(v, side) - expected);
          before = front.distance(v, side);
          ++number;
        }
        EXPECT_LT(error, 0.15);
        EXPECT_EQ(number, static_cast<std::size_t>(std::count_if(surface.heights.begin(), surface.heights.end(),
                                                                 [&](double h) { return sign * (h - height) > 0; })));
      }
    }
}

} // namespace test_distance_sweep
