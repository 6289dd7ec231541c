// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_RUN_BATCH_H
#define CONSTRICTIONS_RUN_BATCH_H

#include "options.h"
#include "output/report.h"

#include <functional>
#include <string>

namespace constrictions {

/// calls `detect` for each of the given meshes, each call in a process of its own, and writes a line for
/// each as it ends: into the folder of the options, where meshes that have a line already are skipped, or to the
/// standard output. Whatever happens to a mesh is a line.
///
/// After SIGINT, SIGTERM or SIGHUP the processes are ended, and then this one, by the same signal.
///
/// Throws `Input_file_error` for inputs and results that cannot be read, and `Output_file_error`.
void run_batch(const Options& options, const std::function<Report(const std::string& mesh)>& detect);

} // namespace constrictions

#endif // CONSTRICTIONS_RUN_BATCH_H
