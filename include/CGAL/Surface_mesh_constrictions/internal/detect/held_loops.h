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
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The greatest number of loops of edges that are tightened. Most of them soon meet the way of another one.
constexpr std::size_t max_held_seeds = 4096;

// A loop with a smaller angle at the location runs to something, around it, and back by nearly the same way.
constexpr double least_loop_angle = CGAL_PI / 4;

// The same on a large surface: on a level, and on finer ones around the location alone, among so many vertices.
constexpr std::size_t max_level_seeds = 1024, max_local_seeds = 256, max_local_vertices = 2048;

// Loops of edges are looked for on a surface with no fewer vertices than this.
constexpr std::size_t least_held_vertices = 4096;

// Translates a closed curve to a coarser surface, into whose faces and edges some of its vertices have been put: the
// result has arcs of that surface. The curve is led past each vertex that the coarser surface does not have, on the
// side of the smaller angle, and pulled straight between the others. Up to rounding it gets no longer. No arcs if it is
// a point. old_of(h) is the halfedge that h is a piece of, or null_index if h lies in a face. Linear in the strips of
// the curve.
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
  // rounding, or a strip so wide that it unfolds over its own centre
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
  // `unit` of the surface
  Held_curves(const Progressive_mesh& pm, Index vertex, const Length_unit& unit)
    : m_network(pm, false), m_angles(pm), m_tightener(m_network, unit, &m_angles), m_basins(m_network, m_tightener),
      m_vertex(vertex)
  {
    m_tightener.hold(vertex);
  }

  // Cost: that of tightening it until it meets the way of another one.
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

// Whether a loop has this angle at least where it is held, and is simple.
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

// The simple geodesic loops at a vertex that result from loops of edges, tightened while they are held at the vertex.
// Only those with at least the given angle at the vertex, each once, the shortest first. Each starts at the vertex.
// `unit` of the surface. Cost: O(n log n) for the loops of edges, plus that of tightening each until it meets the way
// of another one.
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

// A loop of a level may be longer than what it becomes on the input by this share, beyond what the way between the two
// places where they are held explains.
constexpr double greatest_shrinkage = 0.1;

// If none of the others holds on the input, so many are tried that are folded or not simple on the level.
constexpr std::size_t max_doubtful_loops = 16;

// A loop that is tight on a level, at the point nearest to a location, led past vertices of the level.
struct Level_loop
{
  const Level_copy* level;
  std::vector<Index> path; // from the vertex that the location's nearest one has been merged into
  double length, distance; // of the loop, and of the point from the location
};

// The loops of a level at a location, found among so many vertices and loops of edges: those that are simple and have a
// certain angle, and those that are or have not. `nearest` is a vertex of T^0 at the location or joined to it. Cost:
// that of `Loops_at_vertex` on the level, plus that of tightening each loop until it meets the way of another one.
inline void find_loops_on_level(const Level_copy& level, Index nearest, const Progressive_mesh::Point& location,
                                std::size_t most_vertices, std::size_t most_loops, double minimum_angle,
                                std::vector<Level_loop>& loops, std::vector<Level_loop>& doubtful)
{
  const Index root = level.vertex(nearest);
  const Level_with_location with(level.surface(), root, location);
  const Progressive_mesh& pm = with.surface();
  const double distance = norm(vector(location, pm.point(with.vertex())));
  Held_curves curves(pm, with.vertex(), Length_unit(pm));
  for(const std::vector<Index>& path : Loops_at_vertex(pm, with.vertex(), most_vertices).paths(most_loops))
    curves.insert(path);
  for(const std::vector<Arc>& arcs : curves.ends())
  {
    Level_loop loop = {&level, vertices_beside(pm, trace(pm, arcs)), total_length(arcs), distance};
    std::replace(loop.path.begin(), loop.path.end(), with.vertex(), root);
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

  // The closed path from the vertex to the loop, along it, and back; with fewer than three vertices if there is none.
  std::vector<Index> operator()(const Level_loop& loop)
  {
    const Level_copy& level = *loop.level;
    const Index root = level.vertex(m_nearest), original = level.original(root);
    // a curve that passed the vertex a second time would be held there, too
    const auto merged_into = [&](Index v) { return v == m_vertex && v != original ? null_index : level.vertex(v); };
    std::vector<Index> stem;
    if(m_vertex != m_nearest)
      stem.push_back(m_vertex);
    m_to_input.append(
        m_nearest, original, [&](Index v) { return v == m_vertex || level.vertex(v) == root; }, stem);
    const std::vector<Index> around = m_to_input.with_spurs(
        loop.path, [&level](Index v) { return level.original(v); }, merged_into);
    std::vector<Index> path;
    const auto append = [&path](Index v) {
      if(path.size() > 1 && path[path.size() - 2] == v)
        path.pop_back();
      else if(path.empty() || path.back() != v)
        path.push_back(v);
    };
    for(Index v : stem)
      append(v);
    for(Index v : around)
      append(v);
    append(original);
    for(auto v = stem.rbegin(); v != stem.rend(); ++v)
      append(*v);
    if(path.size() > 1 && path.back() == path.front())
      path.pop_back();
    return around.empty() || path.front() != m_vertex ? std::vector<Index>() : path;
  }

private:
  const Index m_vertex, m_nearest;
  Paths_to_finer_level m_to_input;
};

// The same on a large surface, `pm`, which is that of `prepared` or that with `vertex` put in. The loops are looked for
// on a level, and around the vertex alone, as small ones may be too small for that level, on the finer levels and on
// the surface itself. Those that are tight on a level, the shortest first, are led to the surface and tightened again,
// as far as they may be among the shortest. `nearest` is a vertex of T^0 at `vertex` or joined to it. At most
// `maximum_number` loops. Cost: that of `find_loops_on_level()` for each level; plus, for each loop that is led to the
// surface, that of `Paths_to_finer_level` and of tightening it.
template <class TriangleMesh, class VertexPointMap>
std::vector<std::vector<Arc>> held_loops_of_levels(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                                   const Progressive_mesh& pm, Index vertex, Index nearest,
                                                   double minimum_angle, std::size_t maximum_number)
{
  const Progressive_mesh::Point location = pm.point(vertex);
  std::vector<Level_loop> level_loops, doubtful;
  const Level_copy& level = prepared.searching()->of.copy;
  find_loops_on_level(level, nearest, location, (std::numeric_limits<std::size_t>::max)(), max_level_seeds,
                      minimum_angle / 2, level_loops, doubtful);
  for(const Measuring_level& finer : prepared.measuring())
    if(finer.copy.surface().number_of_vertices() > 4 * level.surface().number_of_vertices())
      find_loops_on_level(finer.copy, nearest, location, max_local_vertices, max_local_seeds, minimum_angle / 2,
                          level_loops, doubtful);
  const auto is_shorter = [](const Level_loop& a, const Level_loop& b) { return a.length < b.length; };
  std::stable_sort(level_loops.begin(), level_loops.end(), is_shorter);
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
      continue; // others may be nearer to the location
    const std::vector<Index> path = to_input(loop);
    if(path.size() > 2)
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
