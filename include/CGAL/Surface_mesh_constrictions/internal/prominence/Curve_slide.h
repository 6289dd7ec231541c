// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVE_SLIDE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVE_SLIDE_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Front_start.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Between two curves the lengths of so many others are sampled.
constexpr std::size_t slide_samples = 31;

// How far on the way from one curve to the other a sample is.
inline double slide_parameter(std::size_t sample)
{
  return static_cast<double>(sample + 1) / (slide_samples + 1);
}

// The samples, from the first to behind the last, that can cut a face whose corners have these signed distances to the
// two curves: of most faces few.
inline std::pair<std::size_t, std::size_t> samples_that_cut(const std::array<double, 3>& from,
                                                            const std::array<double, 3>& to)
{
  double first = 1, last = 0;
  for(std::size_t i = 0; i < 3; ++i)
  {
    if(!(from[i] > 0) || to[i] > 0) // not between the curves
      return {0, slide_samples};
    const double t = from[i] / (from[i] - to[i]); // where a curve passes through the corner
    first = (std::min)(first, t);
    last = (std::max)(last, t);
  }
  const std::size_t before = static_cast<std::size_t>(first * (slide_samples + 1));
  return {before - (before > 0),
          (std::min)(slide_samples, static_cast<std::size_t>(last * (slide_samples + 1)) + 1)};
}

// Slides a curve b directly to another one, a: with signed distances, positive on corresponding sides, the zero sets of
// (1 - t) distance to b + t distance to a go from one to the other as t goes from 0 to 1. Around a bend they turn with
// it, where the level sets of the distance to b alone fall behind; and where the two curves cross they stay.
class Curve_slide
{
public:
  // Linear in the size of the mesh.
  Curve_slide(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_front(pm, lengths), m_seen(pm.number_of_face_ids(), 0)
  {}

  // The greatest length on the way from where a sweep started to curve a, of which this is the trace, on side s.
  // Infinite if the sweep has not reached all that is between them. O(m log m) for m faces swept.
  double greatest_length(const Distance_sweep& sweep, Index a, const std::vector<Trace_point>& trace, std::size_t s)
  {
    ++m_slide;
    m_faces.clear();
    m_needed.clear();
    bool reached = true;
    for(Index v : sweep.vertices())
      if(sweep.has_reached(v) && (sweep.signed_distance(v, s) > 0) != sweep.is_beyond(v, a))
      {
        const Index begin = m_pm.outgoing(v);
        Index h = begin;
        do {
          reached = reached && collect_face(sweep, m_pm.face(h));
          h = m_pm.ccw(h);
        } while(h != begin);
      }
    for(Index h : sweep.crossings(a))
      reached = reached && collect_face(sweep, m_pm.face(h)) && collect_face(sweep, m_pm.face(m_pm.opposite(h)));
    if(!reached || !measure_distances(trace))
      return (std::numeric_limits<double>::infinity)();

    std::array<double, slide_samples> lengths;
    lengths.fill(0);
    for(Index f : m_faces)
      add_face(sweep, f, a, s, lengths);
    return *std::max_element(lengths.begin(), lengths.end());
  }

private:
  // Takes a face. False if the sweep has not reached all its vertices.
  bool collect_face(const Distance_sweep& sweep, Index f)
  {
    if(m_seen[f] == m_slide || m_pm.is_ghost_face(f))
      return true;
    m_seen[f] = m_slide;
    m_faces.push_back(f);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if(!sweep.has_reached(m_pm.source(h)))
        return false;
      m_needed.push_back(m_pm.source(h));
    }
    return true;
  }

  // Computes distances to a curve at the vertices that are needed. False if one cannot be reached.
  bool measure_distances(const std::vector<Trace_point>& trace)
  {
    Front_start left, right;
    m_front.restart();
    start_front(m_pm, trace, m_front, left, right);
    std::array<bool, 2> used_up = {{false, false}};
    for(Index v : m_needed)
      while(!m_front.is_settled(v))
      {
        if(used_up[0] && used_up[1])
          return false;
        const std::size_t s = used_up[0] || (!used_up[1] && m_front.reached(1) < m_front.reached(0)) ? 1 : 0;
        used_up[s] = m_front.settle_next(s) == null_index;
      }
    return true;
  }

  void add_face(const Distance_sweep& sweep, Index f, Index a, std::size_t s,
                std::array<double, slide_samples>& lengths) const
  {
    std::array<double, 3> from, to;
    std::array<Vector3, 3> p;
    for(Index i = 0; i < 3; ++i)
    {
      const Index v = m_pm.source(3 * f + i);
      p[i] = position(m_pm, v);
      from[i] = sweep.signed_distance(v, s);
      to[i] = sweep.is_beyond(v, a) ? m_front.distance(v) : -m_front.distance(v);
    }
    const std::pair<std::size_t, std::size_t> cutting = samples_that_cut(from, to);
    for(std::size_t k = cutting.first; k < cutting.second; ++k)
    {
      const double t = slide_parameter(k);
      std::array<double, 3> g;
      std::array<Vector3, 2> ends;
      std::size_t count = 0;
      for(std::size_t i = 0; i < 3; ++i)
        g[i] = (1 - t) * from[i] + t * to[i];
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t j = (i + 1) % 3;
        if((g[i] > 0) != (g[j] > 0))
          ends[count++] = p[i] + (g[i] / (g[i] - g[j])) * (p[j] - p[i]);
      }
      if(count == 2)
        lengths[k] += norm(ends[1] - ends[0]);
    }
  }

  const Progressive_mesh& m_pm;
  Distance_front m_front;
  std::vector<Index> m_seen; // the last slide that a face was collected in
  std::vector<Index> m_faces, m_needed;
  Index m_slide = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVE_SLIDE_H
