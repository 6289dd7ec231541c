// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FROM_BASE64_H
#define FROM_BASE64_H

#include <cstdint>
#include <string>

// The bytes that a text in base64 stands for.
inline std::string from_base64(const std::string& text)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for(char c : text)
  {
    if(c == '=')
      break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    number_of_bits += 6;
    if(number_of_bits >= 8)
    {
      number_of_bits -= 8;
      result += static_cast<char>(bits >> number_of_bits & 0xff);
    }
  }
  return result;
}

#endif // FROM_BASE64_H
