// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CURVE_OF_REPORT_H
#define CONSTRICTIONS_CURVE_OF_REPORT_H

#include "output/report.h"

#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

/// the points of a curve of the report, closed, the first not repeated
std::vector<Mesh::Point> points_of_curve(const Report& report, std::size_t id);

/// where these points are. Two coordinates are zero at vertices only: a crossing that rounding has moved to an end of
/// its edge is given beside it, so that its edge can be told from the numbers.
std::vector<Constriction::Face_location> locations_of_curve(const Report& report, std::size_t id);

/// as above, of any curve on the mesh
std::vector<Constriction::Face_location> locations_of_curve(const Mesh& mesh, const Constriction& curve);

/// whether these points are vertices that the curve passes through
std::vector<bool> pivots_of_curve(const Report& report, std::size_t id);

/// the verdict on the curve: that of its certificate, or of a loop that is held at a place, and no constriction, that
std::string verdict_on_curve(const Report& report, std::size_t id);

/// the end of a loop that is held at a place when it is let go: constriction, point, not_simple or not_certified
const char* end_name(const Geodesic_loop& loop);
const char* end_name(CGAL::Surface_mesh_constrictions::Tightening_verdict verdict);

/// how a loop is held, and its end when it is let go, in one line
std::string loop_as_text(const Report& report, std::size_t id);

} // namespace constrictions

#endif // CONSTRICTIONS_CURVE_OF_REPORT_H
