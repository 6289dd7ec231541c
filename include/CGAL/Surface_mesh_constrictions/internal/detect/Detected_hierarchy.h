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
#include <CGAL/Surface_mesh_constrictions/internal/curves/tie_key.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/found_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Prominence_meter.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The hierarchy of the curves that a detection has found. A curve that one of them slides to joins them, if it is not
// among them, and is measured in turn, until there is nothing new. Curves are known by numbers of seeds, which stay the
// same when curves are merged.
class Detected_hierarchy
{
public:
  // `levels` of the surface to measure on. Linear in the size of the mesh.
  Detected_hierarchy(const Progressive_mesh& pm, const std::deque<Measuring_level>& levels, const Surface_sides& sides,
                     Curve_network& network)
    : m_pm(pm), m_sides(sides), m_network(network), m_meter(pm, levels)
  {}

  // Measures the curves that have been found, and adds those that they slide to: to `found`, sorted by length and each
  // once, and their seeds to `refined` and `seeds`. A curve on the way that hardly holds itself is skipped.
  // certify(found) certifies new curves, and drops those that are not constrictions; the way leads on from these, too.
  // Calls on_step() with the number of steps done, `Prominence_meter::steps_of_curve` for each curve found at first; those
  // that join are not counted. Returns the number of seeds of skipped curves. Cost: that of `Barrier_search::search()`
  // for each curve.
  template <class ConcurrencyTag, class Certify, class Progress>
  std::size_t close(std::vector<Found_curve>& found, std::vector<Refined_curve>& refined,
                    std::vector<Seed_curve>& seeds, const Certify& certify, const Progress& on_step)
  {
    std::size_t steps_before = 0;
    const std::size_t steps = Prominence_meter::steps_of_curve * found.size();
    std::vector<Found_curve> added; // not measured yet
    for(std::size_t number_distinct = 0;;)
    {
      merge_coinciding(m_network, found, number_distinct);
      number_distinct = found.size();
      m_entries.resize(refined.size());
      if(added.empty())
      {
        break_rings(found, added);
        mend_wrong_ends(found);
        part_places(found);
      }
      std::vector<Index> asked; // curves of the network
      for(const Found_curve& f : found)
        if(!entry(f.curve))
          asked.push_back(f.curve);
      for(const Found_curve& f : added)
        asked.push_back(f.curve);
      if(asked.empty())
        return number_of_passed_seeds();
      std::vector<Found_curve> next = measure<ConcurrencyTag>(asked, found, refined, seeds, [&](std::size_t done) {
        if(steps_before + done <= steps)
          on_step(steps_before + done);
      });
      steps_before += Prominence_meter::steps_of_curve * asked.size();
      std::vector<Found_curve> held;
      for(const Found_curve& f : added)
      {
        if(m_network.is_empty(f.curve))
          continue;
        const Entry& e = *entry(f.curve);
        if(e.prominence < negligible_prominence && e.slides_off == null_index && e.has_end)
          m_passed.push_back(f.curve);
        else
        {
          held.push_back(f);
          m_held.emplace(f.curve, e);
        }
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
    const std::vector<std::size_t> rank = ranks(found);
    std::vector<Hierarchy_entry> result;
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Entry& e = *entry(found[i].curve);
      const Entry& last = last_on_way(e, place);
      Hierarchy_entry h = {e.prominence, std::nullopt, e.separates ? last.slides_off : null_index, e.has_end};
      const auto to = place.find(last.slides_to);
      if(to != place.end() && rank[to->second] < rank[i])
        h.dominated_by = to->second;
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
    bool separates;
    bool is_tie = false; // it slides to a curve of the same length
    Index slides_off = null_index;
    std::size_t slides_to = none; // seed of the curve
    std::uint64_t place = 0;      // see `Prominence`
  };

  // Where a curve comes from that has been added.
  struct Origin
  {
    Index from;         // the curve that slides to it
    std::uint64_t hash; // of the curve, as it was added
  };

  std::size_t number_of_passed_seeds() const
  {
    std::size_t sum = 0;
    for(Index c : m_passed)
      if(!m_network.is_empty(c))
        sum += m_network.curve(c).seeds.size();
    return sum;
  }

  // Ways along skipped and dropped curves may come back, as lengths that differ by less than a tolerance count as equal:
  // each of three curves may stand for the one before. Then the first skipped curve of such a ring joins `added`, to be
  // measured again, without ties. If each has been already, or if all have been dropped, the ring is cut.
  void break_rings(const std::vector<Found_curve>& found, std::vector<Found_curve>& added)
  {
    const std::unordered_map<std::size_t, std::size_t> place = places_by_seed(found);
    const auto next = [&](Index c) {
      const Entry* const e = entry(c);
      return e == nullptr || e->slides_to == none || place.count(e->slides_to) > 0 ? null_index
                                                                                   : m_curves.at(e->slides_to);
    };
    std::unordered_map<Index, std::size_t> way_of; // the number of the first way that passes a curve
    std::vector<Index> starts = m_passed;
    for(const Found_curve& f : found)
      starts.push_back(next(f.curve));
    for(std::size_t way = 0; way < starts.size(); ++way)
    {
      Index c = starts[way];
      while(c != null_index && way_of.emplace(c, way).second)
        c = next(c);
      if(c == null_index || way_of.at(c) != way)
        continue;
      Index first = null_index;
      Index d = c;
      do
      {
        if(!m_network.is_empty(d) && m_without_ties.count(d) == 0 &&
           (first == null_index || tie_key(m_network, d) < tie_key(m_network, first)))
          first = d;
        d = next(d);
      } while(d != c);
      if(first == null_index)
      {
        entry(c)->slides_to = none;
        continue;
      }
      m_without_ties.insert(first);
      forget(first);
      m_passed.erase(std::remove(m_passed.begin(), m_passed.end(), first), m_passed.end());
      added.push_back({first, m_network.length(first), 0, Certificate()});
    }
  }

  // The curve that a curve slides to may have been corrected to the curve itself, number `i` of those found: they were
  // twins for floating point alone. Then the way goes on from there as it was measured before the correction.
  void go_on_from_itself(Index curve, std::size_t i, const std::unordered_map<std::size_t, std::size_t>& place)
  {
    std::optional<Entry>* first = nullptr;
    for(std::size_t r : m_network.curve(curve).seeds)
    {
      if(!m_entries[r])
        continue;
      if(first == nullptr)
      {
        first = &m_entries[r];
        if((*first)->slides_to == none || destination(**first, place) != i)
          return;
      }
      else if(const std::size_t to = destination(*m_entries[r], place); to != i && to != none)
      {
        const double prominence = (std::max)((*first)->prominence, m_entries[r]->prominence);
        *first = m_entries[r];
        (*first)->prominence = prominence;
        return;
      }
    }
  }

  // The curve that a curve slides to may have been corrected to the curve itself, or to one of the same length that
  // does not stand for it. Two curves of the same length slide to each other over the same barrier; so of all curves
  // that are connected in this way the first one takes the others. If its only end is one of them, or if it has none,
  // it is measured again, once, without ties.
  void mend_wrong_ends(const std::vector<Found_curve>& found)
  {
    const std::unordered_map<std::size_t, std::size_t> place = places_by_seed(found);
    const std::vector<std::size_t> rank = ranks(found);
    std::vector<std::size_t> order(found.size());
    std::vector<bool> is_wrong(found.size(), false);
    std::vector<std::vector<std::pair<std::size_t, double>>> ties(found.size()); // to which ones, over which barrier
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      order[rank[i]] = i;
      go_on_from_itself(found[i].curve, i, place);
      const Entry* const e = entry(found[i].curve);
      if(e == nullptr)
        continue;
      if(e->slides_to != none)
      {
        const std::size_t to = destination(*e, place);
        is_wrong[i] = to == none ? e->is_tie : rank[to] >= rank[i];
      }
      for(std::size_t r : m_network.curve(found[i].curve).seeds)
      {
        if(!m_entries[r] || !m_entries[r]->is_tie)
          continue;
        const std::size_t to = destination(*m_entries[r], place);
        if(to == none || to == i ||
           std::abs(found[i].length - found[to].length) > equal_length_tolerance * found[i].length)
          continue;
        ties[i].emplace_back(to, m_entries[r]->prominence);
        ties[to].emplace_back(i, m_entries[r]->prominence);
      }
    }
    std::vector<bool> is_taken(found.size(), false);
    for(std::size_t first : order)
    {
      if(is_taken[first])
        continue;
      if(is_wrong[first] && m_without_ties.insert(found[first].curve).second)
        forget(found[first].curve);
      is_taken[first] = true;
      std::vector<std::pair<std::size_t, double>> stack(1, {first, 0}); // and the height of the way to the first
      while(!stack.empty())
      {
        const std::pair<std::size_t, double> from = stack.back();
        stack.pop_back();
        for(const std::pair<std::size_t, double>& tie : ties[from.first])
        {
          if(is_taken[tie.first])
            continue;
          is_taken[tie.first] = true;
          stack.emplace_back(tie.first, (std::max)(from.second, tie.second));
          if(!is_wrong[tie.first])
            continue;
          Entry e;
          e.separates = entry(found[tie.first].curve)->separates;
          e.prominence = stack.back().second;
          e.has_end = true;
          e.is_tie = true;
          e.slides_to = m_network.curve(found[first].curve).seeds.front();
          forget(found[tie.first].curve);
          m_entries[m_network.curve(found[tie.first].curve).seeds.front()] = e;
        }
      }
    }
  }

  // Curves that become one on the level on which they are measured all get the prominence of that curve. The first of
  // them keeps it. The barriers between it and the others are too fine for the level, and are searched on the input.
  void part_places(const std::vector<Found_curve>& found)
  {
    const std::vector<std::size_t> rank = ranks(found);
    std::vector<std::size_t> order(found.size());
    for(std::size_t i = 0; i < found.size(); ++i)
      order[rank[i]] = i;
    std::unordered_set<std::uint64_t> places;
    for(std::size_t i : order)
    {
      const Entry* const e = entry(found[i].curve);
      if(e == nullptr || e->place == 0 || e->prominence < negligible_prominence || places.insert(e->place).second ||
         !m_on_input.insert(found[i].curve).second)
        continue;
      forget(found[i].curve);
    }
  }

  void forget(Index curve)
  {
    for(std::size_t r : m_network.curve(curve).seeds)
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

  // The places of curves, which are sorted by length, in an order in which of those of the same length the one that
  // stands for all comes first. A dominating curve comes before the dominated one, so that every way along dominating
  // curves ends.
  std::vector<std::size_t> ranks(const std::vector<Found_curve>& found) const
  {
    std::vector<std::size_t> order(found.size()), result(found.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    for(std::size_t begin = 0, end = 0; begin < found.size(); begin = end)
    {
      do
      {
        ++end;
      } while(end < found.size() &&
              found[end].length - found[end - 1].length <= equal_length_tolerance * found[end].length);
      std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(end),
                [&](std::size_t i, std::size_t j) {
                  return tie_key(m_network, found[i].curve) < tie_key(m_network, found[j].curve);
                });
    }
    for(std::size_t i = 0; i < order.size(); ++i)
      result[order[i]] = i;
    return result;
  }

  // The last entry on the way from one: of a curve that slides to one that is found, or to none that is known.
  const Entry& last_on_way(const Entry& from, const std::unordered_map<std::size_t, std::size_t>& found) const
  {
    const Entry* e = &from;
    while(e->slides_to != none && found.count(e->slides_to) == 0)
    {
      const Entry* const next = entry(m_curves.at(e->slides_to));
      if(next == nullptr)
        break;
      e = next;
    }
    return *e;
  }

  // The place of the curve found at the end of the way from an entry; `none` if there is none.
  std::size_t destination(const Entry& from, const std::unordered_map<std::size_t, std::size_t>& found) const
  {
    const auto at = found.find(last_on_way(from, found).slides_to);
    return at == found.end() ? none : at->second;
  }

  const Entry* entry(Index curve) const
  {
    for(std::size_t r : m_network.curve(curve).seeds)
      if(m_entries[r])
        return &*m_entries[r];
    const auto held = m_held.find(curve);
    return held != m_held.end() && m_network.is_empty(curve) ? &held->second : nullptr;
  }

  Entry* entry(Index curve) { return const_cast<Entry*>(std::as_const(*this).entry(curve)); }

  // Whether the way to a new curve has passed the same curve before, where it has been dropped or corrected since. Linear
  // in the number of curves on the way.
  bool has_come_back(Index curve) const
  {
    const Origin& end = m_added.at(curve);
    for(auto at = m_added.find(end.from); at != m_added.end(); at = m_added.find(at->second.from))
      if(at->second.hash == end.hash)
        return true;
    return false;
  }

  // Writes the entries of curves of the network, and calls on_step() as `Prominence_meter` does. Returns new curves that
  // they slide to.
  template <class ConcurrencyTag, class Progress>
  std::vector<Found_curve> measure(const std::vector<Index>& asked, const std::vector<Found_curve>& found,
                                   std::vector<Refined_curve>& refined, std::vector<Seed_curve>& seeds,
                                   const Progress& on_step)
  {
    std::vector<Measured_curve> curves;
    for(Index c : asked)
      curves.push_back({arcs_of_curve(m_network, c),
                        {},
                        m_network.length(c),
                        false,
                        m_without_ties.count(c) == 0,
                        m_on_input.count(c) > 0});
    CGAL::for_each<ConcurrencyTag>(curves, [&](Measured_curve& c) {
      c.trace = accurate_trace(m_pm, c.arcs);
      c.separates = m_sides.part(c.trace).is_separating();
      return true;
    });
    const std::vector<Prominence> prominences = m_meter.measure<ConcurrencyTag>(curves, on_step);

    Distinct_curves distinct(m_network);
    for(const Found_curve& f : found)
      if(entry(f.curve) != nullptr)
        distinct.insert(f.curve);
    for(Index c : asked)
      distinct.insert(c);
    // a curve that is not among those found gives way to an equal one that is
    for(Index c : m_passed)
      if(!m_network.is_empty(c))
        distinct.insert(c);
    std::vector<Found_curve> added;
    for(std::size_t i = 0; i < asked.size(); ++i)
    {
      if(m_network.is_empty(asked[i]))
        continue;
      const Prominence& p = prominences[i];
      Entry e;
      e.prominence = p.value;
      e.has_end = p.end != Barrier_end::NONE;
      e.separates = curves[i].separates;
      e.slides_off = p.vertex;
      e.place = p.place;
      if(p.end == Barrier_end::CURVE)
      {
        e.slides_to = refined.size();
        e.is_tie = p.length >= curves[i].length * (1 - equal_length_tolerance);
        const Index c = m_network.add_curve(refined.size());
        std::vector<Arc> arcs = p.arcs;
        m_network.set_arcs(c, arcs);
        refined.push_back(Refined_curve{curve_of_arcs(p.arcs), {seeds.size()}, false});
        seeds.push_back(Seed_curve{0, p.path, Seed_origin::BARRIER});
        const Index known = distinct.insert(c);
        m_curves.emplace(e.slides_to, known);
        if(known == c)
        {
          added.push_back({c, m_network.length(c), 0, Certificate()});
          m_added.emplace(c, Origin{asked[i], m_network.curve(c).hash});
          if(has_come_back(c))
            m_without_ties.insert(c);
        }
      }
      m_entries[m_network.curve(asked[i]).seeds.front()] = e;
    }
    m_entries.resize(refined.size());
    return added;
  }

  const Progressive_mesh& m_pm;
  const Surface_sides& m_sides;
  Curve_network& m_network;
  Prominence_meter m_meter;
  std::vector<std::optional<Entry>> m_entries;     // by seed: set for one seed of each curve that has been measured
  std::unordered_map<std::size_t, Index> m_curves; // by seed: that a curve that was measured slides to
  std::unordered_map<Index, Origin> m_added;       // by curve of the network
  std::unordered_set<Index> m_without_ties;        // curves of the network
  std::unordered_set<Index> m_on_input;            // curves of the network whose neighbours are looked for on the input
  std::vector<Index> m_passed;                     // curves of the network that are not found, but were measured
  std::unordered_map<Index, Entry> m_held;         // as measured, of curves of the network that may have been dropped
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_DETECTED_HIERARCHY_H
