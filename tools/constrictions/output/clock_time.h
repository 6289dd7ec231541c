// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CLOCK_TIME_H
#define CONSTRICTIONS_CLOCK_TIME_H

#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>

namespace constrictions {

/// a number of seconds as h:mm:ss
inline std::string clock_time(double seconds)
{
  const auto s = static_cast<std::uint64_t>(seconds + 0.5);
  std::ostringstream out;
  out << std::setfill('0') << s / 3600 << ':' << std::setw(2) << s / 60 % 60 << ':' << std::setw(2) << s % 60;
  return out.str();
}

} // namespace constrictions

#endif // CONSTRICTIONS_CLOCK_TIME_H
