// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PROGRESS_LINE_H
#define CONSTRICTIONS_PROGRESS_LINE_H

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>

#include <string>

namespace constrictions {

/// The stages that a computation goes through.
struct Stages
{
  CGAL::Surface_mesh_constrictions::Detection_stage first, last;
};

/// how far a computation has got, in less than 80 characters: the stage, how much of the whole is done, the time that has
/// passed and, when there is enough to guess from, the time that is left. It is a guess: how long the stages take,
/// compared with each other, depends on the mesh.
/// \param stage the present one
/// \param part how much of it is done, from 0 to 1
std::string progress_line(const Stages& all, CGAL::Surface_mesh_constrictions::Detection_stage stage, double part,
                          double seconds);

} // namespace constrictions

#endif // CONSTRICTIONS_PROGRESS_LINE_H
