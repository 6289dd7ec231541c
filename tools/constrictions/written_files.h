// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_WRITTEN_FILES_H
#define CONSTRICTIONS_WRITTEN_FILES_H

#include "options.h"

namespace constrictions {

/// throws CLI::ValidationError if files that the program is to write would overwrite each other or the input. The
/// members of `Options` that name these files are defined beside it.
void check_files(const Options& options);

} // namespace constrictions

#endif // CONSTRICTIONS_WRITTEN_FILES_H
