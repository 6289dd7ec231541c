// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_COMMAND_HELP_H
#define CONSTRICTIONS_COMMAND_HELP_H

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace constrictions {

/// An option, or an argument that is known by its place.
struct Option_help
{
  std::vector<std::string> names; ///< such as "-o" or "--json"; of an argument its one name
  std::string value;              ///< what it takes, as in "FILE|-" or "gh|lt|length"; of a flag empty
  std::string text;

  /// the words that the value can be; empty if these are not listed
  std::vector<std::string> choices() const;

  bool takes_folder() const { return value == "DIR"; }
  bool takes_file() const { return value.rfind("FILE", 0) == 0 || value.rfind("LIST", 0) == 0; }
};

/// What is said of the program, or of one of its commands. The help, the man page and the completions of shells are
/// made of it.
struct Command_help
{
  std::string name;
  std::string text;   ///< paragraphs, with an empty line between two of them
  std::string footer; ///< paragraphs that stand at the end
  std::vector<Option_help> arguments;
  std::vector<Option_help> options;
  std::vector<Command_help> commands;
};

Command_help command_help(const CLI::App& app);

/// the help of a command in lines of no more than 80 characters, which break between words
/// \param called how the command is called, as in "constrictions detect"
std::string help_as_text(const Command_help& help, const std::string& called);

/// Lets CLI11 write the help as `help_as_text()` does.
class Help_formatter : public CLI::FormatterBase
{
public:
  std::string make_help(const CLI::App* app, std::string called, CLI::AppFormatMode) const override
  {
    return help_as_text(command_help(*app), called);
  }
};

/// \name Documents
/// @{

/// a man page of section 1, in the macros of `man`
std::string man_page(const Command_help& program, const std::string& version);

/// functions that complete command lines of the program in bash and in zsh
std::string bash_completion(const Command_help& program);
std::string zsh_completion(const Command_help& program);
/// @}

/// the paragraphs of a text: one that is written in lines becomes a single line, but for a list, whose lines begin with
/// blanks and stay as they are
std::vector<std::string> paragraphs(const std::string& text);

} // namespace constrictions

#endif // CONSTRICTIONS_COMMAND_HELP_H
