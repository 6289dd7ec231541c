// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BATCH_LINE_H
#define CONSTRICTIONS_BATCH_LINE_H

#include "batch/process_pool.h"
#include "output/report.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

/// \file
/// The lines that `constrictions batch` writes: JSON objects in the format "constrictions-batch/1".

namespace constrictions {

typedef nlohmann::ordered_json Batch_line;

/// what was found, without the points of the curves.
Batch_line batch_line(const Report& report);

/// \param kind `input` the file is not a usable mesh, `time` and `memory` a limit was reached, `crash` the process was
///   ended by a signal, `exception` the program has met a state that it should not
Batch_line failed_batch_line(const std::string& file, const std::string& kind, const std::string& error);

/// the line about a file whose process has ended: what it returned, or why it did not; with time and memory.
Batch_line batch_line(const std::string& file, const Task_end& end, const Process_limits& limits);

/// as text in one line, with the end of the line
std::string as_text(const Batch_line& line);

/// throws `std::runtime_error`, with the reason, if the text is not a line of this format.
Batch_line parse_batch_line(std::string_view text);

/// the name of the file that the line is about. In JSON, bytes that are not UTF-8 are in the member "file_bytes".
std::string file_of(const Batch_line& line);

} // namespace constrictions

#endif // CONSTRICTIONS_BATCH_LINE_H
