// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BATCH_SUMMARY_H
#define CONSTRICTIONS_BATCH_SUMMARY_H

#include "batch/batch_line.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace constrictions {

/// Adds up the lines of a batch.
class Batch_summary
{
public:
  void add(const Batch_line& line);

  std::string as_table() const;

private:
  struct Timed_file
  {
    double seconds;
    std::string file;
  };

  std::size_t failed() const;

  std::size_t m_meshes = 0, m_faces = 0, m_constrictions = 0, m_certified = 0;
  double m_seconds = 0;
  std::map<std::string, std::size_t> m_failed;                         // of each kind
  std::map<std::string, std::map<std::string, std::size_t>> m_reasons; // of each kind, the number of each
  std::vector<Timed_file> m_slowest;                                   // a few, the slowest first
};

} // namespace constrictions

#endif // CONSTRICTIONS_BATCH_SUMMARY_H
