// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_REFINEMENT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_REFINEMENT_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Carries the curves of a network over one vertex split (Sections 4.2 and 4.3 of the paper). Only arcs through the open
// star of the vertex that is split are computed anew, between the nearest pivots.
class Refinement
{
public:
  Refinement(Progressive_mesh& pm, Curve_network& network, const Length_unit& unit)
    : m_pm(pm), m_network(network), m_unit(unit), m_puller(pm)
  {}

  // Undoes the last collapse and carries all curves over. Calls before_change(c) for each curve c that is touched.
  // `changed` gets these curves, ascending, and `pivots` the arcs whose starting pivots have new neighbours.
  // O(degree) if no curve is touched, otherwise linear in the lengths of the strips between the nearest pivots.
  template <class Before_change>
  void split(std::vector<Index>& changed, std::vector<Index>& pivots, Before_change before_change)
  {
    changed.clear();
    pivots.clear();
    find_touched_arcs();
    if(m_touched.empty())
    {
      m_pm.split();
      return;
    }

    m_jobs.clear();
    for(Index id : m_touched)
    {
      const Index c = m_network.node(id).curve;
      if(changed.empty() || changed.back() != c)
      {
        changed.push_back(c);
        before_change(c);
        plan(c);
      }
    }
    const Glued_edges glued = glued_edges();
    m_pm.split();
    for(Job& job : m_jobs)
    {
      for(Strip& strip : job.strips)
        unglue(strip, glued);
      const Index c = m_network.node(job.first).curve;
      if(job.is_loops)
        reopen_loops(job);
      else
        straighten(job);
      const std::size_t count = m_arcs.size();
      Index id = m_network.replace(job.first, job.last, m_arcs);
      if(id == null_index)
        m_network.for_each_arc(c, [&pivots](Index a) { pivots.push_back(a); });
      else
        for(std::size_t i = 0; i <= count; ++i)
          pivots.push_back(id = m_network.next(id));
    }
  }

private:
  // Consecutive arcs that have to be computed anew.
  struct Job
  {
    Index first, last;
    bool is_loops = false;     // the vertex that is split is the only pivot
    std::vector<Strip> strips; // those to choose from, or one for each loop
  };

  // The two edges that the collapse made of two each. A curve that crossed one of them by the first halfedge now
  // crosses one of the two edges by it, and then the other by the second halfedge.
  typedef std::array<std::pair<Index, Index>, 4> Glued_edges;

  // The arcs through the inside of the star of the vertex that is split, by curve. Not those along its boundary.
  void find_touched_arcs()
  {
    m_touched.clear();
    m_centre = m_pm.next_split().kept;
    const Index begin = m_pm.outgoing(m_centre);
    Index h = begin;
    do
    {
      m_network.for_each_arc_in_face(m_pm.face(h), [&](Index id) {
        const Arc& a = m_network.arc(id);
        if(!a.is_edge() || a.from == m_centre || a.to == m_centre)
          m_touched.push_back(id);
      });
      h = m_pm.ccw(h);
    } while(h != begin);
    std::sort(m_touched.begin(), m_touched.end(), [this](Index a, Index b) { return key(a) < key(b); });
    m_touched.erase(std::unique(m_touched.begin(), m_touched.end()), m_touched.end());
  }

  std::pair<Index, Index> key(Index arc) const { return std::make_pair(m_network.node(arc).curve, arc); }

  bool is_touched(Index arc) const
  {
    return std::binary_search(m_touched.begin(), m_touched.end(), arc,
                              [this](Index a, Index b) { return key(a) < key(b); });
  }

  // Notes the strips from which the touched arcs of a curve are computed anew.
  void plan(Index c)
  {
    const Index begin = first_from_another_pivot(c);
    if(begin == null_index)
    {
      Job job;
      job.is_loops = true;
      m_network.for_each_arc(c, [&](Index id) {
        job.strips.emplace_back(m_network.arc(id).crossings.begin(), m_network.arc(id).crossings.end());
      });
      job.first = m_network.curve(c).first;
      job.last = m_network.previous(job.first);
      m_jobs.push_back(std::move(job));
      return;
    }
    Index id = begin;
    do
    {
      Job job;
      job.first = job.last = id;
      while(m_network.arc(job.last).to == m_centre)
        job.last = m_network.next(job.last);
      id = m_network.next(job.last);
      if(!is_touched(job.first))
        continue;
      job.strips.push_back(strip_past_centre(job, Curve_side::LEFT));
      if(job.first != job.last)
        job.strips.push_back(strip_past_centre(job, Curve_side::RIGHT));
      m_jobs.push_back(std::move(job));
    } while(id != begin);
  }

  Index first_from_another_pivot(Index c) const
  {
    Index found = null_index;
    m_network.for_each_arc(c, [&](Index id) {
      if(found == null_index && m_network.arc(id).from != m_centre)
        found = id;
    });
    return found;
  }

  // The faces from the start of the job's first arc to the end of its last one, past the vertex that is split on the
  // given side (Figure 6 of the paper).
  Strip strip_past_centre(const Job& job, Curve_side side) const
  {
    Strip strip;
    for(Index id = job.first;; id = m_network.next(id))
    {
      const Arc& arc = m_network.arc(id);
      strip.insert(strip.end(), arc.crossings.begin(), arc.crossings.end());
      if(id == job.last)
        return strip;
      const Arc& following = m_network.arc(m_network.next(id));
      append_fan(m_pm, arc, following, is_hole_on_side(m_pm, arc, following, side) ? other_side(side) : side, strip);
    }
  }

  Glued_edges glued_edges() const
  {
    const Progressive_mesh::Split s = m_pm.next_split();
    const Index h1 = m_pm.next(s.left), h2 = m_pm.prev(s.left), o1 = m_pm.next(s.right), o2 = m_pm.prev(s.right);
    return {{{m_pm.opposite(h1), h2}, {m_pm.opposite(h2), h1}, {m_pm.opposite(o1), o2}, {m_pm.opposite(o2), o1}}};
  }

  // Inserts the faces that the split put into a strip.
  void unglue(Strip& strip, const Glued_edges& glued)
  {
    m_strip.clear();
    for(Index h : strip)
    {
      m_strip.push_back(h);
      for(const std::pair<Index, Index>& g : glued)
        if(g.first == h)
          m_strip.push_back(g.second);
    }
    strip.swap(m_strip);
  }

  // Computes m_arcs: the shortest path of the best strip.
  void straighten(Job& job)
  {
    const Index from = m_network.arc(job.first).from, to = m_network.arc(job.last).to;
    m_arcs.clear();
    m_puller.pull(from, job.strips[0], to, m_arcs);
    if(job.strips.size() == 1)
      return;
    m_other_arcs.clear();
    m_puller.pull(from, job.strips[1], to, m_other_arcs);
    if(m_unit(m_other_arcs) < m_unit(m_arcs))
      m_arcs.swap(m_other_arcs);
  }

  // Computes m_arcs (Figure 5 of the paper): each loop keeps its faces, and where one ends at another end of the new
  // edge than the next one starts, that edge joins them.
  void reopen_loops(Job& job)
  {
    m_arcs.clear();
    const Index start = start_of(job.strips.front());
    for(std::size_t i = 0; i < job.strips.size(); ++i)
    {
      Strip& strip = job.strips[i];
      const Index from = start_of(strip), to = m_pm.source(m_pm.prev(m_pm.opposite(strip.back())));
      const Index following = i + 1 < job.strips.size() ? start_of(job.strips[i + 1]) : start;
      m_puller.pull(from, strip, to, m_arcs);
      if(to == following)
        continue;
      Arc edge;
      edge.from = to;
      edge.to = following;
      edge.along = m_pm.halfedge(to, following);
      measure(m_pm, edge);
      m_arcs.push_back(std::move(edge));
    }
  }

  Index start_of(const Strip& strip) const { return m_pm.source(m_pm.prev(strip.front())); }

  Progressive_mesh& m_pm;
  Curve_network& m_network;
  Length_unit m_unit;
  String_puller m_puller;
  Index m_centre = null_index;
  std::vector<Index> m_touched;
  std::vector<Job> m_jobs;
  Strip m_strip;
  std::vector<Arc> m_arcs, m_other_arcs;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_REFINEMENT_H
