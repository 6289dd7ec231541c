// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_NUMBER_TYPE_H
#define CONSTRICTIONS_NUMBER_TYPE_H

#include "input/byte_reader.h"

#include <cstddef>
#include <cstdint>

namespace constrictions {

/// How a number is written in bytes.
enum class Number_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  INT64,
  UINT64,
  FLOAT32,
  FLOAT64
};

inline std::size_t size_of(Number_type type)
{
  switch(type)
  {
  case Number_type::INT8:
  case Number_type::UINT8:
    return 1;
  case Number_type::INT16:
  case Number_type::UINT16:
    return 2;
  case Number_type::INT32:
  case Number_type::UINT32:
  case Number_type::FLOAT32:
    return 4;
  default:
    return 8;
  }
}

/// the number whose bytes begin at `bytes`, as a double: exact but for integers of 64 bits above 2^53
inline double number_of_type(Number_type type, const char* bytes, bool is_little_endian)
{
  switch(type)
  {
  case Number_type::INT8:
    return number_from_bytes<std::int8_t>(bytes, is_little_endian);
  case Number_type::UINT8:
    return number_from_bytes<std::uint8_t>(bytes, is_little_endian);
  case Number_type::INT16:
    return number_from_bytes<std::int16_t>(bytes, is_little_endian);
  case Number_type::UINT16:
    return number_from_bytes<std::uint16_t>(bytes, is_little_endian);
  case Number_type::INT32:
    return number_from_bytes<std::int32_t>(bytes, is_little_endian);
  case Number_type::UINT32:
    return number_from_bytes<std::uint32_t>(bytes, is_little_endian);
  case Number_type::INT64:
    return static_cast<double>(number_from_bytes<std::int64_t>(bytes, is_little_endian));
  case Number_type::UINT64:
    return static_cast<double>(number_from_bytes<std::uint64_t>(bytes, is_little_endian));
  case Number_type::FLOAT32:
    return number_from_bytes<float>(bytes, is_little_endian);
  default:
    return number_from_bytes<double>(bytes, is_little_endian);
  }
}

} // namespace constrictions

#endif // CONSTRICTIONS_NUMBER_TYPE_H
