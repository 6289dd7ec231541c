// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_FIND_BORDER_H
#define CONSTRICTIONS_FIND_BORDER_H

#include "input/mesh_file.h"
#include "input/mesh_findings.h"

namespace constrictions {

/// tells of the holes of a mesh, of border edges with a vertex of the border in the middle, and of border vertices that
/// lie so near to others, compared with the length of border edges, that they are probably meant to be one. Near linear
/// in the length of the border.
void find_border(const Mesh& mesh, const File_numbering& numbering, Mesh_findings& findings);

/// the value of `--merge`, of one digit, that merges vertices up to this far from each other
double merging_distance_for(double distance);

} // namespace constrictions

#endif // CONSTRICTIONS_FIND_BORDER_H
