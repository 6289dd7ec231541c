// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SIDES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SIDES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/unfolding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// How a closed curve parts its connected component.
struct Parting
{
  bool separating;
  std::array<double, 2> areas; // left and right; if not separating, both that of the component
};

// Answers what lies on the sides of simple closed curves of a surface.
class Surface_sides
{
public:
  // Linear.
  explicit Surface_sides(const Progressive_mesh& pm)
    : m_pm(pm), m_component(pm.number_of_face_ids(), null_index), m_mark(pm.number_of_face_ids(), 0)
  {
    std::vector<Index> stack;
    for(Index f = 0; f < m_component.size(); ++f)
    {
      if(m_component[f] != null_index || !pm.is_face(f))
        continue;
      const Index c = static_cast<Index>(m_areas.size());
      const auto& origin = pm.point(pm.source(3 * f));
      double area = 0, volume = 0;
      m_component[f] = c;
      stack.push_back(f);
      while(!stack.empty())
      {
        const Index g = stack.back();
        stack.pop_back();
        area += face_area(g);
        volume += dot(vector(origin, pm.point(pm.source(3 * g))), normal(g));
        for(Index h = 3 * g; h < 3 * g + 3; ++h)
        {
          const Index n = pm.face(pm.opposite(h));
          if(m_component[n] == null_index)
          {
            m_component[n] = c;
            stack.push_back(n);
          }
        }
      }
      m_areas.push_back(area);
      m_outward.push_back(volume >= 0 ? 1 : -1);
    }
  }

  // Floods both sides of a curve in turn until one is used up or they meet.
  // Linear in the number of faces on the smaller side, or until the sides meet.
  Parting part(const std::vector<Trace_point>& trace)
  {
    const double whole = m_areas[m_component[some_face(trace)]];
    const Parting not_separating = {false, {whole, whole}};

    m_stamp += 3; // marks: m_stamp + 0 left, + 1 right, + 2 crossed by the curve
    std::vector<Strand> crossing = strands(m_pm, trace);
    std::sort(crossing.begin(), crossing.end(), [](const Strand& a, const Strand& b) { return a.face < b.face; });
    for(const Strand& s : crossing)
      m_mark[s.face] = m_stamp + 2;
    std::unordered_map<Index, int> side_of_run; // halfedges along which the curve runs, seen from their face
    for(std::size_t i = 0; i < trace.size(); ++i)
    {
      const Trace_point &p = trace[i], &q = trace[(i + 1) % trace.size()];
      if(!p.is_pivot() || !q.is_pivot())
        continue;
      const Index h = m_pm.halfedge(p.pivot, q.pivot);
      side_of_run[h] = 0;
      side_of_run[m_pm.opposite(h)] = 1;
    }

    std::array<std::vector<Index>, 2> stack;
    std::array<double, 2> area = {0, 0};
    std::unordered_map<Index, int> side_of_edge; // of halfedges that no strand ends on, in faces that are crossed
    for(std::size_t i = 0; i < crossing.size();)
    {
      std::size_t end = i;
      while(end < crossing.size() && crossing[end].face == crossing[i].face)
        ++end;
      if(!cut_face(crossing.data() + i, crossing.data() + end, area, side_of_edge))
        return not_separating;
      i = end;
    }
    for(const auto& entry : side_of_edge)
    {
      const auto run = side_of_run.find(entry.first);
      if(run != side_of_run.end())
      {
        if(run->second != entry.second)
          return not_separating;
        continue;
      }
      const Index o = m_pm.opposite(entry.first);
      const auto beyond = side_of_edge.find(o);
      if(beyond != side_of_edge.end() ? beyond->second != entry.second : !enter(m_pm.face(o), entry.second, stack))
        return not_separating;
    }
    for(const auto& run : side_of_run)
      if(m_mark[m_pm.face(run.first)] != m_stamp + 2 && !enter(m_pm.face(run.first), run.second, stack))
        return not_separating;

    for(int side = 0;; side = 1 - side)
    {
      if(stack[side].empty())
      {
        Parting result = {true, {area[side], area[side]}};
        result.areas[1 - side] = whole - area[side];
        return result;
      }
      const Index f = stack[side].back();
      stack[side].pop_back();
      area[side] += face_area(f);
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index n = m_pm.face(m_pm.opposite(h));
        if(m_mark[n] == m_stamp + 2 || side_of_run.count(h) != 0)
          continue;
        if(!enter(n, side, stack))
          return not_separating;
      }
    }
  }

  // Which side of the surface a geodesic chokes: where its curvature vector points into the solid, the object. What
  // three quarters of its turning or more say, decides. The length of the curve would be a bad weight: where it crosses
  // almost flat edges, noise alone decides to which side it bends. Linear.
  Side choked_side(const std::vector<Trace_point>& trace) const
  {
    const double outward = m_outward[m_component[some_face(trace)]];
    double inwards = 0, outwards = 0;
    const std::size_t n = trace.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const Vector3 p = position(m_pm, trace[i]), m = normal(trace[i]);
      const Vector3 a = p - position(m_pm, trace[(i + n - 1) % n]), b = position(m_pm, trace[(i + 1) % n]) - p;
      const double la = norm(a), lb = norm(b), lm = norm(m);
      if(la == 0 || lb == 0 || lm == 0)
        continue;
      const double bend = outward * dot((1 / lb) * b - (1 / la) * a, m) / lm;
      (bend < 0 ? inwards : outwards) += std::abs(bend);
    }
    const double share = inwards + outwards > 0 ? inwards / (inwards + outwards) : 0.5;
    return share >= 0.75 ? Side::OBJECT : share <= 0.25 ? Side::COMPLEMENT : Side::MIXED;
  }

private:
  // Twice the area long.
  Vector3 normal(Index f) const
  {
    const auto& p = m_pm.point(m_pm.source(3 * f));
    return cross(vector(p, m_pm.point(m_pm.source(3 * f + 1))), vector(p, m_pm.point(m_pm.source(3 * f + 2))));
  }

  Vector3 normal(const Trace_point& p) const
  {
    Vector3 sum = {0, 0, 0};
    const auto add = [&](Index f) {
      const Vector3 n = normal(f);
      const double l = norm(n);
      if(l > 0)
        sum = sum + (1 / l) * n;
    };
    if(p.is_pivot())
    {
      const Index begin = m_pm.outgoing(p.pivot);
      Index h = begin;
      do {
        add(m_pm.face(h));
        h = m_pm.ccw(h);
      } while(h != begin);
    }
    else
    {
      add(m_pm.face(p.halfedge));
      add(m_pm.face(m_pm.opposite(p.halfedge)));
    }
    return sum;
  }

  double face_area(Index f) const { return norm(normal(f)) / 2; }

  Index some_face(const std::vector<Trace_point>& trace) const
  {
    return m_pm.face(trace[0].is_pivot() ? m_pm.outgoing(trace[0].pivot) : trace[0].halfedge);
  }

  // False if the face already belongs to the other side.
  bool enter(Index f, int side, std::array<std::vector<Index>, 2>& stack)
  {
    if(m_mark[f] == m_stamp + static_cast<std::size_t>(1 - side))
      return false;
    if(m_mark[f] != m_stamp + static_cast<std::size_t>(side))
    {
      m_mark[f] = m_stamp + static_cast<std::size_t>(side);
      stack[side].push_back(f);
    }
    return true;
  }

  // Adds the areas that the strands of one face leave on the two sides, and notes on which side its whole edges are.
  // False if a piece of the face has a strand with it on the left and one with it on the right.
  bool cut_face(const Strand* begin, const Strand* end, std::array<double, 2>& area,
                std::unordered_map<Index, int>& side_of_edge) const
  {
    const Index f = begin->face;
    // walking around the face, the left side follows an exit and the right side an entry
    std::vector<std::pair<double, int> > ends;
    for(const Strand* s = begin; s != end; ++s)
    {
      ends.emplace_back(s->exit, 0);
      ends.emplace_back(s->entry, 1);
    }
    std::sort(ends.begin(), ends.end());
    double left = 0;
    for(std::size_t i = 0; i < ends.size(); ++i)
    {
      const std::pair<double, int>&p = ends[i], &q = ends[(i + 1) % ends.size()];
      if(p.second == q.second)
        return false;
      const double from = p.first, to = i + 1 < ends.size() ? q.first : q.first + 3;
      if(p.second == 0)
        left += area_under_boundary(f, from, to);
      for(int corner = static_cast<int>(std::ceil(from)); corner + 1 <= to; ++corner)
        side_of_edge[3 * f + static_cast<Index>(corner % 3)] = p.second;
    }
    for(const Strand* s = begin; s != end; ++s)
      left += moment(f, s->entry, s->exit);
    const double whole = face_area(f);
    area[0] += left;
    area[1] += whole - left;
    return true;
  }

  // The signed area of the triangle from the face's corner 0 to two places on its boundary.
  double moment(Index f, double from, double to) const
  {
    const Vector3 o = vector(Progressive_mesh::Point(0, 0, 0), m_pm.point(m_pm.source(3 * f)));
    const Vector3 n = normal(f);
    const double l = norm(n);
    return l == 0 ? 0 : dot(cross(boundary_position(m_pm, f, from) - o, boundary_position(m_pm, f, to) - o), n) / (2 * l);
  }

  double area_under_boundary(Index f, double from, double to) const
  {
    double sum = 0, at = from;
    for(double corner = std::floor(from) + 1; corner < to; ++corner)
    {
      sum += moment(f, at, corner);
      at = corner;
    }
    return sum + moment(f, at, to);
  }

  const Progressive_mesh& m_pm;
  std::vector<Index> m_component; // of a face
  std::vector<double> m_areas;    // of a component
  std::vector<double> m_outward;  // of a component: 1 if its normals point out of the solid, -1 if into it
  std::vector<std::size_t> m_mark;
  std::size_t m_stamp = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SIDES_H
