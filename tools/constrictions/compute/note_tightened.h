// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_NOTE_TIGHTENED_H
#define CONSTRICTIONS_NOTE_TIGHTENED_H

#include "output/report.h"

#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>

#include <string>

namespace constrictions {

/// adds what a loop has become to the report: the constriction, or a remark that begins with `loop` and says why there
/// is none. Counts the outcome in the statistics.
void note_tightened(const CGAL::Surface_mesh_constrictions::Tightened_curve<Mesh>& tightened, const std::string& loop,
                    Report& report);

} // namespace constrictions

#endif // CONSTRICTIONS_NOTE_TIGHTENED_H
