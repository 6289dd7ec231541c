// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PART_FORMAT_H
#define CONSTRICTIONS_PART_FORMAT_H

#include <optional>
#include <string>
#include <vector>

namespace constrictions {

/// The format of the files of the parts.
enum class Part_format
{
  PLY,
  STL,
  OBJ,
  GLB,
  THREE_MF ///< one file for all parts
};

/// the names of the formats, which are the extensions of their files, in the order of the values
const std::vector<std::string>& part_format_names();

/// the format of that name
std::optional<Part_format> part_format(const std::string& name);

} // namespace constrictions

#endif // CONSTRICTIONS_PART_FORMAT_H
