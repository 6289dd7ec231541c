// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_summary.h"

#include "input/input_file.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <sstream>

namespace constrictions {

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
    ++m_failed[line["kind"].get<std::string>()];

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
      << " faces, " << m_constrictions << (m_constrictions == 1 ? " constriction, " : " constrictions, ")
      << m_certified << " certified\n";
  out << std::left << setw(16) << "failed" << std::right << setw(10) << failed() << '\n';
  for(const auto& [kind, number] : m_failed)
    out << std::left << setw(16) << "  " + kind << std::right << setw(10) << number << '\n';
  out << std::fixed << std::setprecision(2);
  out << std::left << setw(16) << "seconds in all" << std::right << setw(10) << m_seconds << '\n';
  if(!m_slowest.empty())
    out << "the slowest\n";
  for(const Timed_file& f : m_slowest)
    out << setw(26) << f.seconds << "   " << printable(f.file) << '\n';
  return out.str();
}

} // namespace constrictions
