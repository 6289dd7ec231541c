// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CHECK_REPORT_H
#define CONSTRICTIONS_CHECK_REPORT_H

#include "input/mesh_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

/// Triangles of almost no height that are not flat.
struct Slivers
{
  std::size_t number = 0;
  std::string worst;                 ///< words for the one of the least height; empty if there is none
  std::size_t with_near_corners = 0; ///< those with two corners that are as near to each other
  double merging_distance = 0;       ///< the value of `--merge` that merges such corners; 0 if there are none
};

/// What is wrong with a mesh file.
struct Check_report
{
  std::string mesh_file;
  Mesh mesh; ///< as repaired; empty if it was not made
  File_record file;
  std::string refusal;                          ///< why constrictions of it cannot be computed; empty if they can
  std::size_t self_intersections = 0;           ///< pairs of triangles
  std::vector<std::string> first_intersections; ///< the first of them
  std::size_t flat_triangles = 0;               ///< triangles without area
  Slivers slivers;
  bool is_inside_out = false; ///< whether the mesh is closed and its normals point inside
};

/// the report as lines for reading
std::string check_as_text(const Check_report& report);

/// the report in the format "constrictions-check/1", in one line
std::string check_as_json(const Check_report& report);

} // namespace constrictions

#endif // CONSTRICTIONS_CHECK_REPORT_H
