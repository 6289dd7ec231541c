// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_COMMAND_LINE_H
#define CONSTRICTIONS_COMMAND_LINE_H

#include "options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace constrictions {

/// Words of the command line that become options when all of it has been read.
struct Words
{
  std::string policy = "gh";
  std::string side;
};

/// describes the program to `app`: its commands with their options, which are stored in the two others when a command
/// line is parsed. They must live as long as `app`.
void describe_program(CLI::App& app, Options& options, Words& words);

} // namespace constrictions

#endif // CONSTRICTIONS_COMMAND_LINE_H
