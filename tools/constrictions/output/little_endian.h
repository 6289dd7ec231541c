// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_LITTLE_ENDIAN_H
#define CONSTRICTIONS_LITTLE_ENDIAN_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace constrictions {

/// appends the bytes of a number, the least significant first, whatever the order of this machine.
template <class Number>
void append_little_endian(Number number, std::string& out)
{
  static_assert(std::is_arithmetic<Number>::value && sizeof(Number) <= 8);
  typedef std::conditional_t<sizeof(Number) == 1, std::uint8_t,
                             std::conditional_t<sizeof(Number) == 2, std::uint16_t,
                                                std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>>
      Bits;
  Bits bits;
  static_assert(sizeof bits == sizeof number);
  std::memcpy(&bits, &number, sizeof bits);
  for(std::size_t i = 0; i < sizeof bits; ++i)
    out += static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xff);
}

} // namespace constrictions

#endif // CONSTRICTIONS_LITTLE_ENDIAN_H
