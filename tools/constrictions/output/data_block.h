// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_DATA_BLOCK_H
#define CONSTRICTIONS_DATA_BLOCK_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace constrictions {

/// Arrays of numbers in one block of bytes, as a page reads them: each is little-endian and starts at a multiple of
/// four bytes, so that it is a typed array of JavaScript where it lies. The directory tells for each name the type of
/// the numbers, `f32`, `u32`, `u16`, `u8` or `i8`, the offset in bytes, and how many they are.
class Data_block
{
public:
  void add(const std::string& name, const std::vector<float>& numbers);
  void add(const std::string& name, const std::vector<std::uint16_t>& numbers);
  void add(const std::string& name, const std::vector<std::uint8_t>& numbers);
  void add(const std::string& name, const std::vector<std::int8_t>& numbers);

  /// as `u16` if no number is too large for that, else as `u32`
  void add(const std::string& name, const std::vector<std::uint32_t>& numbers);

  const nlohmann::ordered_json& directory() const { return m_directory; }
  const std::string& bytes() const { return m_bytes; }

private:
  template <class Number>
  void append(const std::string& name, const char* type, const std::vector<Number>& numbers);

  nlohmann::ordered_json m_directory = nlohmann::ordered_json::object();
  std::string m_bytes;
};

} // namespace constrictions

#endif // CONSTRICTIONS_DATA_BLOCK_H
