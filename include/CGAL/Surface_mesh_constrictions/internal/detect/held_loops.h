// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_LOOPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_LOOPS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Level_with_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/loops_at_vertex.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/bisect_edges.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightening_basins.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// At most so many loops of edges are tightened. The tightening of most of them ends soon, at a curve that the
// tightening of another one has passed.
constexpr std::size_t max_held_seeds = 4096;

// A loop with a smaller angle at the location runs to another part of the surface, around it, and back by nearly the
// same way.
constexpr double least_loop_angle = CGAL_PI / 4;

// On a large surface at most `max_level_seeds` loops of edges are tightened on a level; and `max_local_seeds` on each
// finer level and on the surface itself, among the `max_local_vertices` vertices around the location.
constexpr std::size_t max_level_seeds = 256, max_local_seeds = 128, max_local_vertices = 1024;

// On the first of the finer levels `max_level_vertices` vertices are looked at. On the surface itself, beside a loop,
// `max_vertices_beside` vertices are looked at, and `max_seeds_beside` loops of edges are tightened.
constexpr std::size_t max_level_vertices = 8192, max_vertices_beside = 6144, max_seeds_beside = 8;

// The location is not put into a level with more vertices than this: that would take longer than the search, and the
// vertices of such a level are near enough.
constexpr std::size_t max_vertices_with_location = 65536;

// The distance from the vertices of a loop to the place where it is held is at most half the length of the loop. Paths
// along edges are a bit longer: among equilateral triangles up to 2 / sqrt(3) times as long.
constexpr double greatest_detour = 1.2;

// A surface with fewer vertices is refined to this number before loops of edges are looked for.
constexpr std::size_t least_held_vertices = 4096;

// Translates a closed curve from a surface `fine` to the surface `coarse`, which `fine` was made from by putting
// vertices into its faces and edges. Returns arcs of `coarse`; none if the result is a point. The curve is led past
// each vertex that `coarse` does not have, on the side of the smaller angle, and pulled straight between the other
// vertices. Up to rounding it gets no longer. old_of(h) is the halfedge of `coarse` that h is a piece of, or null_index
// if h lies in a face of `coarse`. Linear in the strips of the curve.
template <class OldOf, class IsKept>
std::vector<Arc> arcs_without_vertices(const Progressive_mesh& fine, std::vector<Arc> loop, const OldOf& old_of,
                                       const IsKept& is_kept, const Progressive_mesh& coarse)
{
  const auto kept = std::find_if(loop.begin(), loop.end(), [&](const Arc& a) { return is_kept(a.from); });
  const bool keeps_none = kept == loop.end();
  std::rotate(loop.begin(), keeps_none ? loop.begin() : kept, loop.end());
  String_puller puller(coarse);
  std::vector<Arc> arcs;
  Strip strip;
  const auto append = [&](const auto& crossings) {
    for(Index h : crossings)
      if(const Index old = old_of(h); old != null_index)
        strip.push_back(old);
  };
  Index from = loop.front().from;
  for(std::size_t i = 0; i < loop.size(); ++i)
  {
    const Arc &arc = loop[i], &next = loop[(i + 1) % loop.size()];
    append(arc.crossings);
    if(is_kept(arc.to))
    {
      puller.pull(from, strip, arc.to, arcs);
      strip.clear();
      from = arc.to;
      continue;
    }
    const Side_angles angles = side_angles(fine, arc, next);
    Strip fan;
    append_fan(fine, arc, next, angles.left <= angles.right ? Curve_side::LEFT : Curve_side::RIGHT, fan);
    append(fan);
  }
  if(!keeps_none)
    return arcs;
  const Closed_strip closed(coarse, std::move(strip));
  if(closed.is_degenerate())
    return arcs;
  arcs = closed.shortest_loop(closed.foremost_corner(closed.inner_side()), puller);
  // the loop is longer because of rounding, or because the strip is so wide that it unfolds over its own centre
  if(total_length(arcs) > total_length(loop) * (1 + flat_tolerance))
    for(const Closed_strip::Corner& corner : closed.corners())
    {
      std::vector<Arc> others = closed.shortest_loop(corner, puller);
      if(total_length(others) < total_length(arcs))
        arcs = std::move(others);
    }
  return arcs;
}

// Tightens closed curves that are held at a vertex, and keeps each result once.
class Held_curves
{
public:
  // `unit` is that of the surface.
  Held_curves(const Progressive_mesh& pm, Index vertex, const Length_unit& unit)
    : m_network(pm, false), m_angles(pm), m_tightener(m_network, unit, &m_angles), m_basins(m_network, m_tightener),
      m_vertex(vertex)
  {
    m_tightener.hold(vertex);
  }

  // Tightens a curve. Cost: that of tightening it until it is equal to a curve that an earlier one has passed through.
  void insert(const std::vector<Index>& path) { insert(m_network.add_curve(0, path)); }
  void insert(std::vector<Arc> arcs)
  {
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    if(!m_network.is_empty(c))
      insert(c);
  }

  // The curves that did not shrink to the vertex, in the order in which they were found. Each starts at the vertex.
  const std::vector<std::vector<Arc>>& ends() const { return m_ends; }

private:
  void insert(Index c)
  {
    if(m_basins.tighten(c) == c)
    {
      m_ends.push_back(arcs_of_curve(m_network, c));
      std::vector<Arc>& arcs = m_ends.back();
      const auto first = std::find_if(arcs.begin(), arcs.end(), [this](const Arc& a) { return a.from == m_vertex; });
      std::rotate(arcs.begin(), first, arcs.end());
    }
    m_network.remove(c);
  }

  Curve_network m_network;
  const Corner_angles m_angles;
  Tightener m_tightener;
  Tightening_basins m_basins;
  const Index m_vertex;
  std::vector<std::vector<Arc>> m_ends;
};

// Whether a loop is simple, and its angles where it is held are at least `minimum_angle`.
inline bool is_held_loop(const Progressive_mesh& pm, const std::vector<Arc>& arcs, double minimum_angle)
{
  const Side_angles angles = side_angles(pm, arcs.back(), arcs.front());
  return (std::min)(angles.left, angles.right) >= minimum_angle && is_simple(pm, trace(pm, arcs));
}

inline void sort_by_length(std::vector<std::vector<Arc>>& loops)
{
  std::stable_sort(loops.begin(), loops.end(),
                   [](const auto& a, const auto& b) { return total_length(a) < total_length(b); });
}

// Tightens loops of edges while they are held at a vertex. Returns the results that are simple geodesic loops with at
// least the given angle at the vertex, each once, the shortest first. Each starts at the vertex. `unit` is that of the
// surface. Cost: O(n log n) for the loops of edges, plus that of `Held_curves::insert()` for each.
inline std::vector<std::vector<Arc>> held_loops(const Progressive_mesh& pm, Index vertex, double minimum_angle,
                                                const Length_unit& unit)
{
  Held_curves curves(pm, vertex, unit);
  if(pm.number_of_vertices() >= least_held_vertices)
    for(const std::vector<Index>& path : loops_at_vertex(pm, vertex, max_held_seeds))
      curves.insert(path);
  else
  {
    Bisected_surface bisected = bisect_edges(pm, least_held_vertices);
    const std::vector<Index> old = std::move(bisected.old);
    const Progressive_mesh fine(std::move(bisected.table), std::move(bisected.points));
    const Index vertices = static_cast<Index>(pm.number_of_vertex_ids() - pm.number_of_holes());
    Held_curves fine_curves(fine, vertex, Length_unit(fine));
    for(const std::vector<Index>& path : loops_at_vertex(fine, vertex, max_held_seeds))
      fine_curves.insert(path);
    for(const std::vector<Arc>& loop : fine_curves.ends())
      curves.insert(arcs_without_vertices(
          fine, loop, [&old](Index h) { return old[h]; }, [vertices](Index v) { return v < vertices; }, pm));
  }

  std::vector<std::vector<Arc>> loops;
  for(const std::vector<Arc>& arcs : curves.ends())
    if(is_held_loop(pm, arcs, minimum_angle))
      loops.push_back(arcs);
  sort_by_length(loops);
  return loops;
}

// A loop of a level may be longer than the loop that it becomes on the input: by this share, in addition to what the
// way between the two places where they are held explains.
constexpr double greatest_shrinkage = 0.1;

// If no other loop gives a result on the input, at most so many are tried that are folded or not simple on the level.
constexpr std::size_t max_doubtful_loops = 16;

// A loop that is tight on a level and held at the point of the level nearest to a location, as a path of vertices
// beside it.
struct Level_loop
{
  const Level_copy* level;
  std::vector<Index> path; // from the vertex that the location's nearest vertex of T^0 has been merged into
  double length, distance; // of the loop, and of the point from the location
};

// Finds the loops of a level at a location that come from loops of edges of about `greatest_length` at most, from at
// most `most_loops` loops of edges among at most `most_vertices` vertices. Appends those that are simple and have at
// least `minimum_angle` to `loops`, and the others to `doubtful`. `unit` is that of T^0; `nearest` is a vertex of T^0
// at the location or joined to it. Cost: that of `Loops_at_vertex` on the level, plus that of `Held_curves::insert()`
// for each loop of edges.
inline void find_loops_on_level(const Level_copy& level, const Length_unit& unit, Index nearest,
                                const Progressive_mesh::Point& location, std::size_t most_vertices,
                                std::size_t most_loops, double greatest_length, double minimum_angle,
                                std::vector<Level_loop>& loops, std::vector<Level_loop>& doubtful)
{
  const Index root = level.vertex(nearest);
  std::optional<Level_with_location> with;
  if(level.surface().number_of_vertices() <= max_vertices_with_location)
    with.emplace(level.surface(), root, location);
  const Progressive_mesh& pm = with ? with->surface() : level.surface();
  const Index vertex = with ? with->vertex() : root;
  const double distance = norm(vector(location, pm.point(vertex)));
  Held_curves curves(pm, vertex, unit);
  Loops_at_vertex around(pm, vertex, most_vertices, greatest_detour * (greatest_length / 2 + distance),
                         [](Index) { return true; });
  for(const std::vector<Index>& path : around.paths(most_loops))
    curves.insert(path);
  for(const std::vector<Arc>& arcs : curves.ends())
  {
    Level_loop loop = {&level, vertices_beside(pm, trace(pm, arcs)), total_length(arcs), distance};
    std::replace(loop.path.begin(), loop.path.end(), vertex, root);
    (is_held_loop(pm, arcs, minimum_angle) ? loops : doubtful).push_back(std::move(loop));
  }
}

// Leads loops of levels to T^0, where they are held at a vertex.
class Loops_to_input
{
public:
  // `pm` is T^0, or T^0 with `vertex` put in; `nearest` is a vertex of T^0 at `vertex` or joined to it.
  Loops_to_input(const Progressive_mesh& pm, Index vertex, Index nearest)
    : m_vertex(vertex), m_nearest(nearest), m_to_input(pm)
  {}

  // The closed path of T^0 along the loop. It starts at the vertex, which it passes once. It has fewer than three
  // vertices if there is no such path.
  std::vector<Index> operator()(const Level_loop& loop)
  {
    const Level_copy& level = *loop.level;
    const Index root = level.vertex(m_nearest);
    std::vector<Index> path;
    Index from = m_vertex, before = root; // the end of the path, and the vertex of the level that stands for it
    bool passes_root = true;
    const auto lead = [&](Index to, Index stands_for_it) {
      // a curve that passed the vertex a second time would be held there, too
      const auto is_allowed = [&](Index v) {
        if(v == m_vertex)
          return from == m_vertex || to == m_vertex;
        const Index merged = level.vertex(v);
        return merged == before || merged == stands_for_it || (passes_root && merged == root);
      };
      const bool is_led = m_to_input.append(from, to, is_allowed, path);
      from = to;
      before = stands_for_it;
      passes_root = false;
      return is_led;
    };
    for(Index v : loop.path)
      if(v == root)
        passes_root = true;
      else if(v != before && !lead(level.original(v), v))
        return {};
    if(from == m_vertex || !lead(m_vertex, root))
      return {};
    remove_spurs_inside(path);
    return path;
  }

private:
  // Removes spurs: a path may lead to the vertex that stands for a cluster of vertices, and back.
  static void remove_spurs_inside(std::vector<Index>& path)
  {
    std::size_t end = 0;
    for(Index v : path)
      if(end > 1 && path[end - 2] == v)
        --end;
      else
        path[end++] = v;
    path.resize(end);
  }

  const Index m_vertex, m_nearest;
  Paths_to_finer_level m_to_input;
};

// For each vertex of a level, whether one of the given vertices of T^0 has been merged into it or into a vertex joined
// to it. `nearest` stands for `inserted`, the vertex that has been put in. Linear in the size of the level.
inline std::vector<bool> vertices_near(const Level_copy& level, Index nearest, const std::vector<Index>& vertices,
                                       Index inserted)
{
  std::vector<bool> result(level.surface().number_of_vertex_ids(), false);
  for(Index v : vertices)
  {
    const Index u = level.vertex(v == inserted ? nearest : v), begin = level.surface().outgoing(u);
    result[u] = true;
    Index h = begin;
    do
    {
      result[level.surface().target(h)] = true;
      h = level.surface().ccw(h);
    } while(h != begin);
  }
  return result;
}

// As `held_loops()`, on a large surface `pm`: that of `prepared`, or that with `vertex` put in. Loops are looked for on
// a level. As a loop may be too small for that level, they are also looked for on the finer levels and on the surface
// itself, there around the vertex alone. The loops that are tight on a level are led to the surface, the shortest
// first, and tightened again, if they may be among the shortest. At last loops are looked for on the surface beside the
// shortest one: a loop that passes a bump on the other side may be shorter. `nearest` is a vertex of T^0 at `vertex` or
// joined to it. Returns at most `maximum_number` loops. Cost: that of `find_loops_on_level()` for each level; plus, for
// each loop that is led to the surface, that of `Paths_to_finer_level` and of tightening it.
template <class TriangleMesh, class VertexPointMap>
std::vector<std::vector<Arc>> held_loops_of_levels(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                                   const Progressive_mesh& pm, Index vertex, Index nearest,
                                                   double minimum_angle, std::size_t maximum_number)
{
  constexpr std::size_t all = (std::numeric_limits<std::size_t>::max)();
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  const Progressive_mesh::Point location = pm.point(vertex);
  std::vector<Level_loop> level_loops, doubtful;
  const Level_copy& level = prepared.searching()->of.copy;
  const auto is_shorter = [](const Level_loop& a, const Level_loop& b) { return a.length < b.length; };
  find_loops_on_level(level, prepared.length_unit(), nearest, location, all, max_level_seeds, infinity,
                      minimum_angle / 2, level_loops, doubtful);
  std::stable_sort(level_loops.begin(), level_loops.end(), is_shorter);
  std::size_t most_vertices = max_level_vertices;
  for(const Measuring_level& finer : prepared.measuring())
    if(finer.copy.surface().number_of_vertices() > 4 * level.surface().number_of_vertices())
    {
      const double greatest_length =
          level_loops.size() < maximum_number
              ? infinity
              : level_loops[maximum_number - 1].length + 2 * level_loops[maximum_number - 1].distance;
      find_loops_on_level(finer.copy, prepared.length_unit(), nearest, location, most_vertices, max_local_seeds,
                          greatest_length, minimum_angle / 2, level_loops, doubtful);
      std::stable_sort(level_loops.begin(), level_loops.end(), is_shorter);
      most_vertices = max_local_vertices;
    }
  std::stable_sort(doubtful.begin(), doubtful.end(), is_shorter);
  doubtful.resize((std::min)(doubtful.size(), max_doubtful_loops));
  const std::size_t certain = level_loops.size();
  std::move(doubtful.begin(), doubtful.end(), std::back_inserter(level_loops));

  Held_curves curves(pm, vertex, prepared.length_unit());
  std::vector<std::vector<Arc>> loops;
  const auto insert = [&](const std::vector<Index>& path) {
    const std::size_t known = curves.ends().size();
    curves.insert(path);
    if(curves.ends().size() == known || !is_held_loop(pm, curves.ends().back(), minimum_angle))
      return;
    loops.push_back(curves.ends().back());
    sort_by_length(loops);
  };
  for(const std::vector<Index>& path : Loops_at_vertex(pm, vertex, max_local_vertices).paths(max_local_seeds))
    insert(path);
  Loops_to_input to_input(pm, vertex, nearest);
  for(std::size_t i = 0; i < level_loops.size() && (i < certain || loops.empty()); ++i)
  {
    const Level_loop& loop = level_loops[i];
    if(loops.size() >= maximum_number &&
       loop.length * (1 - greatest_shrinkage) - 2 * loop.distance > total_length(loops[maximum_number - 1]))
      continue; // a longer one may be held further from the location, and shrink by more
    const std::vector<Index> path = to_input(loop);
    if(path.size() > 2)
      insert(path);
  }
  if(!loops.empty())
  {
    const std::vector<bool> is_near = vertices_near(level, nearest, vertices_beside(pm, trace(pm, loops.front())),
                                                    vertex != nearest ? vertex : null_index);
    Loops_at_vertex beside(pm, vertex, max_vertices_beside, greatest_detour * total_length(loops.front()) / 2,
                           [&](Index v) { return v == vertex || is_near[level.vertex(v)]; });
    for(const std::vector<Index>& path : beside.paths(max_seeds_beside))
      insert(path);
  }
  if(loops.size() > maximum_number)
    loops.resize(maximum_number);
  return loops;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_LOOPS_H
