// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_DETECT_H
#define CONSTRICTIONS_PYTHON_DETECT_H

#include "monitor.h"
#include "surface.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh_constrictions::Tightened_curve<Mesh> Tightened_curve;

/// What is looked for, and which of what is found is selected; see `detect_constrictions()`.
struct Search
{
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

/// A mesh that is prepared once for queries. Several threads may ask it at a time.
class Prepared_mesh
{
public:
  /// \param is_for_detection whether it has the seed curves that `detect()` needs
  Prepared_mesh(const Mesh& mesh, bool is_for_detection, Monitor& monitor);
  /// reads what `as_file()` gives. Throws `Invalid_query_file`.
  Prepared_mesh(const Mesh& mesh, std::string_view file);
  ~Prepared_mesh();

  bool is_for_detection() const { return m_is_for_detection; }
  std::string as_file() const; ///< of one that is for detection

  Detected detect(const Search& search, Monitor& monitor) const;
  Detected near(const Mesh::Point& location, const Search& search, Monitor& monitor) const;
  std::vector<Geodesic_loop> girth(const Mesh::Point& location, std::size_t maximum_number,
                                   std::optional<double> minimum_angle, bool certify) const;
  Plane_section section(const Mesh::Point& location, const Mesh::Point::R::Vector_3& axis, bool certify) const;
  std::vector<Tightened_curve> tighten(const std::vector<std::vector<Mesh::Vertex_index>>& loops, bool certify,
                                       Monitor& monitor) const;

private:
  struct Query;
  bool m_is_for_detection;
  std::unique_ptr<const Query> m_query;
};

/// the prepared mesh of a surface, which is made when it is first asked for
std::shared_ptr<const Prepared_mesh> prepared(const Surface& surface, Monitor& monitor);

/// the same, one that is for detection
std::shared_ptr<const Prepared_mesh> prepared_for_detection(const Surface& surface, Monitor& monitor);

/// makes what was read the prepared mesh of a surface. Throws `Invalid_query_file`.
void read_prepared(const Surface& surface, std::string_view file);

/// \name Computations
/// Without Python, in files of their own, as they take long to compile.
/// @{
Detected detect(const Surface& surface, const Search& search, Monitor& monitor);
CGAL::Surface_mesh_constrictions::Certificate certify(const Mesh& mesh, const Constriction& curve);
std::vector<Constriction> measure(const Mesh& mesh, const std::vector<Constriction>& curves);
/// @}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_DETECT_H
