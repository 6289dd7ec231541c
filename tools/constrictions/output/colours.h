// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_COLOURS_H
#define CONSTRICTIONS_COLOURS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace constrictions {

/// red, green and blue
typedef std::array<std::uint8_t, 3> Colour;

/// the colour of a part: whatever the number of parts, those with near numbers differ.
Colour part_colour(std::size_t part);

/// the colour of a curve by what it chokes: of those of Okabe and Ito vermillion for the object, blue for the
/// complement, and green for both
Colour side_colour(CGAL::Surface_mesh_constrictions::Side side);

} // namespace constrictions

#endif // CONSTRICTIONS_COLOURS_H
