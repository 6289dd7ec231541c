// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_USAGE_ERROR_H
#define CONSTRICTIONS_USAGE_ERROR_H

#include <CLI/CLI.hpp>

#include <string>

namespace constrictions {

/// what is wrong with the command line, in one line, with a guess of what was meant and where to read on.
/// \param app the program after it has failed to parse its arguments
std::string usage_error_as_text(const CLI::App& app, const CLI::ParseError& error);

} // namespace constrictions

#endif // CONSTRICTIONS_USAGE_ERROR_H
