// SPDX-License-Identifier: GPL-3.0-or-later
#include "option_values.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace constrictions {

std::string not_empty(const std::string& name) { return name.empty() ? "a name is missing" : ""; }

CLI::Validator greater_than_zero()
{
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value)
                   ? ""
                   : "give a number that is greater than 0";
      },
      "");
}

CLI::Validator whole_number(std::size_t low, std::size_t high)
{
  return CLI::Validator(
      [low, high](const std::string& text) {
        std::size_t value = 0;
        const std::from_chars_result r = std::from_chars(text.data(), text.data() + text.size(), value);
        if(r.ec == std::errc() && r.ptr == text.data() + text.size() && low <= value && value <= high)
          return std::string();
        return "give a whole number" + (high == (std::numeric_limits<std::size_t>::max)()
                                            ? (low == 0 ? "" : " from " + std::to_string(low) + " on")
                                            : " from " + std::to_string(low) + " to " + std::to_string(high));
      },
      "");
}

CLI::Validator not_negative()
{
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && value >= 0 ? "" : "give a number that is not negative";
      },
      "");
}

std::optional<std::array<double, 3>> parse_location(const std::string& text)
{
  std::array<double, 3> location;
  const char *begin = text.data(), *const end = begin + text.size();
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::from_chars_result r = std::from_chars(begin, end, location[i]);
    const bool is_last = i == 2;
    if(r.ec != std::errc() || !std::isfinite(location[i]) || (r.ptr == end) != is_last || (!is_last && *r.ptr != ','))
      return std::nullopt;
    begin = r.ptr + 1;
  }
  return location;
}

CLI::Validator is_location()
{
  return CLI::Validator(
      [](const std::string& text) {
        return parse_location(text) ? "" : "give three numbers separated by commas, as in 0.5,-1,2e3";
      },
      "");
}

std::optional<Slice> parse_slice(std::string_view text)
{
  std::size_t index = 0, count = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result i = std::from_chars(text.data(), end, index);
  if(i.ec != std::errc() || i.ptr == end || *i.ptr != '/')
    return std::nullopt;
  const std::from_chars_result n = std::from_chars(i.ptr + 1, end, count);
  if(n.ec != std::errc() || n.ptr != end || index < 1 || index > count)
    return std::nullopt;
  return Slice{index - 1, count};
}

} // namespace constrictions
