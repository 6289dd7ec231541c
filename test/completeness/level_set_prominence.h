// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef LEVEL_SET_PROMINENCE_H
#define LEVEL_SET_PROMINENCE_H

// The prominence of a constriction by a sweep that shares no code with the package's: the surface is cut open along the
// curve and refined, and the level sets of the distance to each bank are measured as far as they are shorter than the
// curve. They are not tightened, so what comes out is an upper bound, as is what the package says, and it is coarser
// where the pass is over a single vertex.

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace level_set_prominence {

template <class Mesh>
class Opened_surface
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor Halfedge;
  typedef std::array<double, 3> Point;
  typedef std::array<std::size_t, 3> Triangle;

public:
  Opened_surface(Mesh mesh, const CGAL::Surface_mesh_constrictions::Constriction<Mesh>& curve)
    : m_length(curve.length())
  {
    const std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> curves = {curve};
    const auto split = CGAL::Surface_mesh_constrictions::split_along_constrictions(mesh, curves);
    const std::vector<Halfedge>& along = split.halfedges.front();
    if(along.empty())
      return;
    for(auto v : vertices(mesh))
      m_points.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
    std::map<Halfedge, std::size_t> left; // by halfedge with the corner at its target: the vertex on the left bank
    for(std::size_t i = 0; i < along.size(); ++i)
    {
      const std::size_t copy = m_points.size(), v = target(along[i], mesh);
      m_points.push_back(Point(m_points[v]));
      m_banks[0].push_back(copy);
      m_banks[1].push_back(v);
      for(Halfedge h = along[i];; h = opposite(next(h, mesh), mesh))
      {
        left.emplace(h, copy);
        if(next(h, mesh) == along[(i + 1) % along.size()])
          break;
      }
    }
    for(auto f : faces(mesh))
    {
      Triangle t;
      Halfedge h = halfedge(f, mesh);
      for(std::size_t& v : t)
      {
        const auto it = left.find(h);
        v = it == left.end() ? static_cast<std::size_t>(target(h, mesh)) : it->second;
        h = next(h, mesh);
      }
      m_faces.push_back(t);
    }
    refine();
    refine();
  }

  // Infinite if the curve does not cut.
  double prominence() const { return m_faces.empty() ? infinity() : (std::min)(barrier(0), barrier(1)) / m_length - 1; }

private:
  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  double distance(std::size_t v, std::size_t w) const
  {
    const Point &p = m_points[v], &q = m_points[w];
    return std::sqrt(std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2));
  }

  // Each triangle becomes four; the middle of an edge between vertices of a bank belongs to the bank.
  void refine()
  {
    std::array<std::vector<bool>, 2> is_on;
    for(std::size_t bank = 0; bank < 2; ++bank)
    {
      is_on[bank].resize(m_points.size());
      for(std::size_t v : m_banks[bank])
        is_on[bank][v] = true;
    }
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, int>> middles; // and the number of faces
    std::vector<Triangle> faces;
    for(const Triangle& t : m_faces)
    {
      Triangle m;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t v = t[i], w = t[(i + 1) % 3];
        const auto it = middles.emplace(std::minmax(v, w), std::make_pair(m_points.size(), 0));
        if(it.second)
        {
          const Point &p = m_points[v], &q = m_points[w];
          m_points.push_back({{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}});
        }
        ++it.first->second.second;
        m[i] = it.first->second.first;
      }
      faces.push_back({{t[0], m[0], m[2]}});
      faces.push_back({{t[1], m[1], m[0]}});
      faces.push_back({{t[2], m[2], m[1]}});
      faces.push_back(m);
    }
    for(const auto& e : middles)
      for(std::size_t bank = 0; bank < 2; ++bank)
        if(e.second.second == 1 && is_on[bank][e.first.first] && is_on[bank][e.first.second])
          m_banks[bank].push_back(e.second.first);
    m_faces.swap(faces);
  }

  // Distances to a bank, of first order: an edge is a way, and a triangle is passed by a straight wave.
  std::vector<double> distances(std::size_t bank) const
  {
    std::vector<std::vector<std::size_t>> faces_at(m_points.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(std::size_t v : m_faces[f])
        faces_at[v].push_back(f);
    std::vector<double> result(m_points.size(), infinity());
    typedef std::pair<double, std::size_t> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](std::size_t v, double d) {
      if(d < result[v])
      {
        result[v] = d;
        queue.emplace(d, v);
      }
    };
    for(std::size_t v : m_banks[bank])
      reach(v, 0);
    while(!queue.empty())
    {
      const Entry e = queue.top();
      queue.pop();
      if(e.first > result[e.second])
        continue;
      for(std::size_t f : faces_at[e.second])
        for(std::size_t v : m_faces[f])
        {
          if(v == e.second)
            continue;
          reach(v, e.first + distance(v, e.second));
          for(std::size_t w : m_faces[f])
            if(w != v && w != e.second && result[w] <= e.first)
              reach(v, through_triangle(w, e.second, v, result));
        }
    }
    return result;
  }

  // The distance of c where a straight wave has passed a and b; infinite if it comes to c through another triangle.
  double through_triangle(std::size_t a, std::size_t b, std::size_t c, const std::vector<double>& d) const
  {
    const double ab = distance(a, b), ac = distance(a, c), bc = distance(b, c);
    if(ab == 0)
      return infinity();
    const double sine = (d[b] - d[a]) / ab; // how the wave goes along ab
    if(std::abs(sine) >= 1)
      return infinity();
    const double cosine = std::sqrt(1 - sine * sine);
    const double x = (ab * ab + ac * ac - bc * bc) / (2 * ab), y = std::sqrt((std::max)(0.0, ac * ac - x * x));
    const double foot = x - y * sine / cosine; // where the ray through c leaves ab
    return foot < 0 || foot > ab ? infinity() : d[a] + x * sine + y * cosine;
  }

  // The greatest length of the level sets before the first that is shorter than the curve, or before they come to the
  // other bank.
  double barrier(std::size_t bank) const
  {
    const std::vector<double> d = distances(bank);
    double last = infinity(), greatest = 0;
    for(std::size_t v : m_banks[1 - bank])
      last = (std::min)(last, d[v]);
    for(double x : d)
      if(x < infinity())
        greatest = (std::max)(greatest, x);
    last = (std::min)(last, greatest);
    const double step = m_length / 256;
    std::vector<double> lengths(static_cast<std::size_t>(last / step), 0.0);
    for(const Triangle& t : m_faces)
    {
      std::array<std::size_t, 3> v = t;
      std::sort(v.begin(), v.end(), [&](std::size_t a, std::size_t b) { return d[a] < d[b]; });
      if(!(d[v[2]] < infinity()))
        continue;
      for(std::size_t i = static_cast<std::size_t>(d[v[0]] / step); i < lengths.size(); ++i)
      {
        const double level = (static_cast<double>(i) + 0.5) * step;
        if(level <= d[v[0]])
          continue;
        if(level >= d[v[2]])
          break;
        const Point p = on_edge(v[0], v[2], level, d);
        const Point q = level < d[v[1]] ? on_edge(v[0], v[1], level, d) : on_edge(v[1], v[2], level, d);
        lengths[i] += std::sqrt(std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2));
      }
    }
    double result = m_length;
    for(double length : lengths)
    {
      if(length < m_length)
        break;
      result = (std::max)(result, length);
    }
    return result;
  }

  Point on_edge(std::size_t v, std::size_t w, double level, const std::vector<double>& d) const
  {
    const double t = (level - d[v]) / (d[w] - d[v]);
    const Point &p = m_points[v], &q = m_points[w];
    return {{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}};
  }

  double m_length;
  std::vector<Point> m_points;
  std::vector<Triangle> m_faces;
  std::array<std::vector<std::size_t>, 2> m_banks;
};

// An upper bound of the prominence, infinite if there is none.
template <class Mesh>
double prominence(const Mesh& mesh, const CGAL::Surface_mesh_constrictions::Constriction<Mesh>& curve)
{
  return Opened_surface<Mesh>(mesh, curve).prominence();
}

} // namespace level_set_prominence

#endif // LEVEL_SET_PROMINENCE_H
