// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/data_block.h"

#include "output/little_endian.h"

#include <algorithm>

namespace constrictions {

template <class Number>
void Data_block::append(const std::string& name, const char* type, const std::vector<Number>& numbers)
{
  m_bytes.resize((m_bytes.size() + 3) / 4 * 4);
  m_directory[name] = {{"type", type}, {"offset", m_bytes.size()}, {"length", numbers.size()}};
  m_bytes.reserve(m_bytes.size() + numbers.size() * sizeof(Number));
  for(Number n : numbers)
    append_little_endian(n, m_bytes);
}

void Data_block::add(const std::string& name, const std::vector<float>& numbers) { append(name, "f32", numbers); }
void Data_block::add(const std::string& name, const std::vector<std::uint16_t>& numbers)
{
  append(name, "u16", numbers);
}
void Data_block::add(const std::string& name, const std::vector<std::uint8_t>& numbers) { append(name, "u8", numbers); }
void Data_block::add(const std::string& name, const std::vector<std::int8_t>& numbers) { append(name, "i8", numbers); }

void Data_block::add(const std::string& name, const std::vector<std::uint32_t>& numbers)
{
  if(std::any_of(numbers.begin(), numbers.end(), [](std::uint32_t n) { return n > 0xffff; }))
    append(name, "u32", numbers);
  else
    append(name, "u16", std::vector<std::uint16_t>(numbers.begin(), numbers.end()));
}

} // namespace constrictions
