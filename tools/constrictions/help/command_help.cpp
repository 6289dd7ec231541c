// SPDX-License-Identifier: GPL-3.0-or-later
#include "help/command_help.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>

namespace constrictions {

namespace {

Option_help option_help(const CLI::Option& option)
{
  Option_help result{{}, option.get_type_name(), option.get_description()};
  if(option.get_positional())
    result.names.push_back(option.get_name(true));
  else
  {
    for(const std::string& name : option.get_snames())
      result.names.push_back("-" + name);
    for(const std::string& name : option.get_lnames())
      result.names.push_back("--" + name);
  }
  return result;
}

} // namespace

std::vector<std::string> Option_help::choices() const
{
  std::vector<std::string> result;
  std::istringstream words(value);
  for(std::string word; std::getline(words, word, '|');)
    if(!word.empty() && std::all_of(word.begin(), word.end(),
                                    [](unsigned char c) { return std::islower(c) != 0 || std::isdigit(c) != 0; }))
      result.push_back(word);
    else
      return {};
  return result;
}

Command_help command_help(const CLI::App& app)
{
  Command_help result{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
  for(const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    (option->get_positional() ? result.arguments : result.options).push_back(option_help(*option));
  for(const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    result.commands.push_back(command_help(*command));
  return result;
}

std::vector<std::string> paragraphs(const std::string& text)
{
  std::vector<std::string> result;
  std::istringstream lines(text);
  bool is_new = true;
  for(std::string line; std::getline(lines, line);)
  {
    if(line.empty())
    {
      is_new = true;
      continue;
    }
    if(is_new)
      result.push_back(line);
    else
      result.back() += (line.front() == ' ' ? '\n' : ' ') + line;
    is_new = false;
  }
  return result;
}

} // namespace constrictions
