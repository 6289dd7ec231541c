// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BYTE_READER_H
#define CONSTRICTIONS_BYTE_READER_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace constrictions {

/// the number whose bytes begin at `bytes`, in the order given
template <class T>
T number_from_bytes(const char* bytes, bool is_little_endian)
{
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  const std::uint16_t one = 1;
  unsigned char low_byte = 0;
  std::memcpy(&low_byte, &one, 1);
  if((low_byte == 1) != is_little_endian)
    std::reverse(copy.begin(), copy.end());
  T value;
  std::memcpy(&value, copy.data(), sizeof(T));
  return value;
}

} // namespace constrictions

#endif // CONSTRICTIONS_BYTE_READER_H
