// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_FRONT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_FRONT_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Distances of vertices from a closed curve on its two sides, the nearest vertex first: fast marching (Kimmel and
// Sethian 1998). The fronts do not cross the curve. A front is taken to be straight in each face; where it comes through
// an edge so that it misses the third corner of the face, that corner gets its distance through or along another edge.
//
// The two sides of a curve that does not separate meet. A vertex then belongs to the side that reaches it first, if
// both are settled in the order of their distances; the other side still measures its distance there, but goes no
// further. So both distances are known at all corners of the faces in which the sides meet.
//
// The arrays are made once for a mesh, and restarted in constant time. Sweeps are numbered from 1.
class Distance_front
{
public:
  Distance_front(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_lengths(lengths), m_vertices{{Zeroed_array<Vertex>(pm.number_of_vertex_ids()),
                                                Zeroed_array<Vertex>(pm.number_of_vertex_ids())}},
      m_barred(pm.number_of_face_ids())
  {}

  // Forgets everything.
  void restart()
  {
    ++m_sweep;
    for(std::size_t side = 0; side < 2; ++side)
    {
      m_queue[side] = Queue();
      m_reached[side] = 0;
    }
  }

  // Keeps the fronts from crossing a face. They never cross a ghost.
  void bar(Index f) { m_barred[f] = m_sweep; }
  bool is_barred(Index f) const { return m_barred[f] == m_sweep || m_pm.is_ghost_face(f); }

  bool is_settled(Index v, std::size_t side) const
  {
    const Vertex& x = m_vertices[side][v];
    return x.sweep == m_sweep && x.settled;
  }

  // whether a vertex is settled on a side, and was not settled earlier on the other one; a source belongs to both
  bool belongs_to(Index v, std::size_t side) const { return is_settled(v, side) && m_vertices[side][v].first; }

  // of a vertex settled on a side
  double distance(Index v, std::size_t side) const { return m_vertices[side][v].distance; }

  // the distance up to which a side has been swept
  double reached(std::size_t side) const { return m_reached[side]; }

  // Settles a vertex on both sides at distance 0.
  void settle_source(Index v)
  {
    for(Zeroed_array<Vertex>& side : m_vertices)
      side[v] = {0, m_sweep, true, true};
  }

  // Notes that a vertex is no further than this from the sources on a side.
  void offer(Index v, double distance, std::size_t side)
  {
    Vertex& x = m_vertices[side][v];
    if(x.sweep == m_sweep && (x.settled || x.distance <= distance))
      return;
    x = {distance, m_sweep, false, false};
    m_queue[side].push(Entry{distance, v});
  }

  // Offers distances to the corners of a face that are not settled, from those that are.
  void pass_through(Index f, std::size_t side)
  {
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(is_settled(m_pm.source(h), side))
        pass_from_source(h, side);
  }

  // The distance of the nearest vertex of a side that is not settled; infinity if there is none.
  double next_distance(std::size_t side)
  {
    Queue& queue = m_queue[side];
    while(!queue.empty())
    {
      const Entry& e = queue.top();
      const Vertex& x = m_vertices[side][e.vertex];
      if(!x.settled && x.distance == e.distance)
        return e.distance;
      queue.pop();
    }
    return (std::numeric_limits<double>::infinity)();
  }

  // Settles the nearest vertex of a side that is not settled. Returns null_index if there is none.
  Index settle_next(std::size_t side)
  {
    if(next_distance(side) == (std::numeric_limits<double>::infinity)())
      return null_index;
    const Index v = m_queue[side].top().vertex;
    m_queue[side].pop();
    Vertex& x = m_vertices[side][v];
    // fast marching is not quite monotone, what follows relies on it
    m_reached[side] = x.distance = (std::max)(x.distance, m_reached[side]);
    x.settled = true;
    x.first = !is_settled(v, 1 - side);
    if(x.first)
    {
      const Index begin = m_pm.outgoing(v);
      Index h = begin;
      do
      {
        pass_from_source(h, side);
        h = m_pm.ccw(h);
      } while(h != begin);
    }
    return v;
  }

private:
  struct Vertex
  {
    double distance;
    Index sweep; // the one that the other members are of
    bool settled;
    bool first; // settled before the other side settled it
  };

  struct Entry
  {
    double distance;
    Index vertex;

    friend bool operator<(const Entry& a, const Entry& b) // the top of the queue is the greatest
    {
      return a.distance != b.distance ? a.distance > b.distance : a.vertex > b.vertex;
    }
  };

  typedef std::priority_queue<Entry> Queue;

  // Offers distances into the face of a halfedge whose source is settled.
  void pass_from_source(Index h, std::size_t side)
  {
    if(is_barred(m_pm.face(h)))
      return;
    const double distance = m_vertices[side][m_pm.source(h)].distance;
    const Index last = m_pm.prev(h), u = m_pm.target(h), w = m_pm.source(last);
    if(!is_settled(u, side))
      offer(u, distance + m_lengths[h], side);
    else
      pass_edge(h, side);
    if(!is_settled(w, side))
      offer(w, distance + m_lengths[last], side);
    else
      pass_edge(last, side);
  }

  // A straight front comes through the edge of h, whose ends are settled, into the face of h. If one of its rays hits
  // the third corner, offers the corner its distance. If all miss it, the corner is not obtuse: it would be nearer to
  // the first end of the edge than the second end is, and settled before that.
  void pass_edge(Index h, std::size_t side)
  {
    const Index corner = m_pm.source(m_pm.prev(h));
    if(is_barred(m_pm.face(h)) || is_settled(corner, side))
      return;
    const Zeroed_array<Vertex>& vertices = m_vertices[side];
    const Index p = m_pm.source(h), q = m_pm.target(h);
    const double length = m_lengths[h], s = (vertices[q].distance - vertices[p].distance) / length;
    if(!(std::abs(s) < 1))
      return;
    const Vector2 direction = {s, std::sqrt(1 - s * s)}; // of the rays; the edge runs along the x axis
    const double to_q = m_lengths[Progressive_mesh::next(h)], to_p = m_lengths[Progressive_mesh::prev(h)];
    Vector2 apex;
    apex.x = (length * length + to_p * to_p - to_q * to_q) / (2 * length);
    apex.y = std::sqrt((std::max)(to_p * to_p - apex.x * apex.x, 0.));
    const double foot = apex.x - apex.y * direction.x / direction.y; // where the ray comes from
    if(foot >= 0 && foot <= length)
      offer(corner, vertices[p].distance + dot(direction, apex), side);
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  std::array<Zeroed_array<Vertex>, 2> m_vertices; // by side
  Zeroed_array<Index> m_barred;                   // the last sweep that a face was barred in
  std::array<Queue, 2> m_queue;
  std::array<double, 2> m_reached = {{0, 0}};
  Index m_sweep = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_FRONT_H
