// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BATCH_PROGRESS_H
#define CONSTRICTIONS_BATCH_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace constrictions {

/// Shows on one line of the standard error output how many meshes are done, and estimates the time that is left from
/// the sizes of the files: meshes differ by far.
class Batch_progress
{
public:
  /// \param is_shown whether to show anything
  /// \param meshes, bytes what there is to do
  Batch_progress(bool is_shown, std::size_t meshes, std::uint64_t bytes);
  /// ends the line
  ~Batch_progress();

  void add(std::uint64_t bytes, bool has_failed);
  void show();

private:
  bool m_is_shown;
  std::size_t m_meshes, m_done = 0, m_failed = 0;
  std::uint64_t m_bytes, m_bytes_done = 0;
  std::chrono::steady_clock::time_point m_begin;
};

} // namespace constrictions

#endif // CONSTRICTIONS_BATCH_PROGRESS_H
