// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage_error.h"

#include "input/input_file.h"
#include "nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace constrictions {

namespace {

typedef std::vector<std::string> Names;

// All of them, whether they were parsed or not.
std::vector<const CLI::App*> commands(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App*) { return true; });
}

Names options(const CLI::App& command)
{
  Names result;
  for(const CLI::Option* option : command.get_options())
  {
    for(const std::string& name : option->get_lnames())
      result.push_back("--" + name);
    for(const std::string& name : option->get_snames())
      result.push_back("-" + name);
  }
  return result;
}

bool has(const Names& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string question(const std::string& guess) { return guess.empty() ? "" : "; did you mean " + guess + "?"; }

std::string unknown_command(const CLI::App& app, const std::string& given)
{
  Names names;
  for(const CLI::App* command : commands(app))
    names.push_back(command->get_name());
  return "there is no command " + constrictions::quoted(given) + question(nearest_name(given, names));
}

std::string unknown_option(const CLI::App& app, const CLI::App& command, const std::string& given)
{
  const std::string name = given.substr(0, given.find('='));
  std::string result = command.get_name() + " has no option " + constrictions::quoted(name);
  const std::string guess = nearest_name(name, options(command));
  if(!guess.empty())
    return result + question(guess);
  Names others;
  for(const CLI::App* other : commands(app))
    if(has(options(*other), name))
      others.push_back(other->get_name());
  for(std::size_t i = 0; i < others.size(); ++i)
    result += (i == 0 ? "; it is one of " : i + 1 == others.size() ? " and " : ", ") + others[i];
  return result;
}

// What CLI11 says, as a part of a line.
std::string message_of(const CLI::ParseError& error)
{
  std::string text = error.what();
  while(!text.empty() && (text.back() == '\n' || text.back() == '.'))
    text.pop_back();
  return printable(text);
}

std::string what_is_wrong(const CLI::App& app, const CLI::App* command, const CLI::ParseError& error)
{
  const Names left = app.remaining(true); // what belongs to no option and no place
  const auto option =
      std::find_if(left.begin(), left.end(), [](const std::string& s) { return s.size() > 1 && s[0] == '-'; });
  if(option != left.end())
    return unknown_option(app, command == nullptr ? app : *command, *option);
  if(command == nullptr)
    return left.empty() ? "a command is missing" : unknown_command(app, left.front());
  if(!left.empty() && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return constrictions::quoted(left.front()) + " is one argument too many for " + command->get_name();
  return message_of(error);
}

} // namespace

std::string usage_error_as_text(const CLI::App& app, const CLI::ParseError& error)
{
  const std::vector<const CLI::App*> parsed =
      app.get_subcommands([&app](const CLI::App* c) { return app.got_subcommand(c->get_name()); });
  const CLI::App* const command = parsed.empty() ? nullptr : parsed.front();
  const std::string what = what_is_wrong(app, command, error);
  return what + (what.back() == '?' ? " See " : "; see ") + app.get_name() +
         (command == nullptr ? "" : ' ' + command->get_name()) + " --help";
}

} // namespace constrictions
