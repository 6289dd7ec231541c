// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/from_base64.h"

#include <algorithm>
#include <cstdint>

namespace constrictions {

namespace {

// -1 if it is no digit.
int value_of_digit(char c)
{
  if('A' <= c && c <= 'Z')
    return c - 'A';
  if('a' <= c && c <= 'z')
    return c - 'a' + 26;
  if('0' <= c && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

} // namespace

std::optional<std::string> from_base64(std::string_view text, std::size_t most)
{
  std::string result;
  result.reserve((std::min)(most, text.size() / 4 * 3) + 3);
  std::uint32_t bits = 0;
  int digits = 0, padding = 0;
  for(std::size_t i = 0; i < text.size() && result.size() < most; ++i)
  {
    if(is_blank(text[i]))
      continue;
    const int digit = value_of_digit(text[i]);
    if(text[i] == '=' && digits >= 2)
      ++padding;
    else if(digit < 0 || padding > 0)
      return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(text[i] == '=' ? 0 : digit);
    if(++digits < 4)
      continue;
    for(int byte = 0; byte < 3 - padding; ++byte)
      result += static_cast<char>(bits >> (16 - 8 * byte) & 255);
    bits = 0;
    digits = padding = 0;
  }
  if(digits == 1 || (padding > 0 && digits > 0))
    return std::nullopt;
  // the padding at the end may be missing
  for(int byte = 0; byte < digits - 1; ++byte)
    result += static_cast<char>(bits << 6 * (4 - digits) >> (16 - 8 * byte) & 255);
  result.resize((std::min)(result.size(), most));
  return result;
}

} // namespace constrictions
