// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/colours.h"

#include <algorithm>
#include <cmath>

namespace constrictions {

// Hues in steps of the golden ratio.
Colour part_colour(std::size_t part)
{
  const double hue = std::fmod(0.09 + 0.6180339887498949 * static_cast<double>(part), 1.0);
  Colour result;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double k = std::fmod(hue * 6 + 5 - 2 * static_cast<double>(i), 6.0);
    const double away = (std::min)(k, 4 - k);
    result[i] = static_cast<std::uint8_t>(235 * (1 - 0.65 * (std::max)(0.0, (std::min)(1.0, away))));
  }
  return result;
}

Colour side_colour(CGAL::Surface_mesh_constrictions::Side side)
{
  using CGAL::Surface_mesh_constrictions::Side;
  return side == Side::OBJECT       ? Colour{{0xd5, 0x5e, 0x00}}
         : side == Side::COMPLEMENT ? Colour{{0x00, 0x72, 0xb2}}
                                    : Colour{{0x00, 0x9e, 0x73}};
}

} // namespace constrictions
