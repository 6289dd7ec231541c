// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/closing_words.h"

#include "input/input_file.h"
#include "output/parts.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <sstream>

namespace constrictions {

namespace {

bool is_of_part(const Output_file& file)
{
  return is_part_file_name(std::filesystem::path(file.name).filename().string());
}

} // namespace

std::string written_files_as_text(const std::vector<Output_file>& files)
{
  std::vector<std::string> parts;
  std::ostringstream out;
  const auto add = [&out](const std::string& text) {
    out << (out.tellp() == 0 ? "written: " : "         ") << text << '\n';
  };
  for(const Output_file& file : files)
    if(is_of_part(file))
      parts.push_back(printable(file.name));
    else
      add(printable(file.name));
  if(parts.size() > 2)
    add(parts.front() + " to " + parts.back());
  else
    for(const std::string& part : parts)
      add(part);
  return out.str();
}

std::string result_as_text(const Report& report)
{
  std::ostringstream out;
  for(const std::string& remark : report.remarks)
    out << remark << '\n';
  const std::size_t n = report.constrictions.size();
  out << n << (report.is_girth ? " loop" : " constriction") << (n == 1 ? "" : "s");
  const auto shortest =
      std::min_element(report.constrictions.begin(), report.constrictions.end(),
                       [](const Constriction& a, const Constriction& b) { return a.length() < b.length(); });
  if(shortest != report.constrictions.end())
    out << (n == 1 ? ", "
                   : "; the narrowest, number " + std::to_string(shortest - report.constrictions.begin()) + ", is ")
        << shortest->length() << " long, around " << shortest->centroid()[0] << ' ' << shortest->centroid()[1] << ' '
        << shortest->centroid()[2];
  out << '\n';
  if(!report.hint.empty())
    out << report.hint << '\n';
  return out.str();
}

} // namespace constrictions
