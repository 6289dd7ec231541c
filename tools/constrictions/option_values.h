// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_OPTION_VALUES_H
#define CONSTRICTIONS_OPTION_VALUES_H

#include "batch/batch_input.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace constrictions {

/// \name Checks
/// of the values of options. A message says what to give instead.
/// @{
std::string not_empty(const std::string& name);
CLI::Validator greater_than_zero();
CLI::Validator not_negative();
CLI::Validator is_location();

/// a whole number from `low` to `high`; without an end if that is the greatest
CLI::Validator whole_number(std::size_t low, std::size_t high = (std::numeric_limits<std::size_t>::max)());
/// @}

/// three numbers separated by commas
std::optional<std::array<double, 3>> parse_location(const std::string& text);

/// two whole numbers with a slash between them, 1 <= I <= N
std::optional<Slice> parse_slice(std::string_view text);

} // namespace constrictions

#endif // CONSTRICTIONS_OPTION_VALUES_H
