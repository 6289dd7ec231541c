// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_NETWORK_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_NETWORK_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/splitmix64.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Closed curves on the current surface of a progressive mesh: each a cyclic list of arcs from pivot to pivot. Arcs have
// ids; an id is used again after its arc is gone. Optionally with an index from faces to the arcs in them.
class Curve_network
{
public:
  // An arc in its curve's list.
  struct Node
  {
    Arc arc;
    Index curve, previous, next;
    std::uint64_t hash; // as it was when the arc was entered
    Index last_face;    // on the other side of the edge, or of the last crossing, when the arc was entered
    Index stamp = 0;    // changes each time the id is given to another arc, or taken from one
  };

  struct Curve
  {
    Index first = null_index; // any of its arcs
    std::size_t size = 0;     // number of arcs
    std::uint64_t hash = 0;   // of its pivots and crossed edges, whatever the order and direction
    std::vector<std::size_t> seeds;
  };

  Curve_network(const Progressive_mesh& pm, bool with_face_index) : m_pm(pm)
  {
    if(with_face_index)
      m_arcs_of_face.assign(pm.number_of_face_ids(), null_index);
  }

  const Progressive_mesh& surface() const { return m_pm; }

  const Node& node(Index id) const { return m_nodes[id]; }

  // Tells a queue of arcs whether an id still means the same arc; renewed on demand.
  Index stamp(Index id) const { return m_nodes[id].stamp; }
  Index renew_stamp(Index id) { return ++m_nodes[id].stamp; }

  const Arc& arc(Index id) const { return m_nodes[id].arc; }
  Index next(Index id) const { return m_nodes[id].next; }
  Index previous(Index id) const { return m_nodes[id].previous; }

  std::size_t number_of_curve_ids() const { return m_curves.size(); }
  const Curve& curve(Index c) const { return m_curves[c]; }
  bool is_empty(Index c) const { return m_curves[c].size == 0; }

  // Makes room for this number of arcs.
  void reserve(std::size_t arcs) { m_nodes.reserve(arcs); }

  // Adds a curve without arcs.
  Index add_curve(std::size_t seed) { return add_curve(std::vector<std::size_t>(1, seed)); }
  Index add_curve(std::vector<std::size_t> seeds)
  {
    m_curves.emplace_back();
    m_curves.back().seeds = std::move(seeds);
    return static_cast<Index>(m_curves.size() - 1);
  }

  // Adds a curve along edges. The path's vertices must be joined by edges.
  Index add_curve(std::size_t seed, const std::vector<Index>& path)
  {
    const Index c = add_curve(seed);
    std::vector<Arc> arcs(path.size());
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      arcs[i].from = path[i];
      arcs[i].to = path[(i + 1) % path.size()];
      arcs[i].along = m_pm.halfedge(arcs[i].from, arcs[i].to);
      CGAL_assertion(arcs[i].along != null_index);
      measure(m_pm, arcs[i]);
    }
    set_arcs(c, arcs);
    return c;
  }

  // Gives the curve these arcs instead of those that it has, in this cyclic order.
  void set_arcs(Index c, std::vector<Arc>& arcs)
  {
    while(m_curves[c].size != 0)
      erase(m_curves[c].first);
    Index last = null_index;
    for(Arc& a : arcs)
      last = insert_after(c, last, std::move(a));
  }

  // As above, and the curve starts with the first of them.
  void set_arcs_in_order(Index c, std::vector<Arc>& arcs)
  {
    set_arcs(c, arcs);
    if(m_curves[c].size != 0)
      m_curves[c].first = next(m_curves[c].first);
  }

  // Replaces the arcs from `first` to `last` by a path with the same ends. If these are all arcs of the curve, the path
  // must be closed. Returns the arc before the new ones, or null_index if there is no other arc left.
  Index replace(Index first, Index last, std::vector<Arc>& arcs)
  {
    const Index c = m_nodes[first].curve;
    Index before = previous(first);
    bool all = false;
    for(Index id = first;;)
    {
      all = all || id == before;
      const Index n = next(id);
      const bool done = id == last;
      erase(id);
      if(done)
        break;
      id = n;
    }
    if(all)
      before = null_index;
    Index end = before;
    for(Arc& a : arcs)
      end = insert_after(c, end, std::move(a));
    return before;
  }

  // Makes `from` lose its arcs and hands its seeds to `to`.
  void merge(Index from, Index to)
  {
    m_curves[to].seeds.insert(m_curves[to].seeds.end(), m_curves[from].seeds.begin(), m_curves[from].seeds.end());
    remove(from);
  }

  // Makes the curve lose its arcs and seeds.
  void remove(Index c)
  {
    while(m_curves[c].size != 0)
      erase(m_curves[c].first);
    m_curves[c].seeds.clear();
    m_curves[c].seeds.shrink_to_fit();
  }

  double length(Index c) const
  {
    double sum = 0;
    for_each_arc(c, [&](Index id) { sum += arc(id).length; });
    return sum;
  }

  // Calls f for the id of each arc of the curve, in order.
  template <class F>
  void for_each_arc(Index c, F f) const
  {
    const Curve& curve = m_curves[c];
    Index id = curve.first;
    for(std::size_t i = curve.size; i > 0; --i)
    {
      const Index n = next(id);
      f(id);
      id = n;
    }
  }

  // Calls f for the id of each arc that passes through the face or along one of its edges, once for each passage.
  template <class F>
  void for_each_arc_in_face(Index face, F f) const
  {
    for(Index e = m_arcs_of_face[face]; e != null_index; e = m_entries[e].next)
      f(m_entries[e].arc);
  }

  // Whether two curves have the same pivots and crossed edges in the same cyclic sequence, in either direction.
  bool are_equal(Index c, Index d) const
  {
    if(m_curves[c].hash != m_curves[d].hash || m_curves[c].size != m_curves[d].size)
      return false;
    std::vector<std::pair<Index, Index>> s = signature(c), t = signature(d);
    if(s.size() != t.size())
      return false;
    const std::size_t n = s.size();
    for(int direction = 0; direction < 2; ++direction)
    {
      for(std::size_t shift = 0; shift < n; ++shift)
      {
        std::size_t i = 0;
        while(i < n && s[i] == t[(shift + i) % n])
          ++i;
        if(i == n)
          return true;
      }
      t = std::vector<std::pair<Index, Index>>(t.rbegin(), t.rend());
    }
    return false;
  }

private:
  struct Entry
  {
    Index arc, next;
  };

  // (0, pivot) and (1, crossed edge), in order
  std::vector<std::pair<Index, Index>> signature(Index c) const
  {
    std::vector<std::pair<Index, Index>> s;
    for_each_arc(c, [&](Index id) {
      s.emplace_back(0, arc(id).from);
      for(Index h : arc(id).crossings)
        s.emplace_back(1, m_pm.edge(h));
    });
    return s;
  }

  std::uint64_t hash(const Arc& a) const
  {
    std::uint64_t sum = splitmix64(2 * static_cast<std::uint64_t>(a.from));
    for(Index h : a.crossings)
      sum += splitmix64(2 * static_cast<std::uint64_t>(m_pm.edge(h)) + 1);
    return sum;
  }

  // The faces that an arc was in when it was entered, whatever has been glued or split since.
  template <class F>
  void for_each_face(const Node& n, F f) const
  {
    if(n.arc.is_edge())
      f(m_pm.face(n.arc.along));
    for(Index h : n.arc.crossings)
      f(m_pm.face(h));
    f(n.last_face);
  }

  Index insert_after(Index c, Index before, Arc arc)
  {
    Index id;
    if(m_free_nodes.empty())
    {
      id = static_cast<Index>(m_nodes.size());
      m_nodes.emplace_back();
    }
    else
    {
      id = m_free_nodes.back();
      m_free_nodes.pop_back();
    }
    Node& n = m_nodes[id];
    n.arc = std::move(arc);
    n.curve = c;
    ++n.stamp;
    Curve& curve = m_curves[c];
    if(before == null_index)
    {
      CGAL_assertion(curve.size == 0);
      n.previous = n.next = id;
    }
    else
    {
      n.previous = before;
      n.next = m_nodes[before].next;
      m_nodes[n.next].previous = id;
      m_nodes[before].next = id;
    }
    curve.first = id;
    ++curve.size;
    n.hash = hash(n.arc);
    n.last_face = m_pm.face(m_pm.opposite(n.arc.is_edge() ? n.arc.along : n.arc.crossings.back()));
    curve.hash += n.hash;
    if(!m_arcs_of_face.empty())
      for_each_face(n, [&](Index f) { enter(f, id); });
    return id;
  }

  void erase(Index id)
  {
    Node& n = m_nodes[id];
    Curve& curve = m_curves[n.curve];
    curve.hash -= n.hash;
    if(!m_arcs_of_face.empty())
      for_each_face(n, [&](Index f) { leave(f, id); });
    m_nodes[n.previous].next = n.next;
    m_nodes[n.next].previous = n.previous;
    curve.first = n.next;
    if(--curve.size == 0)
      curve.first = null_index;
    n.arc.crossings.clear();
    n.curve = null_index;
    ++n.stamp;
    m_free_nodes.push_back(id);
  }

  void enter(Index face, Index arc)
  {
    Index e;
    if(m_free_entry != null_index)
    {
      e = m_free_entry;
      m_free_entry = m_entries[e].next;
    }
    else
    {
      e = static_cast<Index>(m_entries.size());
      m_entries.emplace_back();
    }
    m_entries[e] = Entry{arc, m_arcs_of_face[face]};
    m_arcs_of_face[face] = e;
  }

  void leave(Index face, Index arc)
  {
    Index* link = &m_arcs_of_face[face];
    while(m_entries[*link].arc != arc)
      link = &m_entries[*link].next;
    const Index e = *link;
    *link = m_entries[e].next;
    m_entries[e].next = m_free_entry;
    m_free_entry = e;
  }

  const Progressive_mesh& m_pm;
  std::vector<Node> m_nodes;
  std::vector<Index> m_free_nodes;
  std::vector<Curve> m_curves;
  std::vector<Index> m_arcs_of_face; // the first entry of a face; empty if there is no index
  std::vector<Entry> m_entries;
  Index m_free_entry = null_index;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_NETWORK_H
