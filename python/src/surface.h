// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_SURFACE_H
#define CONSTRICTIONS_PYTHON_SURFACE_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Plane_section.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
typedef CGAL::Surface_mesh_constrictions::Geodesic_loop<Mesh> Geodesic_loop;
typedef CGAL::Surface_mesh_constrictions::Plane_section<Mesh> Plane_section;

class Prepared_mesh;

/// A triangle mesh that does not change any more. Vertices and faces have the numbers of the arrays that it was made
/// of, and the halfedge of a face starts at its first corner. An isolated vertex keeps its number, but is marked as
/// removed.
struct Surface
{
  Mesh mesh;
  mutable pybind11::object faces; ///< as an array; made when it is first asked for

  /// the mesh prepared for queries; made when it is first asked for, by one of the threads that ask
  mutable std::shared_ptr<const Prepared_mesh> prepared;
  mutable std::mutex prepared_mutex;
};

/// copies two arrays into a surface. Throws `Invalid_input` as the functions of the library do.
std::shared_ptr<Surface> make_surface(const pybind11::object& vertices, const pybind11::object& faces);

/// \name Numbers in Python
/// They are signed there.
/// @{
inline std::int64_t number_of(Mesh::Vertex_index v) { return static_cast<std::int64_t>(v.idx()); }
inline std::int64_t number_of(Mesh::Face_index f) { return static_cast<std::int64_t>(f.idx()); }
/// of the vertices of the faces, one face behind the other
std::vector<std::int64_t> faces_of_mesh(const Mesh& mesh);
/// @}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_SURFACE_H
