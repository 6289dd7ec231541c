// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_JOIN_FACES_H
#define CONSTRICTIONS_JOIN_FACES_H

#include "input/edge_groups.h"
#include "input/polygon_soup.h"

#include <vector>

namespace constrictions {

/// An edge with more than two faces, or with two that run along it in the same direction.
struct Crowded_edge
{
  Index u, v; ///< u < v
  std::vector<Edge_groups::Side> sides;
};

/// joins the triangles at each crowded edge in pairs, so that no two edges have the same ends once each fan of
/// triangles has a vertex of its own.
///
/// Each edge takes the first of `ways_to_pair()` for which that holds. As the result for an edge depends on its
/// neighbours, edges for which it does not hold take their next ways first, and go back to earlier ways later where
/// they can. Where no way helps, the surface is cut open along other edges of one end, which always does.
///
/// \param corners of one triangle after the other
/// \param opposite by side, the side on the other side of the edge or `null_index`; set at crowded edges and where cut
///
/// Linear in the number of triangles, but for crowded edges whose first way does not hold: linear in the number of
/// corners and crowded edges at their ends, for each way of each of their neighbours.
void join_faces(const std::vector<Point>& points, const std::vector<Index>& corners,
                const std::vector<Crowded_edge>& edges, bool is_inside_out, std::vector<Index>& opposite);

} // namespace constrictions

#endif // CONSTRICTIONS_JOIN_FACES_H
