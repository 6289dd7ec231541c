// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CURVES_FILE_H
#define CONSTRICTIONS_CURVES_FILE_H

#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <cstdint>
#include <string>
#include <vector>

namespace constrictions {

/// Closed curves on a mesh, and what their file calls them.
struct Curves
{
  std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> curves;
  std::vector<std::uint64_t> ids;
  bool are_found_by_points = false; ///< as the numbers in the file are those of another file of the mesh
};

/// reads closed curves from the JSON object that `report_as_json()` writes. Of each member of "constrictions" it takes
/// - "locations": a point each, the number of a face and barycentric coordinates in the order of its corners in the
///   file of the mesh, or, for a face that is not a triangle there, of the vertices in "triangle". One coordinate is
///   zero, and the curve crosses the edge where it is, or two are, and the curve passes through a vertex. A coordinate
///   is zero if it is exactly 0; if none is, the smallest, if it is below 1e-9.
/// - "pivots": the points that are vertices. A point at a vertex that is not among them is a crossing beside it, if
///   the face of the next point lies across an edge there. At a seam of doubled vertices any of them may be named;
///   copies of a vertex that was split are called as in the file. If the member is missing all points at vertices are
///   pivots.
/// - "id", which may be missing: then it is the curve's place, counted from 0.
///
/// If the member "points" is there, and more than a quarter of the crossings, or of the pivots, are not in the
/// faces, and there nearest to the edges or corners, that the locations and pivots name, the mesh has been numbered
/// anew, or its faces begin at other corners. Then the points are looked for on the mesh, within 1e-5 of the diagonal of its box, which
/// allows for a file with six digits.
///
/// Which of its two faces an edge is crossed from follows from the neighbouring points, or, where these leave a doubt,
/// is the face that is given. Of the curves that are returned only the locations and the length are filled in; the
/// length is that of the polygon through the points as they are given.
///
/// \param name the file
/// \param mesh what the curves lie on
/// \param numbering how its elements are called in its file
///
/// Throws `Input_file_error`, with the id of the curve and the number of the point, for anything else, and for points
/// that are looked for and not on the mesh. Whether
/// consecutive points fit together is not checked: that is for the certificate to say.
Curves read_curves_file(const std::string& name, const Mesh& mesh, const File_numbering& numbering);

} // namespace constrictions

#endif // CONSTRICTIONS_CURVES_FILE_H
