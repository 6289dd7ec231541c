// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_NAMES_H
#define CONSTRICTIONS_PYTHON_NAMES_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Plane_section.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>

namespace constrictions {

/// \name What values are called in Python
/// As in the format "constrictions/1" where that has them.
/// @{
const char* name_of(CGAL::Surface_mesh_constrictions::Certificate_verdict verdict);
const char* name_of(CGAL::Surface_mesh_constrictions::Curve_side side);
const char* name_of(CGAL::Surface_mesh_constrictions::Detection_stage stage);
const char* name_of(CGAL::Surface_mesh_constrictions::Input_defect defect);
const char* name_of(CGAL::Surface_mesh_constrictions::Section_kind kind);
const char* name_of(CGAL::Surface_mesh_constrictions::Seed_origin origin);
const char* name_of(CGAL::Surface_mesh_constrictions::Side side);
const char* name_of(CGAL::Surface_mesh_constrictions::Tightening_verdict verdict);
/// @}

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_NAMES_H
