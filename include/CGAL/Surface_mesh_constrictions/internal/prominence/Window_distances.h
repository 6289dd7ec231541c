// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_WINDOW_DISTANCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_WINDOW_DISTANCES_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Surface_metric.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A distance along a stretch of an edge, where the edge is the x axis: from a point of the plane that the faces on the
// way are unfolded into, or, of a plane wave, from a line. It is a convex function.
struct Wave
{
  double begin, end;
  Vector2 at;    // the point; of a plane wave the unit vector in which it moves
  double offset; // the distance of the point, or of the origin
  bool is_plane;

  double value(double x) const { return offset + (is_plane ? at.x * x : norm(Vector2{x - at.x, at.y})); }

  // the derivative, to the right of x if `forward`
  double slope(double x, bool forward) const
  {
    if(is_plane)
      return at.x;
    const double d = x - at.x, r = norm(Vector2{d, at.y});
    return r > 0 ? d / r : forward ? 1 : -1;
  }

  // the same wave, and the edge in the other direction
  Wave reversed(double length) const
  {
    if(is_plane)
      return {length - end, length - begin, {-at.x, at.y}, offset + at.x * length, true};
    return {length - end, length - begin, {length - at.x, at.y}, offset, false};
  }
};

// Exact geodesic distances, but for rounding, from a chain of edges on the boundary of a surface: the continuous
// Dijkstra method (Mitchell, Mount and Papadimitriou 1987). A window is the stretch of an edge that straight lines from
// one source reach through the same faces. The sources are the edges of the chain, from which lines start at right
// angles, and vertices at which shortest paths bend. Where the way through an end of its edge is shorter a window is
// trimmed, and nothing else is dropped; so no distance is ever too long.
class Window_distances
{
public:
  explicit Window_distances(const Surface_metric& surface) : m_surface(surface) {}

  // Computes the distances up to a greatest one from a chain of halfedges of the boundary. Near w log w for the w
  // windows that are made; these are as a rule a small multiple of the halfedges.
  void compute_from_chain(const std::vector<Index>& chain, double greatest)
  {
    restart(greatest);
    for(Index h : chain)
      for(Index v : {m_surface.source(h), m_surface.target(h)})
      {
        offer(v, 0);
        m_is_source[v] = !m_is_source[v]; // only the ends of the chain are met once
      }
    for(Index h : chain)
    {
      record(h, {0, m_surface.length(h), {0, 0}, 0, true});
      propagate(h, {0, m_surface.length(h), {0, 1}, 0, true});
    }
    finish();
  }

  // The distance of two vertices, or the greatest one, if that is less.
  double between_vertices(Index from, Index to, double greatest)
  {
    restart(greatest);
    m_is_source[from] = true;
    offer(from, 0);
    finish([&](double reached) { return m_vertices[to] <= reached; });
    return distance(to);
  }

  // the distance up to which distances have been computed
  double greatest() const { return m_greatest; }

  double distance(Index vertex) const { return (std::min)(m_vertices[vertex], m_greatest); }

  // Appends waves whose least value at each point of an edge is the distance of that point, or the greatest distance,
  // if that is less. The x axis runs along `Surface_metric::edge()`.
  void waves(Index edge, std::vector<Wave>& out) const
  {
    const double length = m_surface.length(edge);
    out.push_back({0, length, {0, 1}, m_greatest, true});
    const double from = m_vertices[m_surface.source(edge)], to = m_vertices[m_surface.target(edge)];
    if(from < m_greatest)
      out.push_back({0, length, {0, 0}, from, false});
    if(to < m_greatest)
      out.push_back({0, length, {length, 0}, to, false});
    for(Index i = m_first[edge]; i != null_index; i = m_waves[i].next)
      out.push_back(m_waves[i].wave);
  }

private:
  // A stretch of the edge of a halfedge through which lines leave the face of the halfedge. The x axis runs from the
  // target to the source, as along the opposite halfedge; the source of the lines has y <= 0.
  struct Window
  {
    Index halfedge;
    Wave wave;
  };

  struct Event
  {
    double distance;
    Index index; // of a vertex or of a window
    bool is_vertex;
    Index serial; // windows in the order in which they were made

    friend bool operator<(const Event& a, const Event& b) // the top of the queue is the greatest
    {
      if(a.distance != b.distance)
        return a.distance > b.distance;
      return a.is_vertex != b.is_vertex ? b.is_vertex : a.serial > b.serial;
    }
  };

  struct Recorded
  {
    Wave wave;
    Index next; // of the same edge
  };

  void restart(double greatest)
  {
    m_greatest = greatest;
    m_vertices.assign(m_surface.number_of_vertices(), (std::numeric_limits<double>::infinity)());
    m_is_source.assign(m_surface.number_of_vertices(), false);
    m_first.assign(m_surface.number_of_halfedges(), null_index);
    m_waves.clear();
  }

  void finish()
  {
    finish([](double) { return false; });
  }

  // Goes on until is_final(reached) is true: until all that is nearer than that is known.
  template <class Is_final>
  void finish(const Is_final& is_final)
  {
    while(!m_queue.empty())
    {
      const Event e = m_queue.top();
      if(is_final(e.distance))
        break;
      m_queue.pop();
      if(e.is_vertex)
      {
        if(e.distance == m_vertices[e.index])
          settle(e.index);
        continue;
      }
      Window w = m_windows[e.index];
      m_free.push_back(e.index);
      if(!trim(w))
        continue;
      const Index o = m_surface.opposite(w.halfedge);
      if(o == null_index || w.halfedge < o)
        record(w.halfedge, w.wave.reversed(m_surface.length(w.halfedge)));
      else
        record(o, w.wave);
      if(o != null_index)
        propagate(o, w.wave);
    }
    m_queue = std::priority_queue<Event>();
    m_windows.clear();
    m_free.clear();
  }

  // Lengths that differ by this share of a distance are equal but for rounding.
  static constexpr double equal_tolerance = 1e-13;
  // A corner that is missed by so little, relative to lengths, is hit: its distance is right to the square of this.
  static constexpr double corner_tolerance = 1e-10;

  // Notes that a vertex is no further than this.
  void offer(Index v, double distance)
  {
    if(distance >= m_vertices[v] || distance > m_greatest)
      return;
    m_vertices[v] = distance;
    m_queue.push({distance, v, true, v});
  }

  // What lies behind a vertex whose distance is final.
  void settle(Index v)
  {
    const double d = m_vertices[v];
    for(const Index* p = m_surface.outgoing_begin(v); p != m_surface.outgoing_end(v); ++p)
    {
      const Index h = *p, far = Surface_metric::next(h), last = Surface_metric::prev(h);
      offer(m_surface.target(h), d + m_surface.length(h));
      offer(m_surface.source(last), d + m_surface.length(last));
      if(!m_is_source[v] && !m_surface.bends(v))
        continue;
      const double length = m_surface.length(far);
      const Vector2 apex = m_surface.apex(far);
      add({far, {0, length, {length - apex.x, -apex.y}, d, false}});
    }
  }

  void record(Index edge, const Wave& wave)
  {
    m_waves.push_back({wave, m_first[edge]});
    m_first[edge] = static_cast<Index>(m_waves.size() - 1);
  }

  void add(Window w)
  {
    if(!trim(w))
      return;
    const Wave& wave = w.wave;
    const double nearest = wave.is_plane ? (std::min)(wave.value(wave.begin), wave.value(wave.end))
                                         : wave.value((std::min)((std::max)(wave.at.x, wave.begin), wave.end));
    if(nearest > m_greatest)
      return;
    Index i = static_cast<Index>(m_windows.size());
    if(m_free.empty())
      m_windows.push_back(w);
    else
    {
      i = m_free.back();
      m_free.pop_back();
      m_windows[i] = w;
    }
    m_queue.push({nearest, i, false, m_serial++});
  }

  // Takes away the parts of a window that are nearer through the ends of its edge. As a distance changes by no more
  // than one walks, such a part reaches to the end of the window. Returns whether something is left.
  bool trim(Window& w) const
  {
    Wave& wave = w.wave;
    const double length = m_surface.length(w.halfedge);
    return trim_begin(wave, m_vertices[m_surface.target(w.halfedge)]) &&
           trim_end(wave, length, m_vertices[m_surface.source(w.halfedge)]);
  }

  static bool trim_begin(Wave& wave, double vertex)
  {
    const double tolerance = equal_tolerance * vertex;
    if(!(wave.value(wave.begin) - wave.begin > vertex + tolerance))
      return wave.begin < wave.end;
    if(wave.value(wave.end) - wave.end > vertex + tolerance)
      return false;
    // where wave(x) = vertex + x
    const double k = vertex - wave.offset;
    const double x = wave.is_plane ? -k / (1 - wave.at.x)
                                   : (wave.at.x * wave.at.x + wave.at.y * wave.at.y - k * k) / (2 * (k + wave.at.x));
    if(x > wave.begin && x < wave.end && wave.value(x) - x >= vertex - tolerance)
      wave.begin = x;
    return wave.begin < wave.end;
  }

  static bool trim_end(Wave& wave, double length, double vertex)
  {
    const double tolerance = equal_tolerance * vertex;
    if(!(wave.value(wave.end) - (length - wave.end) > vertex + tolerance))
      return true;
    Wave back = wave.reversed(length);
    const bool is_left = trim_begin(back, vertex);
    wave.end = (std::max)(length - back.begin, wave.begin);
    return is_left && wave.begin < wave.end;
  }

  // Leads a window on the edge of h, with lines into the face of h, to the two other edges of the face.
  void propagate(Index h, const Wave& wave)
  {
    if(!wave.is_plane && wave.at.y == 0)
      return; // the lines run along the edge
    const double length = m_surface.length(h);
    const Vector2 apex = m_surface.apex(h);
    const Vector2 begin = ray(wave, wave.begin), end = ray(wave, wave.end);
    const double left_of_begin = cross(begin, apex - Vector2{wave.begin, 0});
    const double left_of_end = cross(end, apex - Vector2{wave.end, 0});
    // a line that ends two windows may miss the corner on both sides by rounding
    const double missed = corner_tolerance * norm(apex);
    if(left_of_begin <= missed * norm(begin) && left_of_end >= -missed * norm(end))
      offer(m_surface.source(Surface_metric::prev(h)),
            wave.offset + (wave.is_plane ? dot(wave.at, apex) : norm(apex - wave.at)));
    if(left_of_begin < 0) // to the edge from the apex to the source of h
    {
      const Index g = Surface_metric::prev(h);
      const double l = m_surface.length(g);
      const double first = l * share_of_edge(wave.begin, begin, {0, 0}, apex);
      const double last = left_of_end < 0 ? l * share_of_edge(wave.end, end, {0, 0}, apex) : l;
      add({g, moved(wave, first, last, {0, 0}, 1 / l * apex)});
    }
    if(left_of_end > 0) // to the edge from the target of h to the apex
    {
      const Index g = Surface_metric::next(h);
      const double l = m_surface.length(g);
      const Vector2 corner = {length, 0};
      const double first = left_of_begin > 0 ? l * share_of_edge(wave.begin, begin, apex, corner) : 0;
      const double last = l * share_of_edge(wave.end, end, apex, corner);
      add({g, moved(wave, first, last, apex, 1 / l * (corner - apex))});
    }
  }

  // The direction of the line through a point of the x axis.
  static Vector2 ray(const Wave& wave, double x)
  {
    return wave.is_plane ? wave.at : Vector2{x - wave.at.x, -wave.at.y};
  }

  // Where the line through (x, 0) meets the edge from p to q, as a share of that.
  static double share_of_edge(double x, Vector2 direction, Vector2 p, Vector2 q)
  {
    const double d = cross(q - p, direction);
    const double t = d == 0 ? 0 : cross(Vector2{x, 0} - p, direction) / d;
    return (std::min)((std::max)(t, 0.), 1.);
  }

  // A wave seen from an edge that starts at `origin` and has this direction.
  static Wave moved(const Wave& wave, double begin, double end, Vector2 origin, Vector2 x)
  {
    const Vector2 p = wave.is_plane ? wave.at : wave.at - origin;
    const Vector2 at = {dot(p, x), cross(x, p)};
    return {begin, end, at, wave.is_plane ? wave.offset + dot(wave.at, origin) : wave.offset, wave.is_plane};
  }

  const Surface_metric& m_surface;
  double m_greatest = 0;
  std::vector<double> m_vertices;
  std::vector<bool> m_is_source; // of vertices: from there lines start in all directions
  std::vector<Index> m_first;    // of the waves of an edge
  std::vector<Recorded> m_waves;
  std::vector<Window> m_windows;
  std::vector<Index> m_free; // places in m_windows
  std::priority_queue<Event> m_queue;
  Index m_serial = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_WINDOW_DISTANCES_H
