// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_NEAR_SEARCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_NEAR_SEARCH_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Local_boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/Local_cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/boundary_share.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/coincidence.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Closed_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/found_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Level_with_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_canonical.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossed_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Prominence_meter.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/remove_beside_others.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/loops_at_vertex.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/reordered.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/tighten_paths.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A constriction is around the limb of a location if it is at most so many times as long as the girth there, and no
// further away than this share of its length,
constexpr double most_girths = 1.5, greatest_distance = 1;
// or if it passes the location at no more than this share of its length.
constexpr double passing_distance = 0.05;
// A loop with this angle, in radians, is hardly bent at the location.
constexpr double least_straight_angle = 5 * CGAL_PI / 6;
// On a level lengths and distances are known up to this factor.
constexpr double level_slack = 1.25;

// What of that which is near is written; see `detect_constrictions_near()`.
struct Near_selection
{
  std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)();
  double minimum_prominence = 0, minimum_isolation = 0, maximum_ratio = 0, minimum_length = 0, maximum_length = 0;
  bool all = false, with_crossing = false, with_rims = false, certifies = true, certified_only = false;
};

// Finds the constrictions around a location of a prepared surface, with the levels that it holds.
template <class TriangleMesh, class VertexPointMap>
class Near_search
{
  typedef Prepared_surface<TriangleMesh, VertexPointMap> Prepared;
  typedef Constriction<TriangleMesh> Result;

public:
  // `location` in the unit of the surface. Cost: that of `girth()`.
  Near_search(const Prepared& prepared, const Progressive_mesh::Point& location, const Near_selection& selection)
    : m_prepared(prepared), m_pm(prepared.surface()), m_selection(selection),
      m_location({location.x(), location.y(), location.z()}), m_vertex(prepared.locator().nearest_vertex(location)),
      m_girth(selection.all ? 0 : girth(location)), m_network(m_pm, false), m_distinct(m_network), m_angles(m_pm),
      m_settler(m_network, prepared.length_unit(), m_angles),
      m_exact_settler(m_pm, prepared.imported(), prepared.vertex_point_map())
  {
    m_statistics.collapses = m_pm.number_of_collapses();
  }

  // The constrictions, the nearest first. To be called once.
  template <class ConcurrencyTag, class Visitor>
  std::vector<Result> search(const Visitor& visitor)
  {
    visitor.on_stage_begin(Detection_stage::SEEDS, 0);
    std::vector<Path> paths = seeds_on_level<ConcurrencyTag>();
    visitor.on_stage_end(Detection_stage::SEEDS);

    visitor.on_stage_begin(Detection_stage::REFINEMENT, 0);
    m_waiting = paths_on_last_level<ConcurrencyTag>(std::move(paths));
    visitor.on_stage_end(Detection_stage::REFINEMENT);

    visitor.on_stage_begin(Detection_stage::SELECTION, m_waiting.size());
    add_boundaries();
    m_statistics.seeds = m_seeds.size();
    std::vector<Result> result = nearest([&visitor](std::size_t i) { visitor.on_step(Detection_stage::SELECTION, i); });
    m_statistics.leaky_bands += m_settler.number_of_leaks();
    m_statistics.corrected += m_exact_settler.number_of_corrections();
    visitor.on_stage_end(Detection_stage::SELECTION);
    return result;
  }

  const Detection_statistics& statistics() const { return m_statistics; }

private:
  // A closed path of edges, the seeds that it stands for, and how near the curve is that it becomes on its level.
  struct Path
  {
    std::vector<Index> vertices;
    std::vector<std::size_t> seeds;
    double nearness;
  };

  // How many seeds are kept of those that become equal on a level.
  static constexpr std::size_t most_kept = 4;
  // How many loops the girth is looked for among.
  static constexpr std::size_t most_girth_seeds = 512;

  // The girth at the location, as the seeding level tells: the length of the longest loop held there that is hardly
  // bent there, since where limbs meet there are several; or else of the shortest one that is not folded; or else, as
  // beside a limb, of the shortest one; infinite if no loop holds.
  double girth(const Progressive_mesh::Point& location) const
  {
    const Held_level& level = m_prepared.seeding();
    const Index root = level.of.copy.vertex(m_vertex);
    const Level_with_location with(level.surface(), root, location);
    const Progressive_mesh& coarse = with.surface();
    Held_curves curves(coarse, with.vertex(), Length_unit(coarse));
    for(const std::vector<Index>& path : loops_at_vertex(coarse, with.vertex(), most_girth_seeds))
      curves.insert(path);
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    double longest = 0, least = infinity, least_folded = infinity;
    for(const std::vector<Arc>& arcs : curves.ends())
    {
      const double length = total_length(arcs);
      if(length > longest && is_held_loop(coarse, arcs, least_straight_angle))
        longest = length;
      else if(length < least && is_held_loop(coarse, arcs, least_loop_angle))
        least = length;
      else if(length < least_folded && is_held_loop(coarse, arcs, 0))
        least_folded = length;
    }
    return longest > 0 ? longest : least < infinity ? least : least_folded;
  }

  // Loops of edges of the seeding level, and the seeds that they are.
  template <class ConcurrencyTag>
  std::vector<Path> seeds_on_level()
  {
    const Held_level& level = m_prepared.seeding();
    const Level_copy& copy = level.of.copy;
    const Edge_graph& graph = m_prepared.seeding_graph();
    std::vector<Seed_curve> seeds;
    write_local_loops<ConcurrencyTag>(graph, graph.number(copy.vertex(m_vertex)), local_roots, level.level,
                                      std::back_inserter(seeds));
    if(level.level > 0)
      add_boundary_seeds(copy.surface(), copy.vertex(m_vertex), seeds);
    std::vector<Path> paths;
    for(Seed_curve& seed : seeds)
    {
      paths.push_back({seed.vertices, {m_seeds.size()}, 0});
      seed.level = level.level;
      for(Index& v : seed.vertices)
        v = copy.original(v);
      m_seeds.push_back(std::move(seed));
    }
    return paths;
  }

  static void add_boundary_seeds(const Progressive_mesh& pm, Index vertex, std::vector<Seed_curve>& seeds)
  {
    const Seed_level level = {pm.number_of_vertices(), 0, null_index, nullptr, false};
    const Local_boundary_seeds source(vertex);
    source(pm, level, std::back_inserter(seeds));
  }

  // The boundaries of T^0 go on as they are: a rim is judged there.
  void add_boundaries()
  {
    std::vector<Seed_curve> boundaries;
    add_boundary_seeds(m_pm, m_vertex, boundaries);
    for(Seed_curve& b : boundaries)
    {
      m_seeds.push_back(b);
      examine(std::move(b.vertices), {m_seeds.size() - 1});
    }
  }

  // Leads loops of the seeding level to the last level before T^0, as far as they may lead to what is asked for; the
  // nearest first.
  template <class ConcurrencyTag>
  std::vector<Path> paths_on_last_level(std::vector<Path> paths)
  {
    const Level_copy& coarse = m_prepared.seeding().of.copy;
    paths = promising<ConcurrencyTag>(coarse.surface(), std::move(paths), most_kept);
    if(m_prepared.searching() != nullptr)
    {
      const Level_copy& fine = m_prepared.searching()->of.copy;
      Paths_to_finer_level to_level(fine.surface());
      paths = led(std::move(paths), [&](const std::vector<Index>& path) { return to_level(coarse, fine, path); });
      paths = promising<ConcurrencyTag>(fine.surface(), std::move(paths), 0);
    }
    std::stable_sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.nearness < b.nearness; });
    return paths;
  }

  template <class Lead>
  std::vector<Path> led(std::vector<Path> paths, const Lead& lead)
  {
    std::vector<Path> result;
    for(Path& p : paths)
    {
      p.vertices = lead(p.vertices);
      if(p.vertices.size() < 3)
        m_statistics.degenerate += p.seeds.size();
      else
        result.push_back(std::move(p));
    }
    return result;
  }

  // Tightens copies of paths on a level. Of those that become equal, and may be what is asked for, some are kept, from
  // the shortest to the longest at equal steps; or the tight copy, moved to edges, if `kept` is 0.
  template <class ConcurrencyTag>
  std::vector<Path> promising(const Progressive_mesh& pm, std::vector<Path> paths, std::size_t kept)
  {
    Curve_network network(pm, false);
    const auto path_of = [&](std::size_t i) { return paths[i].vertices; };
    for(std::size_t i : tighten_paths<ConcurrencyTag>(paths.size(), path_of, network))
      m_statistics.degenerate += paths[i].seeds.size();
    const Surface_sides sides(pm);
    std::vector<Path> result;
    for(Index c = 0; c < network.number_of_curve_ids(); ++c)
    {
      if(network.is_empty(c))
        continue;
      const std::vector<Arc> arcs = arcs_of_curve(network, c);
      const std::vector<Trace_point> points = trace(pm, arcs);
      const double nearness = this->nearness(distance(pm, points), total_length(arcs));
      std::vector<std::size_t> its_paths = network.curve(c).seeds;
      if(is_simple(pm, points) && !is_asked_for(pm, sides, arcs, points, level_slack))
      {
        drop(its_paths, [&](std::size_t i) { return paths[i].seeds.size(); });
        continue;
      }
      if(kept == 0)
      {
        Path tight = {path_beside_curve(pm, points), {}, nearness};
        for(std::size_t i : its_paths)
          tight.seeds.insert(tight.seeds.end(), paths[i].seeds.begin(), paths[i].seeds.end());
        result.push_back(std::move(tight));
        continue;
      }
      std::vector<double> lengths;
      for(std::size_t i : its_paths)
        lengths.push_back(length_of_path(pm, paths[i].vertices));
      std::vector<std::size_t> order(its_paths.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t i, std::size_t j) { return lengths[i] < lengths[j]; });
      for(std::size_t i = 0, last = kept; i < order.size(); ++i)
      {
        Path& path = paths[its_paths[order[i]]];
        const std::size_t place = i * kept / order.size();
        if(place != last)
        {
          result.push_back(std::move(path));
          result.back().nearness = nearness;
        }
        else
          result.back().seeds.insert(result.back().seeds.end(), path.seeds.begin(), path.seeds.end());
        last = place;
      }
    }
    return result;
  }

  static double length_of_path(const Progressive_mesh& pm, const std::vector<Index>& path)
  {
    double sum = 0;
    for(std::size_t i = 0; i < path.size(); ++i)
      sum += norm(position(pm, path[(i + 1) % path.size()]) - position(pm, path[i]));
    return sum;
  }

  // Counts a curve that is dropped: as one that is not selected, and the other seeds that led to it.
  template <class SeedsOf>
  void drop(const std::vector<std::size_t>& paths, const SeedsOf& seeds_of)
  {
    std::size_t seeds = 0;
    for(std::size_t i : paths)
      seeds += seeds_of(i);
    m_statistics.merged += seeds - 1;
    ++m_statistics.not_selected;
  }

  // Tightens a closed path of T^0. What comes of it, if that is asked for, is a candidate.
  void examine(std::vector<Index> path, std::vector<std::size_t> seeds)
  {
    const std::size_t number = seeds.size();
    const Index c = m_network.add_curve(std::move(seeds));
    {
      std::vector<Arc> arcs = arcs_of_curve(m_pm, Closed_curve(path));
      m_network.set_arcs(c, arcs);
    }
    Tightening_verdict verdict = m_settler.settle(c);
    double band_width = m_settler.band_width();
    if(verdict == Tightening_verdict::NOT_SIMPLE && m_selection.certifies)
      verdict = Tightening_verdict::CLOSED_GEODESIC; // it may be corrected
    else if(verdict == Tightening_verdict::CLOSED_GEODESIC && !is_asked_for(c, band_width))
      return drop(c);
    if(verdict == Tightening_verdict::CLOSED_GEODESIC && m_distinct.insert(c) != c)
      return;
    Certificate certificate;
    if(verdict == Tightening_verdict::CLOSED_GEODESIC && m_selection.certifies)
    {
      m_distinct.remove(c); // it may be changed
      certificate = m_exact_settler.settle(m_network, c);
      m_statistics.signs = m_statistics.signs + certificate.signs;
      band_width = m_prepared.imported().unit().divided(certificate.flat_band_width);
      verdict = tightening_verdict(certificate, m_network.is_empty(c));
      if(verdict == Tightening_verdict::NOT_CERTIFIED && !m_selection.certified_only &&
         remains_open(m_pm, arcs_of_curve(m_network, c), certificate.verdict))
        verdict = Tightening_verdict::CLOSED_GEODESIC;
      if(verdict == Tightening_verdict::CLOSED_GEODESIC && m_distinct.insert(c) != c)
        return;
    }
    if(verdict != Tightening_verdict::CLOSED_GEODESIC)
    {
      (verdict == Tightening_verdict::DEGENERATE   ? m_statistics.degenerate
       : verdict == Tightening_verdict::NOT_SIMPLE ? m_statistics.not_simple
                                                   : m_statistics.not_certified) += number;
      m_distinct.remove(c);
      m_network.remove(c);
      return;
    }
    if(!is_asked_for(c, band_width))
    {
      m_distinct.remove(c);
      return drop(c);
    }
    const double length = m_network.length(c);
    const std::vector<Trace_point> points = trace(m_pm, arcs_of_curve(m_network, c));
    const Curve_shape shape(m_pm, points);
    for(const Candidate& other : m_candidates)
      if(std::abs(other.found.length - length) <= coincidence_tolerance * length &&
         coincide(shape, Curve_shape(m_pm, trace(m_pm, arcs_of_curve(m_network, other.found.curve))), length))
      {
        m_distinct.remove(c);
        m_network.merge(c, other.found.curve);
        return;
      }
    m_candidates.push_back(
        {{c, length, band_width, certificate}, nearness(distance(m_pm, points) - band_width, length), false});
  }

  bool is_asked_for(Index c, double band_width) const
  {
    const std::vector<Arc> arcs = arcs_of_curve(m_network, c);
    return is_asked_for(m_pm, m_prepared.sides(), arcs, trace(m_pm, arcs), 1, band_width);
  }

  void drop(Index c)
  {
    m_statistics.merged += m_network.curve(c).seeds.size() - 1;
    ++m_statistics.not_selected;
    m_network.remove(c);
  }

  // The smaller the nearer: the distance, the shorter one of two that are about as near, and late one whose distance is
  // several times its length.
  static double nearness(double distance, double length)
  {
    const double d = (std::max)(distance, 0.0);
    return d * (1 + d / length) + length / 10;
  }

  double distance(const Progressive_mesh& pm, const std::vector<Trace_point>& points) const
  {
    double least = (std::numeric_limits<double>::infinity)();
    Vector3 p = position(pm, points.back());
    for(const Trace_point& point : points)
    {
      const Vector3 q = position(pm, point);
      least = (std::min)(least, distance_to_segment(m_location, p, q));
      p = q;
    }
    return least;
  }

  // Whether a simple curve is around the limb of the location, and no longer than its area allows. On a level both hold
  // up to a factor.
  bool is_asked_for(const Progressive_mesh& pm, const Surface_sides& sides, const std::vector<Arc>& arcs,
                    const std::vector<Trace_point>& points, double slack, double band_width = 0) const
  {
    if(m_selection.all)
      return true;
    const double length = total_length(arcs);
    const Parting parting = sides.part(points);
    if(is_too_long(length, parting, m_selection.maximum_ratio * slack) &&
       !(m_selection.with_rims && boundary_share(pm, arcs, parting) > rim_share))
      return false;
    const double d = distance(pm, points) - band_width;
    if(d <= passing_distance * slack * length)
      return true;
    if(m_girth < (std::numeric_limits<double>::infinity)())
      return length <= most_girths * slack * m_girth && d <= greatest_distance * slack * length;
    return slack > 1 ||
           (parting.is_separating() && sides.is_on_lesser_side(points, parting, pm.face(pm.outgoing(m_vertex))));
  }

  // A curve of T^0 that may be written.
  struct Candidate
  {
    Found_curve found;
    double nearness;
    bool is_done;
  };

  // The nearest candidate that is not done; null if there is none, or if one that waits on the last level may be
  // nearer.
  Candidate* next_candidate(std::size_t waiting)
  {
    const auto is_later = [](const Candidate& a, const Candidate& b) {
      return a.is_done != b.is_done ? a.is_done : a.nearness > b.nearness;
    };
    const auto nearest =
        std::min_element(m_candidates.begin(), m_candidates.end(),
                         [&is_later](const Candidate& a, const Candidate& b) { return is_later(b, a); });
    if(nearest == m_candidates.end() || nearest->is_done ||
       (waiting < m_waiting.size() && m_waiting[waiting].nearness < level_slack * nearest->nearness))
      return nullptr;
    return &*nearest;
  }

  // The nearest constrictions, with their prominences. Loops wait on the last level until it is their turn.
  template <class Progress>
  std::vector<Result> nearest(const Progress& on_step)
  {
    const bool stops = m_selection.minimum_isolation <= 0;
    const Level_copy& last = (m_prepared.searching() ? *m_prepared.searching() : m_prepared.seeding()).of.copy;
    Paths_to_finer_level to_input(m_pm);
    Constriction_maker<TriangleMesh> maker(m_prepared.imported(), m_pm, m_prepared.sides());
    std::optional<Prominence_meter> meter;
    std::optional<Crossed_curves> crossed;
    std::vector<Result> result;
    std::vector<std::vector<Trace_point>> traces;
    std::vector<Index> curves, slides_to; // of the network
    std::vector<Hierarchy_entry> entries;
    std::size_t waiting = 0;
    while(!stops || result.size() < m_selection.maximum_number)
    {
      Candidate* const next = next_candidate(waiting);
      if(next == nullptr)
      {
        if(waiting == m_waiting.size())
          break;
        Path& path = m_waiting[waiting];
        path.vertices = to_input(last, path.vertices);
        if(path.vertices.size() < 3)
          m_statistics.degenerate += path.seeds.size();
        else
          examine(std::move(path.vertices), std::move(path.seeds));
        on_step(++waiting);
        continue;
      }
      next->is_done = true;
      const Found_curve& f = next->found;
      std::vector<Seed_curve> its_seeds;
      for(std::size_t s : m_network.curve(f.curve).seeds)
        its_seeds.push_back(m_seeds[s]);
      make_canonical(m_network, f.curve, f.certificate);
      const std::vector<Arc> arcs = arcs_of_curve(m_network, f.curve);
      std::vector<Trace_point> points = accurate_trace(m_pm, arcs);
      Result curve = maker.make(m_network, f.curve, points, its_seeds, f.band_width, f.certificate);
      const bool is_rim = curve.is_rim() && m_selection.with_rims;
      if(!m_selection.all && !is_rim &&
         (curve.is_rim() || (curve.is_separating() && curve.isoperimetric_ratio() > m_selection.maximum_ratio)))
        continue;
      if(!m_selection.all && !m_selection.with_crossing)
      {
        if(!crossed)
          crossed.emplace(m_pm);
        if(!crossed->crossed_by(points).empty())
          continue;
      }
      // the bounds of the length hold after the selection
      const bool is_within =
          curve.length() >= m_selection.minimum_length && curve.length() <= m_selection.maximum_length;
      if(!is_within && (m_selection.all || is_rim || m_selection.minimum_prominence <= 0))
      {
        if(crossed)
          crossed->add(points);
        continue;
      }
      if(!meter)
        meter.emplace(m_pm, m_prepared.measuring());
      const Measured_curve measured = {arcs, points, f.length, curve.is_separating()};
      const Prominence p = std::move(meter->template measure<Sequential_tag>({measured}, [](std::size_t) {}).front());
      if(!m_selection.all && !is_rim && p.value < m_selection.minimum_prominence)
        continue;
      if(crossed)
        crossed->add(points);
      if(!is_within)
        continue;
      entries.push_back({p.value, std::nullopt, p.vertex, p.end != Barrier_end::NONE});
      curves.push_back(f.curve);
      slides_to.push_back(null_index);
      if(p.end == Barrier_end::CURVE)
      {
        slides_to.back() = m_network.add_curve(0);
        std::vector<Arc> end = p.arcs;
        m_network.set_arcs(slides_to.back(), end);
      }
      result.push_back(std::move(curve));
      traces.push_back(std::move(points));
    }

    for(std::size_t i = 0; i < result.size(); ++i)
      for(std::size_t j = 0; j < result.size() && slides_to[i] != null_index; ++j)
        if((result[j].length() < result[i].length() || (result[j].length() == result[i].length() && j < i)) &&
           m_network.are_equal(slides_to[i], curves[j]))
          entries[i].dominated_by = j;
    set_prominences(m_pm, m_prepared.sides(), m_prepared.imported(), traces, entries, result);
    if(!stops)
    {
      std::vector<std::size_t> selected(result.size());
      std::iota(selected.begin(), selected.end(), std::size_t(0));
      if(!m_selection.all)
        remove_beside_others(result, std::vector<bool>(result.size(), true), m_selection.minimum_isolation,
                             m_selection.with_rims, selected);
      result = reordered(result, selected, m_selection.maximum_number);
    }
    for(const Candidate& c : m_candidates)
      m_statistics.merged += m_network.curve(c.found.curve).seeds.size() - 1;
    for(std::size_t i = waiting; i < m_waiting.size(); ++i)
      m_statistics.merged += m_waiting[i].seeds.size() - 1;
    m_statistics.not_selected += m_candidates.size() + (m_waiting.size() - waiting) - result.size();
    return result;
  }

  const Prepared& m_prepared;
  const Progressive_mesh& m_pm;
  const Near_selection m_selection;
  const Vector3 m_location;
  const Index m_vertex; // the one nearest to it
  const double m_girth;
  std::vector<Seed_curve> m_seeds;
  std::vector<Path> m_waiting; // on the last level before T^0, the nearest first
  std::deque<Candidate> m_candidates;
  Curve_network m_network; // on T^0; seeds of its curves are numbers of m_seeds
  Distinct_curves m_distinct;
  const Corner_angles m_angles;
  Curve_settler m_settler;
  Exact_settler<TriangleMesh, VertexPointMap> m_exact_settler;
  Detection_statistics m_statistics;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_NEAR_SEARCH_H
