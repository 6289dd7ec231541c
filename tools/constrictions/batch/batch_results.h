// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BATCH_RESULTS_H
#define CONSTRICTIONS_BATCH_RESULTS_H

#include "batch/batch_input.h"
#include "batch/batch_line.h"
#include "system/posix.h"

#include <functional>
#include <string>

namespace constrictions {

/// The file in a folder to which the lines of a batch are appended. A line is there as a whole or, if the program was
/// killed while it wrote, without its end, and then it does not count. Nobody else writes to the file at the same time.
class Batch_results
{
public:
  /// opens the file for a slice, `results.jsonl` or `results.I-of-N.jsonl`; it is created if missing.
  ///
  /// Throws `Output_file_error` if it cannot be written, or another process has opened it.
  Batch_results(const std::string& folder, const Slice& slice);
  Batch_results(const Batch_results&) = delete;
  Batch_results& operator=(const Batch_results&) = delete;

  /// calls `f` with each line of all files with results in the folder. A line without its end is removed from the file
  /// that is written to.
  ///
  /// Throws `Input_file_error` if a file has another line that is not in the format of a batch.
  void for_each_line(const std::function<void(const Batch_line&)>& f) const;

  /// Throws `Output_file_error`.
  void append(const Batch_line& line) const;

private:
  std::string m_folder, m_name;
  Locked_file m_file;
};

/// writes the settings, on which the results depend, into a file of the folder. Where they are already, nothing is
/// done.
///
/// Throws `Input_file_error` if the folder has results that were made with other settings.
void keep_settings(const std::string& folder, const nlohmann::ordered_json& settings);

} // namespace constrictions

#endif // CONSTRICTIONS_BATCH_RESULTS_H
