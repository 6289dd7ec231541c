// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PAIR_SIDES_H
#define CONSTRICTIONS_PAIR_SIDES_H

#include "input/polygon_soup.h"

#include <array>
#include <vector>

namespace constrictions {

/// A side of a triangle at an edge.
struct Side_at_edge
{
  Index side;
  bool is_forth; ///< whether the triangle runs along the edge from its first end to the second
  Point apex;    ///< the third corner
};

typedef std::array<Index, 2> Side_pair;

/// returns ways to pair the sides at the edge from u to v, each with one that runs in the other direction, the best
/// first. Faces are looked at in their order around the edge; where a face's normal points away from the next one, the
/// inside of the body begins there, and it is paired with the face where that inside ends. So bodies that touch at an
/// edge stay apart. The second way pairs faces across the outside. Then come all others, those of more pairs first; if
/// there are more than six sides, only these two without one of their pairs. The last way pairs none. A side that finds
/// no partner is in no pair.
///
/// \param is_inside_out whether normals point inside
std::vector<std::vector<Side_pair>> ways_to_pair(const Point& u, const Point& v, const std::vector<Side_at_edge>& sides,
                                                 bool is_inside_out);

} // namespace constrictions

#endif // CONSTRICTIONS_PAIR_SIDES_H
