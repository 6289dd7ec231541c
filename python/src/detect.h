// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_DETECT_H
#define CONSTRICTIONS_PYTHON_DETECT_H

#include "monitor.h"
#include "surface.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh_constrictions::Tightened_curve<Mesh> Tightened_curve;

/// What is looked for, and which of what is found is selected; see `detect_constrictions()`.
struct Search
{
  std::optional<Mesh::Point> location; ///< near which, instead of everywhere
  double minimum_prominence, minimum_isolation, maximum_ratio, minimum_length, maximum_length;
  std::optional<std::size_t> maximum_number;
  bool all, rims, crossing, certify, certified_only;
};

/// What a search has found.
struct Detected
{
  std::vector<Constriction> constrictions;
  CGAL::Surface_mesh_constrictions::Detection_statistics statistics;
};

/// \name Computations
/// Without Python, in files of their own, as they take long to compile.
/// @{
Detected detect(const Mesh& mesh, const Search& search, Monitor& monitor);
std::vector<Geodesic_loop> girth(const Mesh& mesh, const Mesh::Point& location, std::size_t maximum_number,
                                 std::optional<double> minimum_angle, bool certify);
std::vector<Tightened_curve> tighten(const Mesh& mesh, const std::vector<std::vector<Mesh::Vertex_index>>& loops,
                                     bool certify, Monitor& monitor);
CGAL::Surface_mesh_constrictions::Certificate certify(const Mesh& mesh, const Constriction& curve);
/// @}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_DETECT_H
