// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_ACCURATE_TRACE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_ACCURATE_TRACE_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Double_double.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>

#include <CGAL/FPU.h>

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Number types of accurate_parameters(), each with the logarithm of a bound of the relative error of an operation, the
// least length whose products do not come near to underflow, and the difference of two doubles.
struct Double_double_precision
{
  typedef Double_double NT;
  static constexpr int log_of_error = -100;
  static constexpr double least_length = 1e-60;
  static NT difference(double a, double b) { return NT::difference(a, b); }
};

struct Multiprecision
{
  typedef boost::multiprecision::number<
      boost::multiprecision::mpfr_float_backend<300, boost::multiprecision::allocate_stack>,
      boost::multiprecision::et_off>
      NT;
  static constexpr int log_of_error = -980;
  static constexpr double least_length = 0;
  static NT difference(double a, double b) { return NT(a) - NT(b); }
};

// Where the straight line from the start to the end of an arc meets each crossed halfedge, and how long it is.
struct Crossing_parameters
{
  std::vector<double> values; // in [0, 1]
  double length;
  bool are_accurate; // whether the error of each is proved to be no more than some roundings of 1
};

template <class Precision, class Vector>
bool is_small(const Vector& v)
{
  return std::abs(static_cast<double>(v[0])) + std::abs(static_cast<double>(v[1])) +
             std::abs(static_cast<double>(v[2])) <
         Precision::least_length;
}

// The corners of a face that a halfedge is crossed to, as complex numbers: at the source and at the target of the
// crossed halfedge, the edge to the third vertex over the crossed edge. The face lies to the right of the crossed
// halfedge.
template <class Precision>
class Crossed_face
{
public:
  typedef typename Precision::NT NT;

  Crossed_face(const Progressive_mesh& pm, Index h)
  {
    const auto &u = pm.point(pm.source(h)), &v = pm.point(pm.target(h)),
               &apex = pm.point(pm.source(pm.prev(pm.opposite(h))));
    const Vector edge = vector(u, v), from_source = vector(u, apex), from_target = vector(v, apex);
    const NT square = dot(edge, edge), twice_area = norm_of_cross(edge, from_source);
    m_from_source = {dot(from_source, edge) / square, -twice_area / square};
    m_from_target = {-dot(from_target, edge) / square, twice_area / square};
    m_is_small = internal::is_small<Precision>(edge) || internal::is_small<Precision>(from_source) ||
                 internal::is_small<Precision>(from_target);
  }

  // whether an edge is so short that numbers may have come near to underflow
  bool is_small() const { return m_is_small; }

  // (third vertex - source) / (target - source)
  const Planar<NT>& from_source() const { return m_from_source; }

  // (third vertex - target) / (source - target)
  const Planar<NT>& from_target() const { return m_from_target; }

  typedef std::array<NT, 3> Vector;

  template <class Point>
  static Vector vector(const Point& p, const Point& q)
  {
    return {{Precision::difference(q.x(), p.x()), Precision::difference(q.y(), p.y()),
             Precision::difference(q.z(), p.z())}};
  }

  static NT dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  static NT norm_of_cross(const Vector& a, const Vector& b)
  {
    const Vector c = {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    using std::sqrt;
    return sqrt(dot(c, c));
  }

private:
  Planar<NT> m_from_source, m_from_target;
  bool m_is_small;
};

// Unfolds the strip of an arc with crossings, in multiples of the edge from its start to the source of the first
// crossed halfedge. Each edge is the edge before it times a number of the face, so its relative error grows by a few
// roundings a face, whatever the shapes of the faces. Positions are sums of edges. The bound of the error follows from
// this. The source and the target of a crossed halfedge lie on different sides of the line of the arc, so no digits are
// lost when their distances from the line are added, however nearly parallel the halfedge and the line are. What counts
// is the error of the distances compared to their sum. Linear.
template <class Precision>
Crossing_parameters accurate_parameters(const Progressive_mesh& pm, const Arc& arc)
{
  typedef typename Precision::NT NT;
  typedef Planar<NT> Point;
  typedef Crossed_face<Precision> Face;
  const auto size = [](const Point& p) { return std::hypot(static_cast<double>(p.x()), static_cast<double>(p.y())); };
  struct Unfolded
  {
    Point left, right;
    double error; // of either, absolute
  };

  const Index first = arc.crossings.front();
  const auto& start = pm.point(arc.from);
  const typename Face::Vector a = Face::vector(start, pm.point(pm.source(first))),
                              b = Face::vector(start, pm.point(pm.target(first)));
  const NT square = Face::dot(a, a);
  Point right = {NT(1), NT(0)}, left = {Face::dot(a, b) / square, Face::norm_of_cross(a, b) / square};
  const typename Face::Vector across = Face::vector(pm.point(pm.source(first)), pm.point(pm.target(first)));
  // left - right, with a relative error of its own
  Point edge = {Face::dot(across, a) / square, left.y()};

  const double roundings = std::ldexp(16.0, Precision::log_of_error); // of the operations of one face
  double sum = 1 + size(left);
  bool is_in_range = !is_small<Precision>(a) && !is_small<Precision>(b);
  std::vector<Unfolded> portals;
  Point end;
  double error_of_end = 0;
  for(std::size_t i = 0; i < arc.crossings.size(); ++i)
  {
    const Index h = arc.crossings[i], o = pm.opposite(h);
    portals.push_back({left, right, roundings * static_cast<double>(i + 1) * sum});
    const Face face(pm, h);
    is_in_range = is_in_range && !face.is_small();
    if(i + 1 == arc.crossings.size())
    {
      const Point last = edge * face.from_source();
      end = right + last;
      error_of_end = roundings * static_cast<double>(i + 2) * (sum + size(last));
      break;
    }
    if(arc.crossings[i + 1] == pm.next(o))
    {
      edge = edge * face.from_source();
      left = right + edge;
    }
    else
    {
      edge = edge * face.from_target();
      right = left - edge;
    }
    sum += size(edge);
  }

  using std::sqrt;
  const NT squared_length = square * (end.x() * end.x() + end.y() * end.y());
  Crossing_parameters result = {{}, static_cast<double>(NT(sqrt(squared_length))), is_in_range};
  for(const Unfolded& p : portals)
  {
    const NT to_right = -determinant(end, p.right), to_left = determinant(end, p.left);
    const NT distance = to_right + to_left;
    const double width = static_cast<double>(distance);
    const double reach = (std::max)(size(p.left), size(p.right));
    const double error = 2 * (size(end) * p.error + reach * error_of_end + error_of_end * p.error);
    result.are_accurate = result.are_accurate && error <= std::ldexp(width, -54); // false for numbers that overflowed
    const double t = width > 0 ? static_cast<double>(NT(to_right / distance)) : 0.5;
    result.values.push_back((std::min)((std::max)(t, 0.0), 1.0));
  }
  return result;
}

// The parameters and the length of an arc with crossings, by numbers of 106 bits and, where the bound of their error
// says that these are not enough, by numbers of 300 digits. The caller has set the rounding mode to nearest. Linear.
inline Crossing_parameters accurate_parameters(const Progressive_mesh& pm, const Arc& arc)
{
  Crossing_parameters parameters = accurate_parameters<Double_double_precision>(pm, arc);
  return parameters.are_accurate ? parameters : accurate_parameters<Multiprecision>(pm, arc);
}

// Like trace(), but the errors of the parameters are some roundings of 1 also where the curve meets edges at the
// smallest of angles, and after any number of faces, whatever rounding mode the caller has set. Linear; three to nine
// times the cost of trace().
inline std::vector<Trace_point> accurate_trace(const Progressive_mesh& pm, const std::vector<Arc>& curve)
{
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  std::vector<Trace_point> result;
  for(const Arc& arc : curve)
  {
    result.push_back({arc.from, null_index, 0});
    if(arc.is_edge())
      continue;
    const Crossing_parameters parameters = accurate_parameters(pm, arc);
    for(std::size_t i = 0; i < arc.crossings.size(); ++i)
      result.push_back({null_index, arc.crossings[i], parameters.values[i]});
  }
  return result;
}

// The length of an arc to some roundings, also where it crosses edges that are far longer than itself, in whose
// unfolded ends measure() loses digits. Costs as much as accurate_trace().
inline double accurate_length(const Progressive_mesh& pm, const Arc& arc)
{
  if(arc.is_edge())
    return arc.length;
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return accurate_parameters(pm, arc).length;
}

// Of all arcs of a curve. Costs as much as accurate_trace().
inline double accurate_length(const Progressive_mesh& pm, const std::vector<Arc>& curve)
{
  double length = 0;
  for(const Arc& arc : curve)
    length += accurate_length(pm, arc);
  return length;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_ACCURATE_TRACE_H
