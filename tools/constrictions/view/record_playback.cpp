// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Progressive_mesh;
using SMC::Seed_curve;

// The surface that is shown has this many vertices at most: about 100,000 faces.
const std::size_t shown_vertices = 50000;

// Of so many constrictions, the first, seeds are followed; of each so many seeds are tried.
const std::size_t followed_constrictions = 64, tried_seeds = 4;

// The number of levels that are shown; those at which seeds appear come in addition.
const std::size_t shown_frames = 48;

typedef std::set<std::size_t> Level_set;

// Points of the progressive mesh in the unit of the user's mesh.
class Unit
{
public:
  explicit Unit(const Mesh& mesh)
  {
    double greatest = 0;
    for(Mesh::Vertex_index v : mesh.vertices())
      for(int i = 0; i < 3; ++i)
        greatest = (std::max)(greatest, std::abs(mesh.point(v)[i]));
    m_unit = SMC::internal::Coordinate_unit(greatest);
  }

  Mesh::Point operator()(double x, double y, double z) const
  {
    return {m_unit.restored(x), m_unit.restored(y), m_unit.restored(z)};
  }
  Mesh::Point operator()(const Mesh::Point& p) const { return (*this)(p.x(), p.y(), p.z()); }

private:
  SMC::internal::Coordinate_unit m_unit;
};

// The numbers that the vertices of the mesh have in the progressive mesh, by the index of the vertex.
std::vector<Index> vertex_numbers(const Mesh& mesh)
{
  std::vector<Index> number(mesh.num_vertices(), SMC::null_index);
  Index n = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    number[v] = n++;
  return number;
}

// For each face of the progressive mesh its place in `faces(mesh)`: the detection has an order of its own. `pm` at
// level 0.
std::vector<std::size_t> places_of_faces(const Mesh& mesh, const Progressive_mesh& pm)
{
  const std::vector<Index> number = vertex_numbers(mesh);
  std::vector<std::size_t> result(pm.number_of_face_ids());
  std::size_t place = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    result[pm.face(pm.halfedge(number[mesh.source(h)], number[mesh.target(h)]))] = place++;
  }
  return result;
}

// `pm` at level 0; leaves it at its coarsest level.
Shown_levels shown_levels(const Mesh& mesh, Progressive_mesh& pm, const Unit& unit)
{
  Shown_levels result;
  const std::vector<std::size_t> place = places_of_faces(mesh, pm);
  pm.go_to_level(pm.level_with(shown_vertices));
  result.finest_level = pm.level();
  const std::size_t n = pm.number_of_vertices(), collapses = pm.number_of_collapses() - pm.level();

  std::vector<std::uint32_t> number(pm.number_of_vertex_ids(), SMC::null_index);
  for(std::size_t i = 0; i < collapses; ++i)
    number[pm.collapse().removed] = static_cast<std::uint32_t>(n - 1 - i);
  std::uint32_t next = 0;
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    if(pm.is_vertex(v) && !pm.is_ghost_vertex(v))
      number[v] = next++;
  pm.go_to_level(result.finest_level);

  result.points.resize(n);
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    if(pm.is_vertex(v) && !pm.is_ghost_vertex(v))
      result.points[number[v]] = unit(pm.point(v));
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
    if(pm.is_face(f) && !pm.is_ghost_face(f))
    {
      result.faces.push_back({{number[pm.source(3 * f)], number[pm.source(3 * f + 1)], number[pm.source(3 * f + 2)]}});
      result.input_faces.push_back(place[f]);
    }
  for(std::size_t i = 0; i < collapses; ++i)
  {
    const Progressive_mesh::Split s = pm.collapse();
    result.parents.push_back(number[s.kept]);
    result.moves.push_back(unit(pm.point(s.kept)));
  }
  return result;
}

std::vector<Mesh::Point> points_of(const Progressive_mesh& pm, const Unit& unit, const SMC::Closed_curve& curve)
{
  std::vector<Mesh::Point> result;
  for(const SMC::internal::Trace_point& p : SMC::internal::trace(pm, SMC::internal::arcs_of_curve(pm, curve)))
  {
    const SMC::internal::Vector3 x = SMC::internal::position(pm, p);
    result.push_back(unit(x.x, x.y, x.z));
  }
  return result;
}

// The greatest squared distance of a point of one curve to the nearest point of the other.
double squared_distance(const std::vector<Mesh::Point>& from, const std::vector<Mesh::Point>& to)
{
  double greatest = 0;
  for(const Mesh::Point& p : from)
  {
    double nearest = (std::numeric_limits<double>::infinity)();
    for(const Mesh::Point& q : to)
      nearest = (std::min)(nearest, CGAL::squared_distance(p, q));
    greatest = (std::max)(greatest, nearest);
  }
  return greatest;
}

// A seed of a constriction.
struct Followed_seed
{
  std::size_t constriction;
  Seed_curve seed;
};

// The seeds of each constriction that have the longest way, triangles before others.
std::vector<Followed_seed> seeds_to_try(const Mesh& mesh, const std::vector<Constriction>& constrictions)
{
  const std::vector<Index> number = vertex_numbers(mesh);
  std::vector<Followed_seed> result;
  for(std::size_t c = 0; c < (std::min)(constrictions.size(), followed_constrictions); ++c)
  {
    std::vector<Constriction::Seed> seeds = constrictions[c].seeds();
    const auto rank = [](const Constriction::Seed& s) {
      return std::make_tuple(s.vertices.size() != 3, (std::numeric_limits<std::size_t>::max)() - s.level);
    };
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&rank](const Constriction::Seed& a, const Constriction::Seed& b) { return rank(a) < rank(b); });
    seeds.resize((std::min)(seeds.size(), tried_seeds));
    for(const Constriction::Seed& s : seeds)
    {
      Seed_curve seed = {s.level, {}, s.origin};
      for(Mesh::Vertex_index v : s.vertices)
        seed.vertices.push_back(number[v]);
      result.push_back({c, std::move(seed)});
    }
  }
  return result;
}

std::vector<Seed_curve> curves_of(const std::vector<Followed_seed>& followed)
{
  std::vector<Seed_curve> result;
  for(const Followed_seed& f : followed)
    result.push_back(f.seed);
  return result;
}

// Of each constriction the seed that comes closest to it on T^0, if one arrives. Leaves the progressive mesh there.
std::vector<Followed_seed> best_seeds(Progressive_mesh& pm, const Unit& unit,
                                      const std::vector<std::vector<Mesh::Point>>& constrictions,
                                      const std::vector<Followed_seed>& tried)
{
  std::vector<SMC::Refined_curve> refined;
  SMC::refine_seed_curves(pm, curves_of(tried), SMC::Tightening_schedule::AT_THE_END, std::back_inserter(refined));
  std::map<std::size_t, std::pair<double, std::size_t>> best; // distance and number of a seed, by constriction
  for(const SMC::Refined_curve& r : refined)
  {
    if(r.curve.nodes.empty())
      continue;
    const std::vector<Mesh::Point> points = points_of(pm, unit, r.curve);
    for(std::size_t s : r.seeds)
    {
      const std::pair<double, std::size_t> candidate(squared_distance(points, constrictions[tried[s].constriction]), s);
      const auto [it, is_first] = best.emplace(tried[s].constriction, candidate);
      if(!is_first)
        it->second = (std::min)(it->second, candidate);
    }
  }
  std::vector<Followed_seed> result;
  for(const auto& b : best)
    result.push_back(tried[b.second.second]);
  return result;
}

// Numbers of vertices in geometric progression, and the levels of the seeds.
Level_set levels_to_show(const Progressive_mesh& pm, const std::vector<Followed_seed>& followed)
{
  Level_set result = {0, pm.number_of_collapses()};
  const double finest = static_cast<double>(pm.number_of_vertices() + pm.level());
  const double ratio = (finest - static_cast<double>(pm.number_of_collapses())) / finest;
  for(std::size_t i = 1; i < shown_frames; ++i)
  {
    const double share = std::pow(ratio, static_cast<double>(i) / static_cast<double>(shown_frames));
    result.insert(pm.level_with(static_cast<std::size_t>(finest * share)));
  }
  for(const Followed_seed& f : followed)
    result.insert(f.seed.level);
  return result;
}

// Notes the curves on the levels that are to be shown. Of curves that have met one is noted, but each seed where it
// appears.
class Frame_recorder : public SMC::Refinement_visitor_base
{
public:
  Frame_recorder(const Progressive_mesh& pm, const Unit& unit, const std::vector<Followed_seed>& followed,
                 const Level_set& levels)
    : m_pm(pm), m_unit(unit), m_followed(followed), m_levels(levels), m_curves(followed.size()),
      m_appearing(followed.size())
  {}

  template <class Curve>
  void on_curve(std::size_t level, const std::vector<std::size_t>& seeds, const Curve& curve)
  {
    for(std::size_t s : seeds)
    {
      m_curves[s] = curve;
      if(m_followed[s].seed.level == level)
        m_appearing[s] = curve(); // it may meet another one at once
    }
  }

  void on_level(std::size_t level)
  {
    if(m_levels.count(level) == 0)
      return;
    Playback_frame frame = {level, m_pm.number_of_vertices(), {}};
    for(std::size_t s = 0; s < m_curves.size(); ++s)
      if(m_curves[s])
      {
        const bool is_seed = m_followed[s].seed.level == level;
        const SMC::Closed_curve curve = is_seed ? m_appearing[s] : m_curves[s]();
        if(!curve.nodes.empty())
          frame.curves.push_back({m_followed[s].constriction, is_seed, points_of(m_pm, m_unit, curve)});
      }
    frames.push_back(std::move(frame));
  }

  std::vector<Playback_frame> frames;

private:
  const Progressive_mesh& m_pm;
  const Unit& m_unit;
  const std::vector<Followed_seed>& m_followed;
  const Level_set& m_levels;
  std::vector<std::function<SMC::Closed_curve()>> m_curves; // by seed, as it is now; none before it appears
  std::vector<SMC::Closed_curve> m_appearing;               // by seed, as it is on its level
};

} // namespace

Playback record_playback(const Mesh& mesh, const std::vector<Constriction>& constrictions, Progressive_mesh levels)
{
  levels.go_to_level(0);
  const Unit unit(mesh);
  const std::size_t vertices = levels.number_of_vertices();
  Playback result;
  result.collapses = levels.number_of_collapses();
  result.number_followed = (std::min)(constrictions.size(), followed_constrictions);
  result.surface = shown_levels(mesh, levels, unit);

  std::vector<std::vector<Mesh::Point>> ends(result.number_followed);
  for(std::size_t c = 0; c < ends.size(); ++c)
    constrictions[c].points(mesh, std::back_inserter(ends[c]));
  const std::vector<Followed_seed> followed = best_seeds(levels, unit, ends, seeds_to_try(mesh, constrictions));

  // the refinement begins with the first seed
  const Level_set shown = levels_to_show(levels, followed);
  std::size_t first = 0;
  for(const Followed_seed& f : followed)
    first = (std::max)(first, f.seed.level);
  for(auto level = shown.rbegin(); level != shown.rend() && *level > first; ++level)
    result.frames.push_back({*level, vertices - *level, {}});

  Frame_recorder recorder(levels, unit, followed, shown);
  std::vector<SMC::Refined_curve> refined;
  SMC::refine_seed_curves(levels, curves_of(followed), SMC::Tightening_schedule::AT_THE_END,
                          std::back_inserter(refined), recorder);
  std::move(recorder.frames.begin(), recorder.frames.end(), std::back_inserter(result.frames));
  return result;
}

} // namespace constrictions
