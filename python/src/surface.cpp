// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface.h"

#include "arrays.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/mesh_from_corner_table.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace py = pybind11;
namespace SMC = CGAL::Surface_mesh_constrictions;

std::vector<Mesh::Point> read_points(const py::object& vertices)
{
  const Double_array array = as_doubles(vertices, "V", 3);
  const auto v = array.unchecked<2>();
  std::vector<Mesh::Point> result;
  result.reserve(static_cast<std::size_t>(v.shape(0)));
  for(py::ssize_t i = 0; i < v.shape(0); ++i)
    result.emplace_back(v(i, 0), v(i, 1), v(i, 2));
  return result;
}

// Indices that do not fit into those of the library are refused here, all others there.
std::vector<SMC::Index> read_corners(const py::object& faces, std::size_t number_of_vertices)
{
  const Integer_array array = as_integers(faces, "F", 3);
  const auto f = array.unchecked<2>();
  std::vector<SMC::Index> result;
  result.reserve(3 * static_cast<std::size_t>(f.shape(0)));
  for(py::ssize_t i = 0; i < f.shape(0); ++i)
    for(py::ssize_t j = 0; j < 3; ++j)
    {
      const std::int64_t v = f(i, j);
      if(v < 0 || v >= SMC::null_index)
        throw SMC::Invalid_input(SMC::Input_defect::INVALID_VERTEX_INDEX, static_cast<std::size_t>(i),
                                 "invalid vertex index: face " + std::to_string(i) + " refers to vertex " +
                                     std::to_string(v) + " of " + std::to_string(number_of_vertices));
      result.push_back(static_cast<SMC::Index>(v));
    }
  return result;
}

} // namespace

std::shared_ptr<Surface> make_surface(const py::object& vertices, const py::object& faces)
{
  // nobody changes the arrays as long as they are read, since the lock of the interpreter is held
  const std::vector<Mesh::Point> points = read_points(vertices);
  const std::vector<SMC::Index> corners = read_corners(faces, points.size());
  const py::gil_scoped_release without_lock;
  const SMC::internal::Corner_table table = SMC::internal::make_corner_table(points.size(), corners, true);
  SMC::internal::check_points(table, points);
  auto result = std::make_shared<Surface>();
  SMC::internal::mesh_from_corner_table(table, points, result->mesh);
  return result;
}

std::vector<std::int64_t> faces_of_mesh(const Mesh& mesh)
{
  std::vector<std::int64_t> result;
  result.reserve(3 * mesh.num_faces());
  for(Mesh::Face_index f : mesh.faces())
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result.push_back(number_of(mesh.source(h)));
  return result;
}

} // namespace constrictions
