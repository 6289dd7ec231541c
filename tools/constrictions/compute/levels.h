// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_LEVELS_H
#define CONSTRICTIONS_LEVELS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>

#include <optional>

namespace constrictions {

/// A surface with all the levels of its simplification, for those who ask for it.
typedef std::optional<CGAL::Surface_mesh_constrictions::Progressive_mesh> Levels;

} // namespace constrictions

#endif // CONSTRICTIONS_LEVELS_H
