// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_REPAIR_SOUP_H
#define CONSTRICTIONS_REPAIR_SOUP_H

#include "input/file_numbering.h"
#include "input/mesh_findings.h"
#include "input/polygon_soup.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <vector>

namespace constrictions {

/// An oriented triangle mesh whose vertices have one fan of faces each. At the border `opposite` is `null_index`.
struct Repaired_soup
{
  std::vector<Point> points; ///< those of the file, and copies where vertices have been split
  CGAL::Surface_mesh_constrictions::internal::Corner_table table;
  File_numbering numbering;
};

/// makes a triangle mesh of what a file holds, and tells in `findings` what had to be done for it, in this order:
/// 1. vertices nearer to each other than `merging_distance`, if that is not 0, are merged, each into the first one
/// near;
/// 2. edges of length zero are collapsed;
/// 3. where border edges have the same ends in space, their vertices are merged, if that leaves less border in the end;
/// 4. faces with fewer than three different corners, and faces whose corners another one has, are left out. Of a region
///    whose faces are all there in both orientations one layer is left out if that makes its rim a surface;
/// 5. polygons are cut into triangles;
/// 6. triangles without area at edges with more than two faces are left out if that makes no hole;
/// 7. triangles are turned round, as few as possible;
/// 8. edges with more than two faces are made several, and vertices with more than one fan of faces too. Of the ways to
///    pair the faces at an edge the one is taken that keeps solids apart: each face is joined to the next one around
///    the edge, seen from the inside of the body; if two edges with the same ends would be left, across the outside, or
///    in other pairs; if that does not help the surface is cut open along the edge, or else along edges beside it;
/// 9. bodies of two faces with the same corners are left out.
///
/// No vertex is moved. What comes out is at rest: written to a file whose faces refer to vertices by number, and read
/// again, it is the same mesh, and nothing is repaired. For that it is repaired again where step 3 would leave less
/// border; where there is no less, what is written apart stays so, such as the two sides of an edge that was cut open.
///
/// Linear but for sorting, the square of the number of faces at one edge, and what `join_faces()` does where the first
/// pairs do not help; times the number of repairs of repairs, of which each leaves less border.
///
/// Throws `Invalid_input` for a coordinate that is not finite, for a surface that cannot be oriented, and if no face is
/// left. A surface that can be oriented as it is written, but not with its seams closed, is refused if that shows at
/// places where no more than two faces meet in space.
Repaired_soup repair_soup(const Polygon_soup& soup, double merging_distance, Mesh_findings& findings);

} // namespace constrictions

#endif // CONSTRICTIONS_REPAIR_SOUP_H
