// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CLOSING_WORDS_H
#define CONSTRICTIONS_CLOSING_WORDS_H

#include "output/output_file.h"
#include "output/report.h"

#include <string>
#include <vector>

namespace constrictions {

/// the names of files that were written, in lines; of more than two files of parts the first and the last one
std::string written_files_as_text(const std::vector<Output_file>& files);

/// what was found, in one line: how many constrictions, and where the shortest is; after the remarks, and before the
/// hint of the report
std::string result_as_text(const Report& report);

} // namespace constrictions

#endif // CONSTRICTIONS_CLOSING_WORDS_H
