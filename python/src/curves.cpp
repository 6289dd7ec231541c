// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves.h"

#include "arrays.h"
#include "attributes.h"
#include "names.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace py = pybind11;
namespace SMC = CGAL::Surface_mesh_constrictions;

typedef SMC::Certificate Certificate;
typedef Constriction::Face_location Face_location;

std::string as_text(const Certificate& certificate)
{
  std::ostringstream out;
  out << certificate;
  return out.str();
}

// The certificate, which is a text in lists of values.
py::str verdict_of(const Surface_curve& c) { return as_text(c.curve.certificate()); }

py::dict as_dict(const SMC::Sign_statistics& s)
{
  py::dict result;
  result["interval"] = s.interval;
  result["multiprecision"] = s.multiprecision;
  result["finite_field"] = s.finite_field;
  result["algebra"] = s.algebra;
  result["unproved"] = s.unproved;
  return result;
}

py::dict as_dict(const SMC::Detection_statistics& s)
{
  py::dict result;
  result["collapses"] = s.collapses;
  result["seeds"] = s.seeds;
  result["degenerate"] = s.degenerate;
  result["discarded"] = s.discarded;
  result["merged"] = s.merged;
  result["not_simple"] = s.not_simple;
  result["leaky_bands"] = s.leaky_bands;
  result["barriers"] = s.barriers;
  result["not_certified"] = s.not_certified;
  result["not_selected"] = s.not_selected;
  result["corrected"] = s.corrected;
  result["signs"] = as_dict(s.signs);
  return result;
}

template <class T, std::size_t n>
py::object as_array(const std::array<T, n>& values)
{
  typedef std::conditional_t<std::is_floating_point<T>::value, double, std::int64_t> Element;
  return array_of(std::vector<Element>(values.begin(), values.end()));
}

template <class Range>
py::object numbers_as_array(const Range& numbers)
{
  return array_of(std::vector<std::int64_t>(numbers.begin(), numbers.end()));
}

py::object vertices_as_array(const std::vector<Mesh::Vertex_index>& vertices)
{
  std::vector<std::int64_t> result;
  for(Mesh::Vertex_index v : vertices)
    result.push_back(number_of(v));
  return array_of(std::move(result));
}

std::vector<Mesh::Point> points_of(const Surface_curve& c)
{
  std::vector<Mesh::Point> result;
  c.curve.points(c.surface->mesh, std::back_inserter(result));
  return result;
}

std::vector<Mesh::Point> points_of(const Surface_loop& l)
{
  std::vector<Mesh::Point> result;
  l.loop.points(l.surface->mesh, std::back_inserter(result));
  return result;
}

// Two coordinates are zero at vertices only: a crossing that rounding has moved to an end of its edge is given beside
// it, so that its edge can be told from the numbers.
std::vector<Face_location> locations_of(const Surface_curve& c)
{
  const Mesh& mesh = c.surface->mesh;
  std::vector<Face_location> result;
  c.curve.face_locations(mesh, std::back_inserter(result));
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    const Constriction::Location& l = c.curve.locations()[i];
    Mesh::Halfedge_index h = mesh.halfedge(result[i].first);
    for(std::size_t corner = 0; corner < 3 && !l.is_pivot; ++corner, h = mesh.next(h))
      if(h == l.halfedge || mesh.prev(h) == l.halfedge)
        result[i].second[corner] = (std::max)(result[i].second[corner], (std::numeric_limits<double>::min)());
  }
  return result;
}

std::vector<Face_location> locations_of(const Surface_loop& l) { return l.loop.locations; }

// Of a Surface_curve or a Surface_loop.
template <class T>
const Located_points& located(const T& curve)
{
  if(curve.located.points)
    return curve.located;
  std::vector<double> coordinates, barycentric;
  std::vector<std::int64_t> faces;
  for(const Mesh::Point& p : points_of(curve))
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  for(const Face_location& l : locations_of(curve))
  {
    faces.push_back(number_of(l.first));
    barycentric.insert(barycentric.end(), l.second.begin(), l.second.end());
  }
  curve.located = {array_of(std::move(coordinates), 3), array_of(std::move(faces)),
                   array_of(std::move(barycentric), 3)};
  return curve.located;
}

const std::vector<Constriction::Pivot>& pivots_of(const Surface_curve& c) { return c.curve.pivots(); }
const std::vector<Constriction::Pivot>& pivots_of(const Surface_loop& l) { return l.loop.pivots; }

template <class T>
py::object pivots_as_array(const T& curve)
{
  std::vector<std::int64_t> result;
  for(const Constriction::Pivot& p : pivots_of(curve))
    result.push_back(number_of(p.vertex));
  return array_of(std::move(result));
}

template <class T>
py::object pivot_points_as_array(const T& curve)
{
  std::vector<std::int64_t> result;
  for(const Constriction::Pivot& p : pivots_of(curve))
    result.push_back(static_cast<std::int64_t>(p.location));
  return array_of(std::move(result));
}

template <class T>
py::object pivot_angles_as_array(const T& curve)
{
  std::vector<double> result;
  for(const Constriction::Pivot& p : pivots_of(curve))
    result.insert(result.end(), {p.left_angle, p.right_angle});
  return array_of(std::move(result), 2);
}

template <class T>
std::vector<Attribute<T>> attributes_of_points()
{
  return {
      {"points", "(k, 3) float64: the closed sequence of points; the first is not repeated at the end.",
       [](const T& c) { return located(c).points; }, "offsets"},
      {"faces",
       "(k,) int64: a face that each point lies in; of a point on an edge the one that the curve comes from. Any two\n"
       "consecutive points lie in one face.",
       [](const T& c) { return located(c).faces; }, "offsets"},
      {"barycentric",
       "(k, 3) float64: the barycentric coordinates of each point, in the order of the vertices of its face. Two of\n"
       "them are zero at vertices only.",
       [](const T& c) { return located(c).barycentric; }, "offsets"},
      {"pivots", "(p,) int64: the vertices that the curve passes through.", &pivots_as_array<T>, "pivot_offsets"},
      {"pivot_points", "(p,) int64: the places of the pivots in `points`.", &pivot_points_as_array<T>, "pivot_offsets"},
      {"pivot_angles",
       "(p, 2) float64, radians: the angles along the surface on the left and on the right of the curve at each\n"
       "pivot; infinite to a hole.",
       &pivot_angles_as_array<T>, "pivot_offsets"},
  };
}

// The first seed; of a curve that a user gives there is none.
const Constriction::Seed& seed_of(const Surface_curve& c)
{
  static const Constriction::Seed none = {0, {}, SMC::Seed_origin::USER};
  return c.curve.seeds().empty() ? none : c.curve.seeds().front();
}

const std::vector<Attribute<Surface_curve>>& attributes_of_curve()
{
  typedef Surface_curve C;
  static const std::vector<Attribute<C>> result = [] {
    std::vector<Attribute<C>> attributes = {
        {"length", "The length, in the unit of the coordinates.",
         [](const C& c) -> py::object { return py::float_(c.curve.length()); }},
        {"diameter", "length / pi: the diameter of the circle that is as long.",
         [](const C& c) -> py::object { return py::float_(c.curve.diameter()); }},
        {"prominence",
         "How much longer the curve must become, relative to its length, before it can slide to where it is shorter,\n"
         "or off over a point. NaN if it has not been computed.",
         [](const C& c) -> py::object { return py::float_(c.curve.prominence()); }},
        {"isolation",
         "The area that the curve must sweep to become the one that it is dominated by, divided by its squared\n"
         "length; infinite if there is none, NaN if it has not been computed.",
         [](const C& c) -> py::object { return py::float_(c.curve.isolation()); }},
        {"cap_area",
         "The area of the cap that closes a cut along the curve. NaN if it has not been computed; see measure().",
         [](const C& c) -> py::object { return py::float_(c.curve.cap_area()); }},
        {"side_girths",
         "(2,) float64: the lengths of the longest curves parallel to it, on the left and on the right. NaN if they\n"
         "have not been computed; see measure().",
         [](const C& c) { return as_array(c.curve.side_girths()); }},
        {"isoperimetric_ratio", "length^2 / (4 pi A) with A the smaller of the two areas.",
         [](const C& c) -> py::object { return py::float_(c.curve.isoperimetric_ratio()); }},
        {"roundness", "How much it is like a circle: 1 for one.",
         [](const C& c) -> py::object { return py::float_(c.curve.roundness()); }},
        {"flat_band_width",
         "The width of the flat band of parallel copies of the curve, in the unit of the coordinates; 0 without one.",
         [](const C& c) -> py::object { return py::float_(c.curve.flat_band_width()); }},
        {"certificate", "The verdict of the exact arithmetic, as one line; see `Certificate`.",
         [](const C& c) -> py::object { return verdict_of(c); }},
        {"certified", "Whether the curve is proved to be a constriction.",
         [](const C& c) -> py::object { return py::bool_(c.curve.certificate().is_certified()); }},
        {"side", "What the curve chokes: \"object\", \"complement\" or \"mixed\".",
         [](const C& c) -> py::object { return py::str(name_of(c.curve.side())); }},
        {"separating", "Whether the surface falls apart along the curve, its holes filled before.",
         [](const C& c) -> py::object { return py::bool_(c.curve.is_separating()); }},
        {"areas", "(2,) float64: the areas on the left and on the right, in the square of the unit of the coordinates.",
         [](const C& c) { return as_array(c.curve.areas()); }},
        {"genera", "(2,) int64: the genera of the parts on the left and on the right.",
         [](const C& c) { return as_array(c.curve.genera()); }},
        {"centroid", "(3,) float64: the mean of the points by length.",
         [](const C& c) { return as_array(c.curve.centroid()); }},
        {"normal", "(3,) float64: the unit vector along the area vector; zeros if the curve encloses no area.",
         [](const C& c) { return as_array(c.curve.normal()); }},
        {"rim", "Whether the curve runs along the boundary of one hole for most of its length.",
         [](const C& c) -> py::object { return py::bool_(c.curve.is_rim()); }},
        {"boundary_share", "The greatest share of the length that runs along the boundary of one hole.",
         [](const C& c) -> py::object { return py::float_(c.curve.boundary_share()); }},
        {"dominated_by",
         "The place, in the result, of the constriction that the curve slides to when it is made longer by its\n"
         "prominence; None if there is none. -1 in arrays.",
         [](const C& c) -> py::object { return py::cast(c.curve.dominated_by()); }},
        {"slides_off",
         "The vertex over which the curve slides off when it is made longer by its prominence; None if there is none.\n"
         "-1 in arrays.",
         [](const C& c) -> py::object {
           return c.curve.slides_off() ? py::object(py::int_(number_of(*c.curve.slides_off()))) : py::none();
         }},
        {"seed_level", "The number of edge collapses after which the first seed of the curve exists.",
         [](const C& c) -> py::object { return py::int_(seed_of(c).level); }},
        {"seed_origin",
         "Where that seed comes from: \"non_face_triangle\", \"cut_locus\", \"section\", \"barrier\", \"boundary\" or\n"
         "\"user\".",
         [](const C& c) -> py::object { return py::str(name_of(seed_of(c).origin)); }},
        {"seed", "(s,) int64: the vertices of that seed, the first not repeated.",
         [](const C& c) { return vertices_as_array(seed_of(c).vertices); }, "seed_offsets"},
    };
    for(const Attribute<C>& a : attributes_of_points<C>())
      attributes.push_back(a);
    const std::vector<Attribute<C>> others = {
        {"crosses", "int64: the places, in the result, of constrictions that the curve crosses, there and back.",
         [](const C& c) { return numbers_as_array(c.curve.crosses()); }, "crosses_offsets"},
        {"crosses_oddly",
         "int64: the places, in the result, of shorter constrictions that the curve crosses an odd number of times.",
         [](const C& c) { return numbers_as_array(c.curve.crosses_oddly()); }, "crosses_oddly_offsets"},
        {"rivals",
         "int64: the places, in the result, of constrictions that it crosses and is no better than, as a mirror image.",
         [](const C& c) { return numbers_as_array(c.curve.rivals()); }, "rivals_offsets"},
        {"homology_class", "int64: the homology class modulo 2; comparable between the curves of one result.",
         [](const C& c) { return numbers_as_array(c.curve.homology_class()); }, "homology_class_offsets"},
    };
    attributes.insert(attributes.end(), others.begin(), others.end());
    return attributes;
  }();
  return result;
}

const std::vector<Attribute<Surface_loop>>& attributes_of_loop()
{
  typedef Surface_loop L;
  static const std::vector<Attribute<L>> result = [] {
    std::vector<Attribute<L>> attributes = {
        {"length", "The length, in the unit of the coordinates.",
         [](const L& l) -> py::object { return py::float_(l.loop.length); }},
        {"left_angle", "Radians: the angle on the left of the place where the loop is held; infinite to a hole.",
         [](const L& l) -> py::object { return py::float_(l.loop.left_angle); }},
        {"right_angle", "Radians: the angle on the right of the place where the loop is held; infinite to a hole.",
         [](const L& l) -> py::object { return py::float_(l.loop.right_angle); }},
        {"closed_geodesic", "Whether both angles are at least pi, but for rounding.",
         [](const L& l) -> py::object { return py::bool_(l.loop.is_closed_geodesic); }},
        {"let_go",
         "What the loop becomes when it is let go: \"constriction\", \"point\", which it encloses a tip then,\n"
         "\"not_simple\" or \"not_certified\".",
         [](const L& l) -> py::object { return py::str(name_of(l.loop.verdict)); }},
        {"constriction", "The `Constriction` that the loop becomes when it is let go; None if it becomes none.",
         [](const L& l) -> py::object {
           if(l.loop.verdict != SMC::Tightening_verdict::CLOSED_GEODESIC)
             return py::none();
           return py::cast(std::make_shared<Surface_curve>(Surface_curve{l.surface, l.loop.let_go, {}}));
         }},
        {"isoperimetric_ratio", "length^2 / (4 pi A) with A the smaller of the two areas.",
         [](const L& l) -> py::object { return py::float_(l.loop.isoperimetric_ratio); }},
        {"roundness", "How much it is like a circle: 1 for one.",
         [](const L& l) -> py::object { return py::float_(l.loop.roundness); }},
        {"side", "What the loop chokes: \"object\", \"complement\" or \"mixed\".",
         [](const L& l) -> py::object { return py::str(name_of(l.loop.side)); }},
        {"separating", "Whether the surface falls apart along the loop, its holes filled before.",
         [](const L& l) -> py::object { return py::bool_(l.loop.separating); }},
        {"areas", "(2,) float64: the areas on the left and on the right, in the square of the unit of the coordinates.",
         [](const L& l) { return as_array(l.loop.areas); }},
        {"genera", "(2,) int64: the genera of the parts on the left and on the right.",
         [](const L& l) { return as_array(l.loop.genera); }},
        {"centroid", "(3,) float64: the mean of the points by length.",
         [](const L& l) { return as_array(l.loop.centroid); }},
        {"normal", "(3,) float64: the unit vector along the area vector; zeros if the loop encloses no area.",
         [](const L& l) { return as_array(l.loop.normal); }},
        {"boundary_share", "The greatest share of the length that runs along the boundary of one hole.",
         [](const L& l) -> py::object { return py::float_(l.loop.boundary_share); }},
    };
    for(const Attribute<L>& a : attributes_of_points<L>())
      attributes.push_back(a);
    return attributes;
  }();
  return result;
}

const std::vector<Attribute<Surface_section>>& attributes_of_section()
{
  typedef Surface_section S;
  static const std::vector<Attribute<S>> result = {
      {"kind", "\"closed\", \"open\" if it ends at the boundary, or \"point\" if the plane only touches the surface.",
       [](const S& s) -> py::object { return py::str(name_of(s.section.kind)); }},
      {"length", "The length, in the unit of the coordinates; 0 if there is no curve.",
       [](const S& s) -> py::object { return py::float_(s.section.length); }},
      {"curves", "How many curves of the section meet at the place; the shortest closed one is taken.",
       [](const S& s) -> py::object { return py::int_(s.section.number_of_curves); }},
      {"points",
       "(k, 3) float64: the points where the curve meets edges and vertices. Of a closed curve the first is the\n"
       "place, which is not repeated at the end; an open one runs from end to end.",
       [](const S& s) -> py::object {
         std::vector<Mesh::Point> points;
         s.section.points(s.surface->mesh, std::back_inserter(points));
         std::vector<double> coordinates;
         for(const Mesh::Point& p : points)
           coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
         return array_of(std::move(coordinates), 3);
       }},
      {"loop",
       "The `GeodesicLoop` that a closed curve becomes when it is tightened with the place held; None if there is\n"
       "none.",
       [](const S& s) -> py::object {
         if(!s.section.loop)
           return py::none();
         return py::cast(std::make_shared<Surface_loop>(Surface_loop{s.surface, *s.section.loop, {}}));
       }},
  };
  return result;
}

std::string with_precision(double x, int digits)
{
  std::ostringstream out;
  out.precision(digits);
  out << x;
  return out.str();
}

std::string as_text(const Surface_curve& c)
{
  std::string result = "length " + with_precision(c.curve.length(), 6);
  if(!std::isnan(c.curve.prominence()))
    result += ", prominence " + with_precision(c.curve.prominence(), 3);
  return result + ", " + name_of(c.curve.side()) + (c.curve.is_separating() ? ", separating, " : ", ") +
         as_text(c.curve.certificate());
}

std::string as_text(const Surface_curves& curves)
{
  const std::size_t n = curves.curves.size(), shown = 20;
  std::string result = "<constrictions.Constrictions: " + std::to_string(n) + (n == 1 ? " curve" : " curves");
  for(std::size_t i = 0; i < n && i < shown; ++i)
    result += "\n  " + std::to_string(i) + ": " + as_text(*curves.curves[i]);
  return result + (n > shown ? "\n  ...>" : ">");
}

// One array of what several curves have. Where there is no curve, that of an empty one says what the array is of.
py::object joined(const Attribute<Surface_curve>& attribute, const Surface_curves& curves)
{
  const py::module_ numpy = py::module_::import("numpy");
  const py::slice nothing(0, 0, 1);
  const Surface_curve sample = {std::make_shared<Surface>(), Constriction(), {}};
  const auto value = [&attribute](const Surface_curve& c) {
    const py::object result = attribute.get(c);
    return result.is_none() ? py::object(py::int_(-1)) : result;
  };
  py::list values;
  for(const auto& c : curves.curves)
    values.append(value(*c));
  const bool is_empty = curves.curves.empty();
  if(is_empty)
    values.append(value(sample));
  const py::object result = numpy.attr(attribute.offsets == nullptr ? "array" : "concatenate")(values);
  return is_empty ? py::object(result[nothing]) : result;
}

py::dict as_dict(const Surface_curves& curves)
{
  py::dict result;
  for(const Attribute<Surface_curve>& a : attributes_of_curve())
  {
    result[a.name] = joined(a, curves);
    if(a.offsets == nullptr || result.contains(a.offsets))
      continue;
    std::vector<std::int64_t> offsets = {0};
    for(const auto& c : curves.curves)
      offsets.push_back(offsets.back() + static_cast<std::int64_t>(py::len(a.get(*c))));
    result[a.offsets] = array_of(std::move(offsets));
  }
  return result;
}

// A crossing is on the edge opposite to the corner whose coordinate is zero, and crosses it out of the face.
Constriction::Location location_of(const Mesh& mesh, std::int64_t face, const std::array<double, 3>& b,
                                   std::size_t point, const std::string& place)
{
  if(face < 0 || static_cast<std::size_t>(face) >= mesh.num_faces())
    throw SMC::Invalid_input(SMC::Input_defect::INVALID_LOCATION, point,
                             "invalid location: " + place + " is in face " + std::to_string(face) + " of " +
                                 std::to_string(mesh.num_faces()));
  Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(face)));
  const auto zeros = std::count(b.begin(), b.end(), 0.);
  const bool is_positive = std::count_if(b.begin(), b.end(), [](double x) { return x > 0; }) == 3 - zeros;
  if(zeros == 2 && is_positive)
  {
    for(std::size_t corner = 0; b[corner] == 0; ++corner)
      h = mesh.next(h);
    return {true, mesh.source(h), Mesh::null_halfedge(), 0};
  }
  if(zeros != 1 || !is_positive)
    throw SMC::Invalid_input(SMC::Input_defect::INVALID_LOCATION, point,
                             "invalid location: " + place +
                                 " is on no edge: one of its barycentric coordinates must be zero, or two at a vertex, "
                                 "and the others positive");
  const std::size_t opposite = static_cast<std::size_t>(std::find(b.begin(), b.end(), 0.) - b.begin());
  for(std::size_t corner = 0; corner <= opposite; ++corner)
    h = mesh.next(h);
  const double from = b[(opposite + 1) % 3], to = b[(opposite + 2) % 3];
  return {false, Mesh::null_vertex(), h, to / (from + to)};
}

Constriction curve_of_arrays(const Mesh& mesh, const py::object& given_faces, const py::object& given_barycentric,
                             const std::string& name)
{
  const Integer_array face_array = as_integers(given_faces, "the faces of " + name, 0);
  const Double_array coordinate_array = as_doubles(given_barycentric, "the barycentric coordinates of " + name, 3);
  const auto faces = face_array.unchecked<1>();
  const auto b = coordinate_array.unchecked<2>();
  if(faces.shape(0) != b.shape(0))
    throw py::value_error(name + " has " + std::to_string(faces.shape(0)) + " faces, and barycentric coordinates of " +
                          std::to_string(b.shape(0)) + " points");
  if(faces.shape(0) == 0)
    throw py::value_error(name + " has no points");
  Constriction::Data data;
  for(py::ssize_t i = 0; i < faces.shape(0); ++i)
    data.locations.push_back(location_of(mesh, faces(i), {b(i, 0), b(i, 1), b(i, 2)}, static_cast<std::size_t>(i),
                                         "point " + std::to_string(i) + " of " + name));
  return Constriction(std::move(data));
}

} // namespace

Constriction curve_of_user(const std::shared_ptr<const Surface>& surface, const py::handle& curve,
                           const std::string& name)
{
  if(py::isinstance<Surface_curve>(curve))
  {
    const Surface_curve& c = py::cast<const Surface_curve&>(curve);
    if(c.surface != surface)
      throw py::value_error(name + " is a constriction of another surface");
    return c.curve;
  }
  if(!py::isinstance<py::tuple>(curve) || py::len(curve) != 2)
    throw py::type_error(name + " is neither a Constriction nor a pair of arrays (faces, barycentric)");
  const py::tuple pair = py::reinterpret_borrow<py::tuple>(curve);
  return curve_of_arrays(surface->mesh, pair[0], pair[1], name);
}

std::vector<Constriction> curves_of_user(const std::shared_ptr<const Surface>& surface, const py::iterable& curves)
{
  std::vector<Constriction> result;
  for(const py::handle& curve : curves)
    result.push_back(curve_of_user(surface, curve, "curve " + std::to_string(result.size())));
  return result;
}

void define_curves(py::module_& module)
{
  py::class_<Certificate>(module, "Certificate",
                          "What has been proved of a closed curve with exact arithmetic. `str()` gives it as one line.")
      .def_property_readonly(
          "verdict", [](const Certificate& c) { return name_of(c.verdict); },
          "\"strict_constriction\" or \"constriction\"; or what is violated: \"not_a_closed_curve\",\n"
          "\"not_straight\", \"angle_below_pi\", \"crosses_itself\", \"touches_itself\", \"leaky_band\"; or\n"
          "\"tie_not_proved\", or \"not_computed\".")
      .def_property_readonly("certified", &Certificate::is_certified, "Whether it is proved to be a constriction.")
      .def_property_readonly(
          "point", [](const Certificate& c) { return c.location; }, "The point of the curve where it is violated.")
      .def_property_readonly(
          "other_point", [](const Certificate& c) { return c.other_location; },
          "The point where the curve comes to the same place again, if it crosses or touches itself.")
      .def_property_readonly(
          "side", [](const Certificate& c) { return name_of(c.side); },
          "\"left\" or \"right\": of the angle below pi, of the leak, or of the end of the edge that is passed.")
      .def_property_readonly(
          "flat_band_width", [](const Certificate& c) { return c.flat_band_width; },
          "The width of the flat band, in the unit of the coordinates; 0 without one.")
      .def_property_readonly(
          "signs", [](const Certificate& c) { return as_dict(c.signs); },
          "How many signs each stage of the exact arithmetic decided.")
      .def("__str__", [](const Certificate& c) { return as_text(c); })
      .def("__repr__", [](const Certificate& c) { return "<constrictions.Certificate: " + as_text(c) + ">"; });

  py::class_<Surface_curve, std::shared_ptr<Surface_curve>> constriction(
      module, "Constriction", "A closed curve whose length is locally minimal. Its arrays can not be changed.");
  define_attributes(constriction, attributes_of_curve(),
                    "Everything that is known of the curve, by the names of the attributes.");
  constriction.def("__len__", [](const Surface_curve& c) { return c.curve.locations().size(); });
  constriction.def("__repr__", [](const Surface_curve& c) {
    return "<constrictions.Constriction: " + as_text(c) + ", " + std::to_string(c.curve.locations().size()) +
           " points>";
  });

  py::class_<Surface_curves>(module, "Constrictions",
                             "The constrictions that were found, in the order of their ranks: a sequence.")
      .def("__len__", [](const Surface_curves& c) { return c.curves.size(); })
      .def("__getitem__",
           [](const Surface_curves& c, py::ssize_t i) {
             const py::ssize_t n = static_cast<py::ssize_t>(c.curves.size());
             if(i < -n || i >= n)
               throw py::index_error("there are " + std::to_string(n) + " constrictions");
             return c.curves[static_cast<std::size_t>(i < 0 ? i + n : i)];
           })
      .def("__getitem__",
           [](const Surface_curves& c, const py::slice& slice) {
             py::list all;
             for(const auto& curve : c.curves)
               all.append(curve);
             return py::object(all[slice]);
           })
      .def(
          "__iter__", [](const Surface_curves& c) { return py::make_iterator(c.curves.begin(), c.curves.end()); },
          py::keep_alive<0, 1>())
      .def_property_readonly(
          "statistics", [](const Surface_curves& c) { return as_dict(c.statistics); },
          "What became of the seed curves: a dict, as in the format \"constrictions/1\".")
      .def(
          "as_dict", [](const Surface_curves& c) { return as_dict(c); },
          "All curves as a dict of arrays, by the names of the attributes: one row a curve. Of `points`, `faces` and\n"
          "`barycentric` those of all curves are one behind the other, and those of curve i are in\n"
          "`offsets[i]:offsets[i + 1]`; for `pivots` and the like there are `pivot_offsets`, for others as `seed`\n"
          "there are `seed_offsets`. numpy.savez() can save it.")
      .def("__repr__", [](const Surface_curves& c) { return as_text(c); });

  py::class_<Surface_loop, std::shared_ptr<Surface_loop>> loop(
      module, "GeodesicLoop",
      "A closed curve that is held at a place, its first point, and straight everywhere else. Its arrays can not be\n"
      "changed.");
  define_attributes(loop, attributes_of_loop(),
                    "Everything that is known of the loop, by the names of the attributes.");
  loop.def("__len__", [](const Surface_loop& l) { return l.loop.locations.size(); });
  loop.def("__repr__", [](const Surface_loop& l) {
    return "<constrictions.GeodesicLoop: length " + with_precision(l.loop.length, 6) + ", let go it becomes " +
           (l.loop.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC ? "a constriction"
            : l.loop.verdict == SMC::Tightening_verdict::DEGENERATE    ? "a point"
                                                                       : name_of(l.loop.verdict)) +
           ", " + std::to_string(l.loop.locations.size()) + " points>";
  });

  py::class_<Surface_section> section(module, "PlaneSection",
                                      "The curve that a plane through a place cuts out of a surface.");
  define_attributes(section, attributes_of_section(),
                    "Everything that is known of the section, by the names of the attributes.");
  section.def("__repr__", [](const Surface_section& s) {
    return std::string("<constrictions.PlaneSection: ") + name_of(s.section.kind) + ", length " +
           with_precision(s.section.length, 6) + ">";
  });

  py::class_<Tightened_loop>(module, "TightenedCurve", "What a loop of edges was shortened to.")
      .def_property_readonly(
          "verdict", [](const Tightened_loop& t) { return name_of(t.verdict); },
          "\"constriction\", \"point\", \"not_simple\" or \"not_certified\".")
      .def_property_readonly(
          "curve", [](const Tightened_loop& t) { return t.curve; },
          "The `Constriction`; None if the verdict is another one.")
      .def("__repr__", [](const Tightened_loop& t) {
        return std::string("<constrictions.TightenedCurve: ") + name_of(t.verdict) +
               (t.curve ? ", " + as_text(*t.curve) : "") + ">";
      });
}

} // namespace constrictions
