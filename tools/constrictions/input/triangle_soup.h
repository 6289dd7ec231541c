// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_TRIANGLE_SOUP_H
#define CONSTRICTIONS_TRIANGLE_SOUP_H

#include "input/input_file.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh_constrictions::Index Index;

/// The vertices and faces of a file, in its order: three `corners` a face.
struct Triangle_soup
{
  std::vector<Point> points;
  std::vector<Index> corners;

  std::size_t number_of_faces() const { return corners.size() / 3; }
};

/// throws that face `face` has not three vertices.
[[noreturn]] inline void throw_not_triangular(std::size_t face, unsigned long long number_of_vertices)
{
  using namespace CGAL::Surface_mesh_constrictions;
  throw Invalid_input(Input_defect::NOT_TRIANGULAR, face,
                      "not a triangle mesh: face " + std::to_string(face) + " has " +
                      std::to_string(number_of_vertices) + (number_of_vertices == 1 ? " vertex" : " vertices"));
}

/// the 0-based number `index` that a face names, as an `Index`. Throws if there is no such vertex.
inline Index checked_index(std::size_t face, long long index, std::size_t number_of_vertices)
{
  using namespace CGAL::Surface_mesh_constrictions;
  if(index < 0 || static_cast<unsigned long long>(index) >= number_of_vertices || index >= null_index)
    throw Invalid_input(Input_defect::INVALID_VERTEX_INDEX, face,
                        "invalid vertex index: face " + std::to_string(face) + " refers to vertex " +
                        std::to_string(index) + " of " + std::to_string(number_of_vertices));
  return static_cast<Index>(index);
}

/// \name Readers
/// Each throws `Input_file_error` for a file that is not of its format and `Invalid_input` for faces that are not
/// triangles of existing vertices.
/// @{
Triangle_soup read_off(const Input_file& file);
Triangle_soup read_obj(const Input_file& file);
Triangle_soup read_ply(const Input_file& file);

/// Corners with the same coordinates are one vertex; vertices are numbered as they appear.
Triangle_soup read_ascii_stl(const Input_file& file);
Triangle_soup read_binary_stl(const Input_file& file);
/// @}

} // namespace constrictions

#endif // CONSTRICTIONS_TRIANGLE_SOUP_H
