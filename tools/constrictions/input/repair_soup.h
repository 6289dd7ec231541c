// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_REPAIR_SOUP_H
#define CONSTRICTIONS_REPAIR_SOUP_H

#include "input/triangle_soup.h"

#include <vector>

namespace constrictions {

/// turns faces round until any two neighbours have the same orientation. A face that is turned keeps its first corner.
/// Returns the numbers of the faces that were turned, or nothing if the faces cannot be oriented that way or do not
/// form a manifold; the soup is unchanged then.
std::vector<Index> orient_soup(Triangle_soup& soup);

/// lets faces use the first of several vertices at the same position; the others keep their numbers, without faces.
/// Returns whether there were any. Positions must not be NaN.
bool close_seams(Triangle_soup& soup);

} // namespace constrictions

#endif // CONSTRICTIONS_REPAIR_SOUP_H
