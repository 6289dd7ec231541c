// SPDX-License-Identifier: GPL-3.0-or-later
#include "data_block.h"

#include <algorithm>
#include <cstring>

namespace constrictions {

namespace {

// The bits of a number as an unsigned one of the same size.
std::uint32_t bits_of(float number)
{
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof number);
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

template <class Integer>
std::uint32_t bits_of(Integer number)
{
  return static_cast<std::uint32_t>(number);
}

} // namespace

template <class Number>
void Data_block::append(const std::string& name, const char* type, const std::vector<Number>& numbers)
{
  m_bytes.resize((m_bytes.size() + 3) / 4 * 4);
  m_directory[name] = {{"type", type}, {"offset", m_bytes.size()}, {"length", numbers.size()}};
  m_bytes.reserve(m_bytes.size() + numbers.size() * sizeof(Number));
  for(Number n : numbers)
  {
    const std::uint32_t bits = bits_of(n);
    for(std::size_t i = 0; i < sizeof(Number); ++i)
      m_bytes += static_cast<char>(bits >> (8 * i) & 0xff);
  }
}

void Data_block::add(const std::string& name, const std::vector<float>& numbers) { append(name, "f32", numbers); }
void Data_block::add(const std::string& name, const std::vector<std::uint16_t>& numbers) { append(name, "u16", numbers); }
void Data_block::add(const std::string& name, const std::vector<std::uint8_t>& numbers) { append(name, "u8", numbers); }
void Data_block::add(const std::string& name, const std::vector<std::int8_t>& numbers) { append(name, "i8", numbers); }

void Data_block::add(const std::string& name, const std::vector<std::uint32_t>& numbers)
{
  if(std::any_of(numbers.begin(), numbers.end(), [](std::uint32_t n) { return n > 0xffff; }))
    append(name, "u32", numbers);
  else
    append(name, "u16", std::vector<std::uint16_t>(numbers.begin(), numbers.end()));
}

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
