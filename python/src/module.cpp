// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "curves.h"
#include "detect.h"
#include "monitor.h"
#include "names.h"
#include "parts.h"
#include "surface.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_query_file.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace py = pybind11;
namespace SMC = CGAL::Surface_mesh_constrictions;

typedef std::shared_ptr<Surface> Surface_pointer;

// An exception with attributes, of which pybind11's own have none.
void define_invalid_input(py::module_& module)
{
  static py::handle type; // lives as long as the module, which is never unloaded
  type =
      PyErr_NewExceptionWithDoc("constrictions.InvalidInput",
                                "A mesh, a loop, a location or a curve that can not be used. The message says what\n"
                                "is wrong, and where.\n\n"
                                "Attributes: `defect`, what is wrong, as \"non_manifold_edge\"; `element`, the number\n"
                                "of the vertex, the face, the loop or the point concerned.",
                                PyExc_ValueError, nullptr);
  if(!type)
    throw py::error_already_set();
  module.attr("InvalidInput") = type;
  py::register_exception_translator([](std::exception_ptr exception) {
    try
    {
      if(exception)
        std::rethrow_exception(exception);
    }
    catch(const SMC::Invalid_query_file& e)
    {
      PyErr_SetString(PyExc_ValueError, e.what());
    }
    catch(const SMC::Invalid_input& e)
    {
      const py::object value = type(e.what());
      value.attr("defect") = name_of(e.defect());
      value.attr("element") = e.element();
      PyErr_SetObject(type.ptr(), value.ptr());
    }
  });
}

Mesh::Point as_point(const py::object& location, const std::string& name = "the location")
{
  const Double_array array = as_doubles(location, name, 0);
  if(array.size() != 3)
    throw py::value_error(name + " has " + std::to_string(array.size()) + " coordinates, it must have 3");
  const auto p = array.unchecked<1>();
  return Mesh::Point(p(0), p(1), p(2));
}

Surface_curves search(const Surface_pointer& surface, const std::optional<Mesh::Point>& location, const Search& search,
                      const py::object& progress)
{
  Detected detected;
  compute(progress, [&](Monitor& monitor) {
    detected =
        location ? prepared(*surface, monitor)->near(*location, search, monitor) : detect(*surface, search, monitor);
  });
  Surface_curves result;
  for(const Constriction& c : detected.constrictions)
    result.curves.push_back(std::make_shared<Surface_curve>(Surface_curve{surface, c, {}}));
  result.statistics = detected.statistics;
  return result;
}

py::list girth_of(const Surface_pointer& surface, const py::object& location, std::size_t maximum_number,
                  std::optional<double> minimum_angle, bool certifies)
{
  const Mesh::Point point = as_point(location);
  std::vector<Geodesic_loop> loops;
  compute(py::none(), [&](Monitor& monitor) {
    loops = prepared(*surface, monitor)->girth(point, maximum_number, minimum_angle, certifies);
  });
  py::list result;
  for(const Geodesic_loop& l : loops)
    result.append(std::make_shared<Surface_loop>(Surface_loop{surface, l, {}}));
  return result;
}

Surface_section section_of(const Surface_pointer& surface, const py::object& location, const py::object& axis,
                           bool certifies)
{
  const Mesh::Point point = as_point(location), direction = as_point(axis, "the axis");
  Surface_section result = {surface, {}};
  compute(py::none(), [&](Monitor& monitor) {
    result.section = prepared(*surface, monitor)->section(point, direction - CGAL::ORIGIN, certifies);
  });
  return result;
}

void save_prepared(const Surface_pointer& surface, const py::object& path, const py::object& progress)
{
  std::string file;
  compute(progress, [&](Monitor& monitor) { file = prepared_for_detection(*surface, monitor)->as_file(); });
  const py::object out = py::module_::import("io").attr("open")(path, "wb");
  out.attr("write")(py::bytes(file));
  out.attr("close")();
}

void load_prepared(const Surface_pointer& surface, const py::object& path)
{
  const py::object in = py::module_::import("io").attr("open")(path, "rb");
  const py::bytes file = in.attr("read")();
  in.attr("close")();
  compute(py::none(), [&surface, bytes = std::string_view(file)](Monitor&) { read_prepared(*surface, bytes); });
}

std::vector<Mesh::Vertex_index> as_loop(const Mesh& mesh, const py::handle& loop, std::size_t number)
{
  const std::string name = "loop " + std::to_string(number);
  const Integer_array array = as_integers(py::reinterpret_borrow<py::object>(loop), name, 0);
  const auto vertices = array.unchecked<1>();
  std::vector<Mesh::Vertex_index> result;
  for(py::ssize_t i = 0; i < vertices.shape(0); ++i)
  {
    const std::int64_t v = vertices(i);
    if(v < 0 || static_cast<std::size_t>(v) >= mesh.num_vertices())
      throw SMC::Invalid_input(SMC::Input_defect::INVALID_VERTEX_INDEX, number,
                               "invalid vertex index: " + name + " refers to vertex " + std::to_string(v) + " of " +
                                   std::to_string(mesh.num_vertices()));
    result.emplace_back(static_cast<Mesh::size_type>(v));
    if(mesh.is_removed(result.back()))
      throw SMC::Invalid_input(SMC::Input_defect::INVALID_LOOP, number,
                               name + " is not a path of mesh edges: vertex " + std::to_string(v) + " is isolated");
  }
  return result;
}

py::list tighten_all(const Surface_pointer& surface, const py::iterable& given, bool certifies,
                     const py::object& progress)
{
  std::vector<std::vector<Mesh::Vertex_index>> loops;
  for(const py::handle& loop : given)
    loops.push_back(as_loop(surface->mesh, loop, loops.size()));
  std::vector<Tightened_curve> tightened;
  compute(progress,
          [&](Monitor& monitor) { tightened = prepared(*surface, monitor)->tighten(loops, certifies, monitor); });
  py::list result;
  for(const Tightened_curve& t : tightened)
  {
    std::shared_ptr<Surface_curve> curve;
    if(t.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC)
      curve = std::make_shared<Surface_curve>(Surface_curve{surface, t.curve, {}});
    result.append(Tightened_loop{t.verdict, curve});
  }
  return result;
}

SMC::Certificate certificate_of(const Surface_pointer& surface, const py::object& curve)
{
  const Constriction c = curve_of_user(surface, curve, "the curve");
  SMC::Certificate result;
  compute(py::none(), [&](Monitor&) { result = certify(surface->mesh, c); });
  return result;
}

Surface_curves measured(const Surface_pointer& surface, const py::iterable& given)
{
  const std::vector<Constriction> curves = curves_of_user(surface, given);
  std::vector<Constriction> measures;
  compute(py::none(), [&](Monitor&) { measures = measure(surface->mesh, curves); });
  Surface_curves result;
  for(const Constriction& c : measures)
    result.curves.push_back(std::make_shared<Surface_curve>(Surface_curve{surface, c, {}}));
  return result;
}

Segmentation segmentation_by(const Surface_pointer& surface, const py::iterable& given,
                             std::optional<std::size_t> parts)
{
  const std::vector<Constriction> curves = curves_of_user(surface, given);
  Segmentation result;
  compute(py::none(), [&](Monitor&) { result = segment(surface->mesh, curves, parts); });
  return result;
}

std::shared_ptr<Split> split_along(const Surface_pointer& surface, const py::iterable& given,
                                   std::optional<std::size_t> parts)
{
  const std::vector<Constriction> curves = curves_of_user(surface, given);
  auto result = std::make_shared<Split>();
  compute(py::none(), [&](Monitor&) { *result = split(surface->mesh, curves, parts); });
  return result;
}

// The points lie in the mesh one behind the other.
py::array vertices_of(const Surface& surface)
{
  static_assert(sizeof(Mesh::Point) == 3 * sizeof(double), "a point is its coordinates");
  const double* const data = &*surface.mesh.point(Mesh::Vertex_index(0)).cartesian_begin();
  const py::ssize_t n = static_cast<py::ssize_t>(surface.mesh.num_vertices());
  return read_only(py::array_t<double>({n, py::ssize_t(3)}, data, owner_of(surface)));
}

py::object faces_of(const Surface& surface)
{
  if(!surface.faces)
    surface.faces = array_of(faces_of_mesh(surface.mesh), 3);
  return surface.faces;
}

void define_surface(py::module_& module)
{
  const double no_limit = std::numeric_limits<double>::infinity();
  py::class_<Surface, Surface_pointer>(module, "Surface", R"(Surface(V, F)

An oriented triangle mesh, closed or with holes, of any genus and any number of components. The arrays are copied, and
vertices and faces keep their numbers; what is done to the arrays later does not matter.

All functions may be called by several threads at once, and let other threads run. They use all processors if the
module has been built with oneTBB, and the results do not depend on that. Ctrl-C ends them at their next step.

V: (n, 3) float64, the coordinates of the vertices. Other floating-point numbers and integers are converted.
F: (m, 3) integers, the vertices of the faces, counterclockwise as seen from outside.

Raises InvalidInput, which names the vertex or the face, for an empty mesh, an index of no vertex, a coordinate that is
no finite number, an edge of length zero, and edges and vertices that are not manifold or not oriented consistently;
TypeError for elements of another type; ValueError for another shape.)")
      .def(py::init(&make_surface), py::arg("V"), py::arg("F"))
      .def_property_readonly("vertices", &vertices_of,
                             "(n, 3) float64: the coordinates of the vertices. The array can not be changed.")
      .def_property_readonly("faces", &faces_of,
                             "(m, 3) int64: the vertices of the faces. The array can not be changed.")
      .def("__repr__",
           [](const Surface& s) {
             return "<constrictions.Surface: " + std::to_string(s.mesh.num_vertices()) + " vertices, " +
                    std::to_string(s.mesh.num_faces()) + " faces>";
           })
      .def(
          "detect",
          [](const Surface_pointer& surface, double minimum_prominence, double minimum_isolation, double maximum_ratio,
             double minimum_length, double maximum_length, std::optional<std::size_t> maximum_number, bool all,
             bool rims, bool crossing, bool certifies, bool certified_only, const py::object& progress) {
            return search(surface, std::nullopt,
                          {minimum_prominence, minimum_isolation, maximum_ratio, minimum_length, maximum_length,
                           maximum_number, all, rims, crossing, certifies, certified_only},
                          progress);
          },
          py::kw_only(), py::arg("min_prominence") = SMC::default_minimum_prominence,
          py::arg("min_isolation") = SMC::default_minimum_isolation,
          py::arg("max_ratio") = SMC::default_maximum_isoperimetric_ratio, py::arg("min_length") = 0.,
          py::arg("max_length") = no_limit, py::arg("max_number") = py::none(), py::arg("all") = false,
          py::arg("rims") = false, py::arg("crossing") = false, py::arg("certify") = true,
          py::arg("certified_only") = false, py::arg("progress") = py::none(),
          R"(detect(*, min_prominence=0.05, min_isolation=0.15, max_ratio=0.25, min_length=0, max_length=inf,
       max_number=None, all=False, rims=False, crossing=False, certify=True, certified_only=False, progress=None)

Finds the constrictions of the surface: the same curves, in the same order, as the command `constrictions detect`.

min_prominence: the prominence that a curve has at least: a share of its length.
min_isolation: the isolation that it has at least.
max_ratio: length^2 / (4 pi A), which it has at most if it separates.
min_length, max_length: bounds of the length, in the unit of the coordinates.
max_number: how many there are at most; None for no limit.
all: every closed geodesic that was found, without a selection.
rims: also curves along the boundary of a hole.
crossing: also curves that cross more prominent ones.
certify: prove each curve with exact arithmetic.
certified_only: leave out curves of which a sign stayed open.
progress: is called as progress(stage, done, steps) now and then, by the thread that called detect(); the stages are
    "simplification", "seeds", "refinement", "tightening", "certification" and "selection". What it raises ends the
    search, and is raised by detect().

Returns Constrictions, a sequence.)")
      .def(
          "near",
          [](const Surface_pointer& surface, const py::object& location, double minimum_prominence,
             double minimum_isolation, double maximum_ratio, double minimum_length, double maximum_length,
             std::optional<std::size_t> maximum_number, bool all, bool rims, bool crossing, bool certifies,
             bool certified_only, const py::object& progress) {
            return search(surface, as_point(location),
                          {minimum_prominence, minimum_isolation, maximum_ratio, minimum_length, maximum_length,
                           maximum_number, all, rims, crossing, certifies, certified_only},
                          progress);
          },
          py::arg("location"), py::kw_only(), py::arg("min_prominence") = 0., py::arg("min_isolation") = 0.,
          py::arg("max_ratio") = SMC::default_maximum_isoperimetric_ratio, py::arg("min_length") = 0.,
          py::arg("max_length") = no_limit, py::arg("max_number") = py::none(), py::arg("all") = false,
          py::arg("rims") = false, py::arg("crossing") = false, py::arg("certify") = true,
          py::arg("certified_only") = false, py::arg("progress") = py::none(),
          R"(near(location, *, min_prominence=0, min_isolation=0, max_ratio=0.25, min_length=0, max_length=inf,
     max_number=None, all=False, rims=False, crossing=False, certify=True, certified_only=False, progress=None)

Finds the constrictions around a location, the nearest first: "the loop around this arm". Where nothing is narrow there
are none. The first call of near(), girth(), section() or tighten() prepares the surface; all later ones are fast.

location: (3,) float64, a point on the surface or near it.

The other arguments and the result are those of detect(). Raises InvalidInput for a coordinate that is no finite number,
ValueError for another shape.)")
      .def("girth", &girth_of, py::arg("location"), py::kw_only(), py::arg("max_number") = 1,
           py::arg("min_angle") = py::none(), py::arg("certify") = true,
           R"(girth(location, *, max_number=1, min_angle=None, certify=True)

Finds the shortest closed curves around the limb through a location, whether they are constrictions or not.

location: (3,) float64; the curves are held at the point of the surface that is nearest to it.
max_number: how many there are at most, the shortest ones.
min_angle: radians, the angle that a curve has at least at the location, on the side where it is smaller; None for the
    least angle of `constrictions girth`.
certify: prove what the curves become when they are let go.

Returns a list of GeodesicLoop; an empty one where nothing holds. Raises InvalidInput for a coordinate that is no finite
number, ValueError for another shape. Ctrl-C is noticed when it is done.)")
      .def("section", &section_of, py::arg("location"), py::arg("axis"), py::kw_only(), py::arg("certify") = true,
           R"(section(location, axis, *, certify=True)

Cuts the surface with the plane through a location that is perpendicular to an axis: the girth of a limb along a given
direction, and the geodesic loop nearest to it.

location: (3,) float64; it stands for the point of the surface that is nearest to it.
axis: (3,) float64, the direction of the limb, of any length but 0.
certify: prove what the loop becomes when it is let go.

Returns a PlaneSection. Raises InvalidInput for a coordinate that is no finite number, and for an axis of length 0,
ValueError for another shape. Ctrl-C is noticed when it is done.)")
      .def("save_prepared", &save_prepared, py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
           R"(save_prepared(path, *, progress=None)

Prepares the surface for detect(), near(), girth(), section() and tighten(), if it has not been, and writes what has been
prepared into a file, about 25 bytes for each face. The command `constrictions prepare` writes the same.

path: the name of the file, or a path.
progress: see detect().

Raises OSError for a file that can not be written.)")
      .def("load_prepared", &load_prepared, py::arg("path"),
           R"(load_prepared(path)

Reads what save_prepared(), or the command `constrictions prepare`, has written of a surface with the same vertices and
faces, instead of preparing this one. All results are the same.

path: the name of the file, or a path.

Raises ValueError for a file of another surface, or of another version of the format, and for one that is damaged;
OSError for a file that can not be read. Then the surface is as before.)")
      .def("tighten", &tighten_all, py::arg("loops"), py::kw_only(), py::arg("certify") = true,
           py::arg("progress") = py::none(),
           R"(tighten(loops, *, certify=True, progress=None)

Shortens closed loops of edges until they are closed geodesics, or a point.

loops: a sequence of (k,) integer arrays, the vertices of each loop, the first not repeated.
certify: prove each curve with exact arithmetic.
progress: is called as progress("tightening", done, steps) now and then; see detect().

Returns a list with a TightenedCurve for each loop. Raises InvalidInput, which names the loop, for one that is not a
closed path of edges.)")
      .def("certify", &certificate_of, py::arg("curve"),
           R"(certify(curve)

Decides with exact arithmetic whether a closed curve is a constriction, from its vertices and crossed edges.

curve: a Constriction of this surface, or a pair of arrays (faces, barycentric), (k,) integers and (k, 3) float64. Of
    these each point is on an edge, where one coordinate is zero, or at a vertex, where two are; the face of a point on
    an edge is the one that the curve comes from. The attributes of a Constriction are such.

Returns a Certificate. Raises InvalidInput, which names the point, for one that is not on an edge; ValueError for a
constriction of another surface.)")
      .def("measure", &measured, py::arg("curves"),
           R"(measure(curves)

Measures closed curves: the area of the cap that closes a cut along each, and how long the longest curves parallel to it
are on its two sides. 1 - length / min(side_girths) is how much narrower the body is there than on its thinner side.

curves: a sequence of curves, as certify() takes them.

Returns Constrictions, the same curves in the same order, with `cap_area` and `side_girths`. Raises InvalidInput and
ValueError as certify(), and for a curve that is not closed. Ctrl-C is noticed when it is done.)")
      .def("segment", &segmentation_by, py::arg("curves"), py::kw_only(), py::arg("parts") = py::none(),
           R"(segment(curves, *, parts=None)

Tells the parts that the surface falls into when it is cut along closed curves.

curves: a sequence of curves, as certify() takes them. Of two that cross the more prominent one cuts.
parts: how many parts there are at most; None for no limit.

Returns a Segmentation. Raises InvalidInput and ValueError as certify(), and for a curve that is not closed.)")
      .def("split", &split_along, py::arg("curves"), py::kw_only(), py::arg("parts") = py::none(),
           R"(split(curves, *, parts=None)

Splits the faces of a copy of the surface so that closed curves run along edges.

curves: a sequence of curves, as certify() takes them. Of two that cross the more prominent one cuts.
parts: how many parts there are at most; None for no limit.

Returns a Split: the arrays of the new mesh, which parts its faces belong to, and the vertices along each curve. Raises
InvalidInput and ValueError as certify(), and for a curve that is not closed.)");
}

} // namespace

} // namespace constrictions

PYBIND11_MODULE(_constrictions, module)
{
  pybind11::options options;
  options.disable_function_signatures(); // they name types of C++
  module.doc() = "Constrictions of triangle meshes: simple closed curves whose length is locally minimal.";
  module.attr("__version__") = CONSTRICTIONS_VERSION;
  constrictions::define_invalid_input(module);
  constrictions::define_curves(module);
  constrictions::define_parts(module);
  constrictions::define_surface(module);
}
