// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/find_on_mesh.h"

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace constrictions {

namespace {

typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh>::Location Location;

// A place for a point of a curve.
struct Candidate
{
  Location location;
  double distance;
};

// Points in cells of space.
class Cells
{
public:
  Cells(const std::vector<Point>& points, double width) : m_points(points), m_width(width)
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      m_cells[cell(points[i])].push_back(i);
  }

  // Calls f with the points in the cells that a box meets, and maybe with others.
  template <class F>
  void for_each_in(const Point& low, const Point& high, F f) const
  {
    const Cell a = cell(low), b = cell(high);
    double number = 1;
    for(std::size_t k = 0; k < 3; ++k)
      number *= b[k] - a[k] + 1;
    if(!(number < static_cast<double>(m_points.size())))
    {
      for(std::size_t i = 0; i < m_points.size(); ++i)
        f(i);
      return;
    }
    for(double x = a[0]; x <= b[0]; ++x)
      for(double y = a[1]; y <= b[1]; ++y)
        for(double z = a[2]; z <= b[2]; ++z)
          if(const auto found = m_cells.find({{x, y, z}}); found != m_cells.end())
            for(std::size_t i : found->second)
              f(i);
  }

private:
  typedef std::array<double, 3> Cell;

  Cell cell(const Point& p) const
  {
    return {{std::floor(p.x() / m_width), std::floor(p.y() / m_width), std::floor(p.z() / m_width)}};
  }

  const std::vector<Point>& m_points;
  double m_width;
  std::map<Cell, std::vector<std::size_t>> m_cells;
};

double average_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(Mesh::Edge_index e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

// Appends the vertex at p, if p is at an end of the edge, or the crossing of the edge at p.
void add_candidate(const Mesh& mesh, Mesh::Edge_index e, const Curve_point& p, double tolerance,
                   std::vector<Candidate>& candidates)
{
  const Mesh::Halfedge_index h = mesh.halfedge(e);
  const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
  if(p.is_pivot)
  {
    for(Mesh::Vertex_index v : {mesh.source(h), mesh.target(h)})
    {
      const double distance = std::sqrt(CGAL::squared_distance(mesh.point(v), p.place));
      const bool is_new = std::none_of(candidates.begin(), candidates.end(),
                                       [v](const Candidate& c) { return c.location.vertex == v; });
      if(distance <= tolerance && is_new)
        candidates.push_back({{true, v, Mesh::null_halfedge(), 0}, distance});
    }
    return;
  }
  const auto direction = b - a;
  const double length = direction.squared_length();
  const double t = length > 0 ? (std::min)(1., (std::max)(0., direction * (p.place - a) / length)) : 0;
  const double distance = std::sqrt(CGAL::squared_distance(a + t * direction, p.place));
  if(distance <= tolerance)
    candidates.push_back({{false, Mesh::null_vertex(), h, t}, distance});
}

// Whether a straight piece of a curve can lead from one to the other through a face, or along an edge.
bool can_follow(const Mesh& mesh, const Location& p, const Location& q)
{
  const auto is_in = [&mesh](const Location& l, Mesh::Face_index f) {
    if(f == Mesh::null_face())
      return false;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      if(l.is_pivot ? mesh.target(h) == l.vertex : mesh.edge(h) == mesh.edge(l.halfedge))
        return true;
    return false;
  };
  if(p.is_pivot && q.is_pivot)
    return p.vertex != q.vertex && mesh.halfedge(p.vertex, q.vertex) != Mesh::null_halfedge();
  const Location &crossing = p.is_pivot ? q : p, &other = p.is_pivot ? p : q;
  if(other.is_pivot &&
     (mesh.source(crossing.halfedge) == other.vertex || mesh.target(crossing.halfedge) == other.vertex))
    return false;
  if(!other.is_pivot && mesh.edge(other.halfedge) == mesh.edge(crossing.halfedge))
    return false;
  return is_in(other, mesh.face(crossing.halfedge)) || is_in(other, mesh.face(mesh.opposite(crossing.halfedge)));
}

// Of each point a candidate, so that each can follow the one before it, the first the last, and the sum of the distances
// is smallest. If that cannot be, the nearest ones.
std::vector<Location> choose(const Mesh& mesh, const std::vector<std::vector<Candidate>>& candidates)
{
  const std::size_t n = candidates.size();
  const std::size_t first =
      static_cast<std::size_t>(std::min_element(candidates.begin(), candidates.end(),
                                                [](const auto& a, const auto& b) { return a.size() < b.size(); }) -
                               candidates.begin());
  const auto at = [&](std::size_t step) -> const std::vector<Candidate>& { return candidates[(first + step) % n]; };
  const double infinity = std::numeric_limits<double>::infinity();
  double best = infinity;
  std::vector<std::size_t> chosen(n, 0);
  for(std::size_t begin = 0; begin < at(0).size(); ++begin)
  {
    std::vector<double> cost(at(0).size(), infinity);
    cost[begin] = at(0)[begin].distance;
    std::vector<std::vector<std::size_t>> from(n);
    for(std::size_t step = 1; step <= n; ++step)
    {
      std::vector<double> next(at(step).size(), infinity);
      std::vector<std::size_t> before(at(step).size(), 0);
      for(std::size_t q = 0; q < next.size(); ++q)
        for(std::size_t p = 0; p < cost.size(); ++p)
          if(cost[p] + at(step)[q].distance < next[q] &&
             can_follow(mesh, at(step - 1)[p].location, at(step)[q].location))
          {
            next[q] = cost[p] + at(step)[q].distance;
            before[q] = p;
          }
      cost = std::move(next);
      from[step % n] = std::move(before);
    }
    if(!(cost[begin] < best))
      continue;
    best = cost[begin];
    std::size_t place = begin;
    for(std::size_t step = n; step > 0; --step)
    {
      chosen[(first + step) % n] = place;
      place = from[step % n][place];
    }
  }
  std::vector<Location> result;
  for(std::size_t i = 0; i < n; ++i)
    result.push_back(candidates[i][chosen[i]].location);
  return result;
}

} // namespace

std::vector<Found_curve> find_on_mesh(const Mesh& mesh, const std::vector<std::vector<Curve_point>>& curves,
                                      double tolerance)
{
  std::vector<Curve_point> all;
  std::vector<Point> places;
  for(const std::vector<Curve_point>& curve : curves)
    for(const Curve_point& p : curve)
    {
      all.push_back(p);
      places.push_back(p.place);
    }
  std::vector<std::vector<Candidate>> candidates(all.size());
  const Cells cells(places, (std::max)(average_edge_length(mesh), tolerance));
  for(Mesh::Edge_index e : mesh.edges())
  {
    const CGAL::Bbox_3 box = mesh.point(mesh.vertex(e, 0)).bbox() + mesh.point(mesh.vertex(e, 1)).bbox();
    cells.for_each_in(Point(box.xmin() - tolerance, box.ymin() - tolerance, box.zmin() - tolerance),
                      Point(box.xmax() + tolerance, box.ymax() + tolerance, box.zmax() + tolerance),
                      [&](std::size_t i) { add_candidate(mesh, e, all[i], tolerance, candidates[i]); });
  }
  for(std::vector<Candidate>& c : candidates)
    std::stable_sort(c.begin(), c.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });

  std::vector<Found_curve> result(curves.size());
  std::size_t begin = 0;
  for(std::size_t c = 0; c < curves.size(); ++c)
  {
    const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(begin),
               last = first + static_cast<std::ptrdiff_t>(curves[c].size());
    const auto lost = std::find_if(first, last, [](const auto& places_of_point) { return places_of_point.empty(); });
    if(lost != last)
      result[c].lost = static_cast<std::size_t>(lost - first);
    else if(first != last)
      result[c].locations = choose(mesh, std::vector<std::vector<Candidate>>(first, last));
    begin += curves[c].size();
  }
  return result;
}

} // namespace constrictions
