// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_NOTE_LOOPS_H
#define CONSTRICTIONS_NOTE_LOOPS_H

#include "output/report.h"

#include <CGAL/Surface_mesh_constrictions/Plane_section.h>

#include <string>
#include <vector>

namespace constrictions {

/// appends loops that are held at a place to the curves of the report.
void add_loops(const std::vector<Geodesic_loop>& loops, bool certifies, Report& report);

/// appends a section to those of the report, and the loop that it becomes to its curves. Returns why there is no loop,
/// or an empty text.
std::string add_section(const CGAL::Surface_mesh_constrictions::Plane_section<Mesh>& section, bool certifies,
                        Report& report);

} // namespace constrictions

#endif // CONSTRICTIONS_NOTE_LOOPS_H
