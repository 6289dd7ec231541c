// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts.h"

#include "arrays.h"
#include "attributes.h"

#include <CGAL/Surface_mesh_constrictions/Split_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <string>
#include <utility>

namespace constrictions {

namespace {

namespace py = pybind11;
namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;

// Notes the face of the input that each face comes from.
struct Parent_visitor : public SMC::Split_visitor_base<Mesh>
{
  struct Record
  {
    std::vector<std::int64_t> parents;
    std::int64_t split = 0;
  };

  explicit Parent_visitor(Record& record) : record(&record) {}

  void before_subface_creations(Mesh::Face_index f, const Mesh&) const { record->split = number_of(f); }
  void after_subface_created(Mesh::Face_index f, const Mesh&) const
  {
    if(record->parents.size() <= f)
      record->parents.resize(f + std::size_t(1));
    record->parents[f] = record->split;
  }

  Record* record;
};

py::object used_as_array(const std::vector<SMC::Cut_outcome>& outcomes)
{
  py::array_t<bool> result(static_cast<py::ssize_t>(outcomes.size()));
  std::transform(outcomes.begin(), outcomes.end(), result.mutable_data(),
                 [](const SMC::Cut_outcome& o) { return o.is_used; });
  return read_only(result);
}

py::object crossed_as_array(const std::vector<SMC::Cut_outcome>& outcomes)
{
  std::vector<std::int64_t> result;
  for(const SMC::Cut_outcome& o : outcomes)
    result.push_back(o.crossed_curve == SMC::Cut_outcome::none ? -1 : static_cast<std::int64_t>(o.crossed_curve));
  return array_of(std::move(result));
}

// One member of each part, or of each place where parts meet.
template <class Element, class Range, class Get>
py::object column(const Range& rows, Get get)
{
  std::vector<Element> result;
  for(const auto& row : rows)
    result.push_back(static_cast<Element>(get(row)));
  return array_of(std::move(result));
}

std::vector<Attribute<Segmentation>> attributes_of_segmentation()
{
  typedef Segmentation S;
  typedef SMC::Surface_part Part;
  typedef SMC::Part_adjacency Meeting;
  return {
      {"labels", "(m,) int64: for each face the number of the part in which most of it lies.",
       [](const S& s) -> py::object { return view_of(s.labels, 0, owner_of(s)); }},
      {"areas", "(p,) float64: the area of each part, in the square of the unit of the coordinates.",
       [](const S& s) { return column<double>(s.parts.parts, [](const Part& p) { return p.area; }); }},
      {"volumes",
       "(p,) float64: the volume of each part, its boundaries closed by cones, in the cube of the unit of the\n"
       "coordinates; negative if the part encloses what is outside of the solid.",
       [](const S& s) { return column<double>(s.parts.parts, [](const Part& p) { return p.volume; }); }},
      {"genera", "(p,) int64: the genus of each part after its boundaries have been closed.",
       [](const S& s) { return column<std::int64_t>(s.parts.parts, [](const Part& p) { return p.genus; }); }},
      {"boundaries", "(p,) int64: the number of boundary curves of each part.",
       [](const S& s) {
         return column<std::int64_t>(s.parts.parts, [](const Part& p) { return p.number_of_boundaries; });
       }},
      {"meeting_curves", "(q,) int64: for each place where parts meet the curve that they meet at.",
       [](const S& s) { return column<std::int64_t>(s.parts.adjacencies, [](const Meeting& m) { return m.curve; }); }},
      {"meeting_parts", "(q, 2) int64: the parts on the left and on the right of the curve there.",
       [](const S& s) -> py::object {
         std::vector<std::int64_t> result;
         for(const Meeting& m : s.parts.adjacencies)
           for(std::size_t p : m.parts)
             result.push_back(static_cast<std::int64_t>(p));
         return array_of(std::move(result), 2);
       }},
      {"meeting_lengths", "(q,) float64: the length along which they meet, in the unit of the coordinates.",
       [](const S& s) { return column<double>(s.parts.adjacencies, [](const Meeting& m) { return m.length; }); }},
      {"used", "(c,) bool: for each curve whether the surface was cut along it.",
       [](const S& s) { return used_as_array(s.parts.outcomes); }},
      {"crossed", "(c,) int64: for each curve the used curve that it crosses; -1 if it was used, or not needed.",
       [](const S& s) { return crossed_as_array(s.parts.outcomes); }},
  };
}

std::vector<Attribute<Split>> attributes_of_split()
{
  typedef Split S;
  return {
      {"vertices", "(n', 3) float64: the coordinates of the vertices, those of the surface first, with their numbers.",
       [](const S& s) -> py::object { return view_of(s.vertices, 3, owner_of(s)); }},
      {"faces", "(m', 3) int64: the vertices of the faces. A face of the surface that was not split keeps its number.",
       [](const S& s) -> py::object { return view_of(s.faces, 3, owner_of(s)); }},
      {"labels", "(m',) int64: the part that each face lies in.",
       [](const S& s) -> py::object { return view_of(s.labels, 0, owner_of(s)); }},
      {"parents", "(m',) int64: the face of the surface that each face comes from.",
       [](const S& s) -> py::object { return view_of(s.parents, 0, owner_of(s)); }},
      {"curves",
       "A list with, for each curve, an (k,) int64 array: the vertices along it, in its direction, the first not\n"
       "repeated; empty if it does not cut.",
       [](const S& s) -> py::object {
         py::list result;
         for(const std::vector<std::int64_t>& c : s.curves)
           result.append(array_of(c));
         return result;
       }},
      {"used", "(c,) bool: for each curve whether the surface was cut along it.",
       [](const S& s) { return used_as_array(s.outcomes); }},
      {"crossed", "(c,) int64: for each curve the used curve that it crosses; -1 if it was used, or not needed.",
       [](const S& s) { return crossed_as_array(s.outcomes); }},
  };
}

} // namespace

Segmentation segment(const Mesh& mesh, const std::vector<Constriction>& curves, std::optional<std::size_t> parts)
{
  Segmentation result;
  result.labels.resize(mesh.num_faces());
  const auto labels = CGAL::make_property_map(result.labels);
  result.parts =
      parts ? SMC::segment_by_constrictions(mesh, curves, labels, SMC::parameters::maximum_number_of_parts(*parts))
            : SMC::segment_by_constrictions(mesh, curves, labels);
  return result;
}

Split split(const Mesh& mesh, const std::vector<Constriction>& curves, std::optional<std::size_t> parts)
{
  Mesh copy = mesh;
  copy.set_recycle_garbage(false); // or else a new vertex gets the number of an isolated one
  const auto marks = copy.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  Parent_visitor::Record record;
  for(Mesh::Face_index f : mesh.faces())
    record.parents.push_back(number_of(f));
  const auto np = CGAL::parameters::edge_is_constrained_map(marks).visitor(Parent_visitor(record));
  const SMC::Split_curves<Mesh> split_curves =
      parts ? SMC::split_along_constrictions(copy, curves, SMC::parameters::maximum_number_of_parts(*parts, np))
            : SMC::split_along_constrictions(copy, curves, np);

  Split result;
  result.vertices.reserve(3 * copy.num_vertices());
  for(Mesh::size_type v = 0; v < copy.num_vertices(); ++v) // isolated ones, too
  {
    const Mesh::Point& p = copy.point(Mesh::Vertex_index(v));
    result.vertices.insert(result.vertices.end(), {p.x(), p.y(), p.z()});
  }
  result.faces = faces_of_mesh(copy);
  result.parents = std::move(record.parents);
  result.labels.resize(copy.num_faces());
  PMP::connected_components(copy, CGAL::make_property_map(result.labels),
                            CGAL::parameters::edge_is_constrained_map(marks));
  for(const auto& halfedges : split_curves.halfedges)
  {
    result.curves.emplace_back();
    for(Mesh::Halfedge_index h : halfedges)
      result.curves.back().push_back(number_of(copy.source(h)));
  }
  result.outcomes = split_curves.outcomes;
  return result;
}

void define_parts(py::module_& module)
{
  py::class_<Segmentation> segmentation(module, "Segmentation",
                                        "The parts of a surface that has been cut along curves. Arrays can not be\n"
                                        "changed.");
  define_attributes(segmentation, attributes_of_segmentation(), "All attributes as a dict of arrays.");
  segmentation.def("__len__", [](const Segmentation& s) { return s.parts.parts.size(); });
  segmentation.def("__repr__", [](const Segmentation& s) {
    const std::size_t n = s.parts.parts.size();
    return "<constrictions.Segmentation: " + std::to_string(n) + (n == 1 ? " part, " : " parts, ") +
           std::to_string(s.labels.size()) + " faces>";
  });

  py::class_<Split, std::shared_ptr<Split>> split(
      module, "Split",
      "A surface whose faces have been split so that curves run along edges. Arrays can not be changed.");
  define_attributes(split, attributes_of_split(), "All attributes as a dict of arrays.");
  split.def("__repr__", [](const Split& s) {
    return "<constrictions.Split: " + std::to_string(s.vertices.size() / 3) + " vertices, " +
           std::to_string(s.faces.size() / 3) + " faces>";
  });
}

} // namespace constrictions
