// SPDX-License-Identifier: GPL-3.0-or-later
#include "help/command_help.h"

#include <cctype>
#include <string>
#include <vector>

namespace constrictions {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string result;
  for(const std::string& word : words)
    result += (result.empty() ? "" : separator) + word;
  return result;
}

std::string names_of_options(const Command_help& command)
{
  std::vector<std::string> names;
  for(const Option_help& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names, " ");
}

std::string names_of_commands(const Command_help& program)
{
  std::vector<std::string> names;
  for(const Command_help& command : program.commands)
    names.push_back(command.name);
  return joined(names, " ");
}

// What bash offers behind an option: files where nothing is replied.
std::string reply_behind(const Option_help& option)
{
  if(!option.choices().empty())
    return "COMPREPLY=($(compgen -W \"" + joined(option.choices(), " ") + "\" -- \"$current\"))";
  if(option.takes_folder())
    return "compopt -o dirnames +o default";
  return option.takes_file() ? ":" : "compopt +o default";
}

// The words of a text up to the first mark, without what zsh takes for something else.
std::string summary(const std::string& text)
{
  std::string result;
  for(char c : text.substr(0, text.find_first_of(",;:.([")))
    if(std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '-')
      result += c;
  while(!result.empty() && result.back() == ' ')
    result.pop_back();
  return result;
}

std::string words_of_zsh(const Option_help& option)
{
  if(!option.choices().empty())
    return '(' + joined(option.choices(), " ") + ')';
  return option.takes_folder() ? "_files -/" : option.takes_file() ? "_files" : " ";
}

// An option as _arguments has it: a list of its names, what it does, and what it takes.
std::string option_of_zsh(const Option_help& option)
{
  const std::string value =
      option.value.empty() ? "" : ':' + (option.choices().empty() ? option.value : "word") + ':' + words_of_zsh(option);
  const std::string what = "'[" + summary(option.text) + ']' + value + '\'';
  return option.names.size() == 1 ? option.names.front() + what
                                  : "'(" + joined(option.names, " ") + ")'{" + joined(option.names, ",") + '}' + what;
}

} // namespace

std::string bash_completion(const Command_help& program)
{
  std::string out = "# bash completion for " + program.name + "\n\n_" + program.name +
                    "()\n{\n"
                    "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options\n"
                    "  COMPREPLY=()\n"
                    "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
                    "    COMPREPLY=($(compgen -W \"" +
                    names_of_commands(program) + ' ' + names_of_options(program) +
                    "\" -- \"$current\"))\n"
                    "    return\n"
                    "  fi\n"
                    "  case ${COMP_WORDS[1]} in\n";
  for(const Command_help& command : program.commands)
  {
    out += "    " + command.name + ")\n      case $previous in\n";
    for(const Option_help& option : command.options)
      if(!option.value.empty())
        out += "        " + joined(option.names, "|") + ")\n          " + reply_behind(option) +
               "\n          return\n          ;;\n";
    out += "      esac\n      options=\"" + names_of_options(command) + "\"\n      ;;\n";
  }
  return out +
         "  esac\n"
         "  case $current in\n"
         "    -*) COMPREPLY=($(compgen -W \"$options\" -- \"$current\")) ;;\n"
         "  esac\n"
         "}\n\n"
         "# Where nothing is replied, the names of files.\n"
         "complete -o default -F _" +
         program.name + ' ' + program.name + '\n';
}

std::string zsh_completion(const Command_help& program)
{
  std::string out = "#compdef " + program.name + "\n\n_" + program.name +
                    "()\n{\n"
                    "  local -a commands\n"
                    "  commands=(\n";
  for(const Command_help& command : program.commands)
    out += "    '" + command.name + ':' + summary(command.text) + "'\n";
  out += "  )\n"
         "  if ((CURRENT == 2)); then\n"
         "    _describe command commands\n"
         "    _arguments";
  for(const Option_help& option : program.options)
    out += " \\\n      " + option_of_zsh(option);
  out += "\n    return\n"
         "  fi\n"
         "  shift words\n"
         "  ((--CURRENT))\n"
         "  case $words[1] in\n";
  for(const Command_help& command : program.commands)
  {
    out += "    " + command.name + ")\n      _arguments";
    for(const Option_help& option : command.options)
      out += " \\\n        " + option_of_zsh(option);
    out += " \\\n        '*:" + command.arguments.front().names.front() + ":_files'\n      ;;\n";
  }
  return out + "  esac\n}\n\n_" + program.name + " \"$@\"\n";
}

} // namespace constrictions
