// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_DETECTED_HIERARCHY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_DETECTED_HIERARCHY_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/found_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Slides.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve that a coarse level holds is measured on the input up to this prominence only. If its barrier is higher, it is
// measured on the coarse level.
constexpr double prominence_on_input = 0.1;

// A curve is looked for on a coarse level by a closed geodesic of it that is no more than this longer or shorter.
constexpr double coarse_length_tolerance = 0.1;

// The hierarchy of the curves that a detection has found. Whatever one of them slides to is found, too: it joins them,
// and is measured in turn, until there is nothing new. Curves are known by numbers of seeds, which stay when curves are
// merged.
class Detected_hierarchy
{
public:
  // `coarse` is a level on which prominences are measured, or null
  Detected_hierarchy(const Progressive_mesh& pm, const Level_copy* coarse, const Surface_sides& sides,
                     Curve_network& network)
    : m_pm(pm), m_sides(sides), m_network(network), m_meter(pm)
  {
    if(coarse != nullptr)
      m_coarse.emplace(*coarse);
  }

  // Measures the curves that have been found, and adds those that they slide to: to `found`, sorted by length and each
  // once, and their seeds to `refined` and `seeds`. A curve on the way that hardly holds itself is passed by.
  // certify(found) certifies new curves, and drops those that are no constrictions. Returns the number of seeds of curves
  // passed by. Cost: that of `Barrier_search::search()` for each curve.
  template <class ConcurrencyTag, class Certify>
  std::size_t close(std::vector<Found_curve>& found, std::vector<Refined_curve>& refined,
                    std::vector<Seed_curve>& seeds, const Certify& certify)
  {
    std::vector<Found_curve> added; // not measured yet
    for(;;)
    {
      merge_coinciding(m_network, found);
      m_entries.resize(refined.size());
      if(added.empty())
      {
        forget_wrong_ends(found);
        forget_lost_on_coarse(found);
      }
      std::vector<Index> asked; // curves of the network
      for(const Found_curve& f : found)
        if(!entry(f.curve))
          asked.push_back(f.curve);
      const std::size_t number_found = asked.size();
      for(const Found_curve& f : added)
        asked.push_back(f.curve);
      if(asked.empty())
        return number_of_passed_seeds();
      std::vector<Found_curve> next = measure<ConcurrencyTag>(asked, number_found, found, refined, seeds);
      std::vector<Found_curve> held;
      for(const Found_curve& f : added)
      {
        if(m_network.is_empty(f.curve))
          continue;
        const Entry& e = *entry(f.curve);
        if(e.prominence < negligible_prominence && e.slides_off == null_index && e.has_end)
          m_passed.push_back(f.curve);
        else
          held.push_back(f);
      }
      certify(held);
      found.insert(found.end(), held.begin(), held.end());
      added.swap(next);
    }
  }

  // The entries of the curves found, in their order.
  std::vector<Hierarchy_entry> entries(const std::vector<Found_curve>& found) const
  {
    const std::unordered_map<std::size_t, std::size_t> place = places_by_seed(found);
    const std::unordered_map<Index, std::size_t> place_on_coarse = places_on_coarse(found);
    const std::vector<std::size_t> rank = ranks(found);
    std::vector<Hierarchy_entry> result;
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Entry& e = *entry(found[i].curve);
      Hierarchy_entry h = {e.prominence, std::nullopt, e.slides_off, e.has_end};
      const std::pair<std::size_t, Index> to = destination(e, place);
      const auto seed = place.find(to.first);
      const auto image = place_on_coarse.find(to.second);
      if(seed != place.end() && rank[seed->second] < rank[i])
        h.dominated_by = seed->second;
      else if(image != place_on_coarse.end() && rank[image->second] < rank[i])
        h.dominated_by = image->second;
      result.push_back(h);
    }
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Entry
  {
    double prominence;
    bool has_end;
    bool is_tie = false; // it slides to a curve of the same length
    Index slides_off = null_index;
    std::size_t slides_to = none;       // seed of the curve
    Index image = null_index;           // on the coarse level
    Index slides_to_image = null_index; // of the curve that it slides to, on the coarse level
  };

  // A coarse level.
  struct Coarse
  {
    const Level_copy& level;
    Surface_sides sides;
    Slides slides;

    explicit Coarse(const Level_copy& level) : level(level), sides(level.surface()), slides(level.surface(), sides) {}
  };

  std::size_t number_of_passed_seeds() const
  {
    std::size_t sum = 0;
    for(Index c : m_passed)
      if(!m_network.is_empty(c))
        sum += m_network.curve(c).seeds.size();
    return sum;
  }

  // What a curve slides to may have been corrected to the curve itself, or to one of the same length that does not stand
  // for it. Then it is measured again, once, without ties.
  void forget_wrong_ends(const std::vector<Found_curve>& found)
  {
    const std::unordered_map<std::size_t, std::size_t> place = places_by_seed(found);
    const std::vector<std::size_t> rank = ranks(found);
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Entry* const e = entry(found[i].curve);
      if(e == nullptr || e->slides_to == none)
        continue;
      const auto to = place.find(destination(*e, place).first);
      const bool is_wrong = to == place.end() ? e->is_tie : rank[to->second] >= rank[i];
      if(is_wrong && m_without_ties.insert(found[i].curve).second)
        forget(found[i].curve);
    }
  }

  // A curve may slide on the coarse level to one that has not been found: there may be none on the input. It is measured
  // there.
  void forget_lost_on_coarse(const std::vector<Found_curve>& found)
  {
    const std::unordered_map<Index, std::size_t> place = places_on_coarse(found);
    const std::vector<std::size_t> rank = ranks(found);
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Entry* const e = entry(found[i].curve);
      if(e == nullptr || e->slides_to_image == null_index)
        continue;
      const auto to = place.find(e->slides_to_image);
      if(to != place.end() && rank[to->second] < rank[i])
        continue;
      m_on_input.insert(found[i].curve);
      forget(found[i].curve);
    }
  }

  void forget(Index curve)
  {
    for(std::size_t r : m_network.curve(curve).seeds)
      if(r < m_entries.size())
        m_entries[r].reset();
  }

  std::unordered_map<std::size_t, std::size_t> places_by_seed(const std::vector<Found_curve>& found) const
  {
    std::unordered_map<std::size_t, std::size_t> result;
    for(std::size_t i = 0; i < found.size(); ++i)
      for(std::size_t r : m_network.curve(found[i].curve).seeds)
        result.emplace(r, i);
    return result;
  }

  // By image on the coarse level the place of the shortest curve with that.
  std::unordered_map<Index, std::size_t> places_on_coarse(const std::vector<Found_curve>& found) const
  {
    std::unordered_map<Index, std::size_t> result;
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Entry* const e = entry(found[i].curve);
      if(e != nullptr && e->image != null_index)
        result.emplace(e->image, i);
    }
    return result;
  }

  // The places of curves in the order of length; of those of the same length the one that stands for all comes first. What
  // dominates a curve comes before it, so that each way along what dominates has an end. Curves found, sorted by length.
  std::vector<std::size_t> ranks(const std::vector<Found_curve>& found) const
  {
    std::vector<std::size_t> order(found.size()), result(found.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    for(std::size_t begin = 0, end = 0; begin < found.size(); begin = end)
    {
      do {
        ++end;
      } while(end < found.size() &&
              found[end].length - found[end - 1].length <= equal_length_tolerance * found[end].length);
      std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(end),
                [&](std::size_t i, std::size_t j) { return key(found[i].curve) < key(found[j].curve); });
    }
    for(std::size_t i = 0; i < order.size(); ++i)
      result[order[i]] = i;
    return result;
  }

  std::pair<Index, std::uint64_t> key(Index c) const
  {
    Index least = null_index;
    m_network.for_each_arc(c, [&](Index a) { least = (std::min)(least, m_network.arc(a).from); });
    return {least, m_network.curve(c).hash};
  }

  // Where the way from a curve on leads: to the first curve on it that has been found, by a seed of that; or to a curve
  // of the coarse level.
  std::pair<std::size_t, Index> destination(const Entry& from,
                                            const std::unordered_map<std::size_t, std::size_t>& found) const
  {
    const Entry* e = &from;
    while(e->slides_to != none && found.count(e->slides_to) == 0)
    {
      const Entry* const next = entry(m_curves.at(e->slides_to));
      if(next == nullptr)
        return {none, null_index};
      e = next;
    }
    return {e->slides_to, e->slides_to_image};
  }

  const Entry* entry(Index curve) const
  {
    for(std::size_t r : m_network.curve(curve).seeds)
      if(r < m_entries.size() && m_entries[r])
        return &*m_entries[r];
    return nullptr;
  }

  // Writes the entries of curves of the network, the first of which have been found. Returns new curves that they slide
  // to.
  template <class ConcurrencyTag>
  std::vector<Found_curve> measure(const std::vector<Index>& asked, std::size_t number_found,
                                   const std::vector<Found_curve>& found, std::vector<Refined_curve>& refined,
                                   std::vector<Seed_curve>& seeds)
  {
    std::vector<Measured_curve> curves;
    for(Index c : asked)
    {
      Measured_curve m = {arcs_of_curve(m_network, c), {}, m_network.length(c), false, m_without_ties.count(c) == 0};
      m.trace = accurate_trace(m_pm, m.arcs);
      m.separates = m_sides.part(m.trace).is_separating();
      curves.push_back(std::move(m));
    }
    std::vector<Index> images(asked.size(), null_index);
    std::vector<std::size_t> here, on_coarse; // measured to the end on the input, or not
    for(std::size_t i = 0; i < asked.size(); ++i)
    {
      if(m_coarse && m_on_input.count(asked[i]) == 0)
        images[i] = image(curves[i]);
      (images[i] != null_index ? on_coarse : here).push_back(i);
    }

    std::vector<Prominence> prominences_of(asked.size());
    const auto measure_here = [&](const std::vector<std::size_t>& numbers, double greatest) {
      std::vector<Measured_curve> some;
      for(std::size_t i : numbers)
        some.push_back(curves[i]);
      std::vector<Prominence> p = m_meter.measure<ConcurrencyTag>(some, greatest);
      for(std::size_t j = 0; j < numbers.size(); ++j)
        prominences_of[numbers[j]] = std::move(p[j]);
    };
    measure_here(on_coarse, prominence_on_input);
    for(std::size_t i : on_coarse)
      if(prominences_of[i].end == Barrier_end::BEYOND && coarse_prominence(images[i]) < prominence_on_input)
        here.push_back(i); // the coarse level is another surface there
    std::sort(here.begin(), here.end());
    measure_here(here, (std::numeric_limits<double>::infinity)());

    Distinct_curves distinct(m_network);
    std::unordered_map<Index, double> least; // length of a curve with an image
    const auto note_image = [&least](Index image, double length) {
      const auto known = least.emplace(image, length).first;
      known->second = (std::min)(known->second, length);
    };
    const auto is_least_less = [&least](Index image, double length) {
      const auto known = least.find(image);
      return known != least.end() && known->second < length * (1 - equal_length_tolerance);
    };
    for(const Found_curve& f : found)
      if(const Entry* e = entry(f.curve))
      {
        distinct.insert(f.curve);
        note_image(e->image, f.length);
      }
    for(std::size_t i = 0; i < asked.size(); ++i)
    {
      distinct.insert(asked[i]);
      if(i < number_found)
        note_image(images[i], curves[i].length);
    }
    // what is not found gives way to an equal curve that is
    for(Index c : m_passed)
      if(!m_network.is_empty(c))
        distinct.insert(c);
    std::vector<Found_curve> added;
    for(std::size_t i = 0; i < asked.size(); ++i)
    {
      if(m_network.is_empty(asked[i]))
        continue;
      const Prominence& p = prominences_of[i];
      Entry e;
      e.image = images[i];
      e.prominence = p.value;
      e.has_end = p.end != Barrier_end::NONE;
      e.slides_off = p.vertex;
      if(p.end == Barrier_end::BEYOND)
      {
        const Barrier& b = m_coarse->slides.barrier(images[i]);
        e.prominence = coarse_prominence(images[i]);
        e.has_end = b.end != Barrier_end::NONE;
        e.slides_to_image = b.curve;
        e.slides_off = b.vertex == null_index ? null_index : m_coarse->level.original(b.vertex);
      }
      else if(p.end == Barrier_end::CURVE && p.value < default_minimum_prominence && images[i] != null_index &&
              is_least_less(images[i], curves[i].length))
        e.slides_to_image = images[i]; // one of many that hardly differ
      else if(p.end == Barrier_end::CURVE)
      {
        e.slides_to = refined.size();
        e.is_tie = p.length >= curves[i].length * (1 - equal_length_tolerance);
        const Index c = m_network.add_curve(refined.size());
        std::vector<Arc> arcs = p.arcs;
        m_network.set_arcs(c, arcs);
        refined.push_back(Refined_curve{curve_of_arcs(p.arcs), {seeds.size()}, false});
        seeds.push_back(Seed_curve{0, path_inside(m_pm, p.strip), Seed_origin::BARRIER});
        const Index known = distinct.insert(c);
        m_curves.emplace(e.slides_to, known);
        if(known == c)
          added.push_back({c, m_network.length(c), 0, Certificate()});
      }
      m_entries[m_network.curve(asked[i]).seeds.front()] = e;
    }
    m_entries.resize(refined.size());
    return added;
  }

  // The number on the coarse level of what a curve is there, if it is about the same.
  Index image(const Measured_curve& curve)
  {
    const Index c = m_coarse->slides.tighten(m_coarse->level.path(vertices_passed(m_pm, curve.trace)));
    return c != null_index && std::abs(m_coarse->slides.length(c) / curve.length - 1) <= coarse_length_tolerance
               ? c
               : null_index;
  }

  double coarse_prominence(Index image)
  {
    return m_coarse->slides.barrier(image).length / m_coarse->slides.length(image) - 1;
  }

  const Progressive_mesh& m_pm;
  const Surface_sides& m_sides;
  Curve_network& m_network;
  Prominence_meter m_meter;
  std::optional<Coarse> m_coarse;
  std::vector<std::optional<Entry> > m_entries; // by seed: set for one seed of each curve that has been measured
  std::unordered_map<std::size_t, Index> m_curves; // by seed: that a curve that was measured slides to
  std::unordered_set<Index> m_without_ties;        // curves of the network
  std::unordered_set<Index> m_on_input;            // curves of the network that are not measured on the coarse level
  std::vector<Index> m_passed;                     // curves of the network that are not found, but were measured
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_DETECTED_HIERARCHY_H
