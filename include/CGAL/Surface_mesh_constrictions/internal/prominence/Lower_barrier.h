// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LOWER_BARRIER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LOWER_BARRIER_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curve_neighbourhood.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Opened_neighbourhood.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Straight_cut.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Window_distances.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/least_sum_of_waves.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Proves that a closed geodesic must become so long before it can become shorter. See "A Lower Bound of the Prominence"
// in the user manual for the theorem and its proof, whose letters are used here.
//
// N is a neighbourhood of the curve, sigma one of several straight cuts through N that cross the curve once. u and w
// are the distances, in N opened along sigma, from the two sides of sigma, and M is the least distance between these.
// Each closed curve in N that crosses sigma an odd number of times and passes x is at least as long as
// g(x) = min(u + w, 2u + M, 2w + M). So a curve that is shorter than c cannot cross an edge on which g >= c for one of
// the cuts. If such edges enclose a part U of N with the curve in it, and no such curve through a vertex of U where a
// geodesic can bend is shorter than the curve, then the curve must become as long as c.
class Lower_barrier
{
public:
  // `lengths` of the surface. Linear in the size of the mesh.
  Lower_barrier(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_lengths(lengths), m_neighbourhood(pm, lengths), m_straight_cut(pm, lengths),
      m_local_vertices(pm.number_of_vertex_ids(), null_index)
  {}

  // The greatest c of several neighbourhoods, each larger than the one before, until `greatest` is reached or there is
  // no more to gain; at least `length`, that of the curve. Near m log m for each neighbourhood of m faces.
  double bound(const std::vector<Trace_point>& trace, double length, double greatest)
  {
    m_trace = &trace;
    m_length = length;
    m_greatest = greatest * (1 + rounding_margin) * (1 + rounding_margin);
    m_neighbourhood.start(trace);
    double best = length, reach = least_reach * length;
    for(std::size_t i = 0, before = 0; i < most_neighbourhoods && best < greatest; ++i, reach *= reach_factor)
    {
      m_neighbourhood.grow(reach, most_vertices);
      if(m_neighbourhood.faces().size() == before)
        continue;
      before = m_neighbourhood.faces().size();
      draw_cuts();
      if(pass(false) > best)
        best = (std::max)(best, pass(true));
      if(m_neighbourhood.is_limited() || reach > greatest)
        break;
    }
    return (std::max)(length, best * (1 - rounding_margin));
  }

  // Distances are unfolded over some thousand faces at most, each of which adds a few roundings of relative size
  // 10^-16. This is far more.
  static constexpr double rounding_margin = 1e-9;

private:
  static constexpr std::size_t number_of_cuts = 8, most_neighbourhoods = 6, most_vertices = 2000, most_loops = 1000;
  static constexpr double flat_tolerance = 1e-9;
  static constexpr double least_reach = 0.25;   // of the first neighbourhood, relative to the length of the curve
  static constexpr double reach_factor = 2;     // from one neighbourhood to the next
  static constexpr double longest_piece = 0.02; // of an edge on which g is bounded at once; likewise

  struct Cut
  {
    Cut(const Progressive_mesh& pm, const Edge_lengths& lengths, const std::vector<Index>& faces,
        std::vector<Cut_point> p, std::vector<Index>& local_vertices)
      : points(std::move(p)), opened(pm, lengths, faces, points, local_vertices), from_left(opened.metric()),
        from_right(opened.metric())
    {}

    void make_copies()
    {
      if(copies)
        return;
      copies = std::make_unique<Surface_metric>(opened.two_copies());
      in_copies = std::make_unique<Window_distances>(*copies);
    }

    std::vector<Cut_point> points;
    Opened_neighbourhood opened;
    Window_distances from_left, from_right;
    double least = 0; // M
    std::unique_ptr<Surface_metric> copies;
    std::unique_ptr<Window_distances> in_copies;
  };

  void draw_cuts()
  {
    m_cuts.clear();
    m_least_on_edge.clear();
    for(std::size_t i = 0; i < number_of_cuts; ++i)
      add_cut(i);
  }

  // Adds a cut that starts near this place of the curve, if there is one.
  void add_cut(std::size_t place)
  {
    const std::size_t tries = 3;
    for(std::size_t k = 0; k < tries; ++k)
    {
      const double share = (static_cast<double>(place) + (static_cast<double>(k) + 0.5) / tries) / number_of_cuts;
      std::vector<Cut_point> points = draw_at(share * m_length);
      if(points.size() < 2)
        continue;
      // it must lead from one side of the curve to the other one
      const std::size_t from = m_neighbourhood.side(m_pm.face(points.front().halfedge));
      const std::size_t to = m_neighbourhood.side(m_pm.face(m_pm.opposite(points.back().halfedge)));
      if(from + to != 1)
        continue;
      m_cuts.emplace_back(m_pm, m_lengths, m_neighbourhood.faces(), std::move(points), m_local_vertices);
      measure(m_cuts.back());
      return;
    }
  }

  std::vector<Cut_point> draw_at(double distance) const
  {
    const std::vector<Trace_point>& trace = *m_trace;
    for(std::size_t i = 0; i < trace.size(); ++i)
    {
      const double piece = norm(position(m_pm, trace[(i + 1) % trace.size()]) - position(m_pm, trace[i]));
      if(distance <= piece || i + 1 == trace.size())
      {
        // not near the end of a piece, where the line could miss a vertex by little
        const double share = piece > 0 ? (std::min)((std::max)(distance / piece, 0.1), 0.9) : 0.5;
        return m_straight_cut.draw(trace, i, share, [&](Index f) { return m_neighbourhood.has(f); });
      }
      distance -= piece;
    }
    return {};
  }

  void measure(Cut& cut)
  {
    cut.from_left.compute_from_chain(cut.opened.left(), m_greatest);
    cut.from_right.compute_from_chain(cut.opened.right(), m_greatest);
    cut.least = m_greatest;
    for(Index h : cut.opened.left())
    {
      m_from_right.clear();
      cut.from_right.waves(h, m_from_right);
      cut.least = (std::min)(cut.least, least_of_waves(m_from_right, 0, cut.opened.metric().length(h)));
    }
  }

  // Whether the angles at a vertex add up to a full turn or more, but for rounding.
  bool is_saddle(Index v) const { return total_angle(m_pm, v) > 2 * CGAL_PI - flat_tolerance; }

  // Whether a curve through a vertex that crosses each cut an odd number of times may be shorter than the curve. In two
  // copies of a neighbourhood opened along a cut, glued together along it, such a curve leads from the vertex to its
  // second copy; it can leave these only where it is as long as 2u + M or 2w + M.
  bool may_have_shorter_loop(Index v)
  {
    const double length = m_length * (1 - rounding_margin);
    std::vector<Cut*> promising;
    for(Cut& cut : m_cuts)
    {
      const Index local = cut.opened.vertex(v);
      const double u = cut.from_left.distance(local), w = cut.from_right.distance(local);
      const double leaving = 2 * (std::min)(u, w) + cut.least;
      if((std::min)(u + w, leaving) >= length)
        return false;
      if(leaving >= length)
        promising.push_back(&cut);
    }
    // where the two sides of a cut are far from each other there is no other way around
    std::stable_sort(promising.begin(), promising.end(),
                     [](const Cut* a, const Cut* b) { return a->least > b->least; });
    for(Cut* cut : promising)
    {
      if(m_loops == most_loops)
        return true;
      ++m_loops;
      cut->make_copies();
      const Index local = cut->opened.vertex(v);
      if(cut->in_copies->between_vertices(local, cut->opened.in_second_copy(local), m_length) >= length)
        return false;
    }
    return true;
  }

  // A lower bound of the greatest g on an edge.
  double least_on_edge(Index edge)
  {
    const auto inserted = m_least_on_edge.emplace(edge, 0);
    double& result = inserted.first->second;
    if(!inserted.second)
      return result;
    const double length = m_lengths[edge];
    const std::size_t pieces = static_cast<std::size_t>(std::ceil(length / (longest_piece * m_length)));
    std::vector<double> greatest(pieces, 0);
    for(const Cut& cut : m_cuts)
    {
      std::vector<double> of_cut(pieces, m_greatest);
      cut.opened.for_each_part(edge, [&](const Opened_neighbourhood::Part& part) {
        m_from_left.clear();
        m_from_right.clear();
        cut.from_left.waves(part.edge, m_from_left);
        cut.from_right.waves(part.edge, m_from_right);
        for(std::size_t i = 0; i < pieces; ++i)
        {
          double begin = (std::max)(part.begin, length * static_cast<double>(i) / static_cast<double>(pieces));
          double end = (std::min)(part.end, length * static_cast<double>(i + 1) / static_cast<double>(pieces));
          if(begin > end)
            continue;
          begin -= part.begin;
          end -= part.begin;
          if(part.is_reversed)
          {
            std::swap(begin, end);
            begin = part.end - part.begin - begin;
            end = part.end - part.begin - end;
          }
          const double l = cut.opened.metric().length(part.edge);
          begin = (std::min)((std::max)(begin, 0.), l);
          end = (std::min)((std::max)(end, begin), l);
          of_cut[i] = (std::min)({of_cut[i], least_sum_of_waves(m_from_left, m_from_right, begin, end),
                                  2 * least_of_waves(m_from_left, begin, end) + cut.least,
                                  2 * least_of_waves(m_from_right, begin, end) + cut.least});
        }
      });
      for(std::size_t i = 0; i < pieces; ++i)
        greatest[i] = (std::max)(greatest[i], of_cut[i]);
    }
    result = *std::min_element(greatest.begin(), greatest.end());
    return result;
  }

  // The greatest c: the lowest way out of the neighbourhood over edges or, if these are looked for, to a vertex through
  // which a shorter curve may pass.
  double pass(bool with_loops)
  {
    typedef std::pair<double, Index> Entry; // the height of the lowest way to a face of the neighbourhood
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<double> heights(m_neighbourhood.faces().size(), (std::numeric_limits<double>::infinity)());
    std::unordered_set<Index> seen;
    for(Index f : m_neighbourhood.curve_faces())
      if(heights[m_neighbourhood.place(f)] > 0)
      {
        heights[m_neighbourhood.place(f)] = 0;
        queue.emplace(0, f);
      }
    double out = m_greatest;
    m_loops = 0;
    while(!queue.empty() && queue.top().first < out)
    {
      const Entry e = queue.top();
      queue.pop();
      if(e.first > heights[m_neighbourhood.place(e.second)])
        continue;
      for(Index h = 3 * e.second; h < 3 * e.second + 3; ++h)
      {
        const Index v = m_pm.source(h);
        if(with_loops && seen.insert(v).second && is_saddle(v) && may_have_shorter_loop(v))
          return e.first;
        const Index f = m_pm.face(m_pm.opposite(h));
        const double height = (std::max)(e.first, least_on_edge(m_pm.edge(h)));
        if(!m_neighbourhood.has(f))
          out = (std::min)(out, height);
        else if(height < heights[m_neighbourhood.place(f)])
        {
          heights[m_neighbourhood.place(f)] = height;
          queue.emplace(height, f);
        }
      }
    }
    return out;
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  Curve_neighbourhood m_neighbourhood;
  Straight_cut m_straight_cut;
  std::vector<Index> m_local_vertices;
  const std::vector<Trace_point>* m_trace = nullptr;
  double m_length = 0, m_greatest = 0;
  std::deque<Cut> m_cuts; // their distances refer to their surfaces, so they are not moved
  std::unordered_map<Index, double> m_least_on_edge;
  std::vector<Wave> m_from_left, m_from_right;
  std::size_t m_loops = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LOWER_BARRIER_H
