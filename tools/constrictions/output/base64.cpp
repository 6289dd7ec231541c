// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace constrictions {

std::string as_base64(const std::string& bytes)
{
  static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t n = (std::min)(bytes.size() - i, std::size_t(3));
    std::uint32_t bits = 0;
    for(std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (j < n ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for(std::size_t j = 0; j < 4; ++j)
      result += j <= n ? digits[bits >> (18 - 6 * j) & 63] : '=';
  }
  return result;
}

} // namespace constrictions
