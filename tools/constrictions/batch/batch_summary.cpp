// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_summary.h"

#include "input/input_file.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <utility>

namespace constrictions {

namespace {

// What the errors of many files have in common: without the name of the file, numbers and quoted words; of a mesh that
// cannot be used the defect only.
std::string reason(const Batch_line& line)
{
  if(!line.contains("error") || !line["error"].is_string())
    return "no reason is given";
  std::string error = line["error"].get<std::string>();
  const std::string name = printable(line["file"].get<std::string>()) + ": ";
  if(error.compare(0, name.size(), name) == 0)
    error.erase(0, name.size());
  std::string result;
  bool is_quoted = false;
  for(std::size_t i = 0; i < error.size(); ++i)
  {
    const auto is_digit = [&](std::size_t j) { return j < error.size() && error[j] >= '0' && error[j] <= '9'; };
    if(error[i] == '"')
    {
      is_quoted = !is_quoted;
      if(is_quoted)
        result += "...";
    }
    else if(is_quoted || (is_digit(i) && !result.empty() && result.back() == 'N'))
      continue;
    else
      result += is_digit(i) ? 'N' : error[i];
  }
  const std::string place = "line N: ";
  if(result.compare(0, place.size(), place) == 0)
    result.erase(0, place.size());
  return result.substr(0, result.find(':'));
}

} // namespace

void Batch_summary::add(const Batch_line& line)
{
  ++m_meshes;
  if(line["status"] == "ok")
  {
    m_faces += line["mesh"]["faces"].get<std::size_t>();
    for(const auto& c : line["constrictions"])
    {
      const std::string certificate = c["certificate"].get<std::string>();
      ++m_constrictions;
      m_certified += certificate == "strict_constriction" || certificate == "constriction";
    }
  }
  else
  {
    const std::string kind = line["kind"].get<std::string>();
    ++m_failed[kind];
    ++m_reasons[kind][reason(line)];
  }

  const std::size_t longest = 5;
  const double seconds = line["seconds"].get<double>();
  m_seconds += seconds;
  const auto place = std::find_if(m_slowest.begin(), m_slowest.end(),
                                  [&](const Timed_file& other) { return other.seconds < seconds; });
  m_slowest.insert(place, {seconds, file_of(line)});
  if(m_slowest.size() > longest)
    m_slowest.pop_back();
}

std::size_t Batch_summary::failed() const
{
  std::size_t result = 0;
  for(const auto& [kind, number] : m_failed)
    result += number;
  return result;
}

std::string Batch_summary::as_table() const
{
  using std::setw;

  std::ostringstream out;
  out << std::left << setw(16) << "meshes" << std::right << setw(10) << m_meshes << '\n';
  out << std::left << setw(16) << "ok" << std::right << setw(10) << m_meshes - failed() << "   " << m_faces
      << " faces, " << m_constrictions << (m_constrictions == 1 ? " constriction, " : " constrictions, ") << m_certified
      << " certified\n";
  out << std::left << setw(16) << "failed" << std::right << setw(10) << failed() << '\n';
  for(const auto& [kind, number] : m_failed)
  {
    out << std::left << setw(16) << "  " + kind << std::right << setw(10) << number << '\n';
    std::vector<std::pair<std::size_t, std::string>> reasons;
    for(const auto& [text, times] : m_reasons.at(kind))
      reasons.emplace_back(times, text);
    std::stable_sort(reasons.begin(), reasons.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for(const auto& [times, text] : reasons)
      out << setw(26) << times << "   " << text << '\n';
  }
  out << std::fixed << std::setprecision(2);
  out << std::left << setw(16) << "seconds in all" << std::right << setw(10) << m_seconds << '\n';
  if(!m_slowest.empty())
    out << "the slowest\n";
  for(const Timed_file& f : m_slowest)
    out << setw(26) << f.seconds << "   " << printable(f.file) << '\n';
  return out.str();
}

} // namespace constrictions
