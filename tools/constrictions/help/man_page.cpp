// SPDX-License-Identifier: GPL-3.0-or-later
#include "help/command_help.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>

namespace constrictions {

namespace {

// Text as it stands: a backslash begins a request, as do a point and an apostrophe at the beginning of a line, and a
// hyphen may be shown as a dash.
std::string escaped(const std::string& text)
{
  std::string result;
  for(char c : text)
    if(c == '\\')
      result += "\\e";
    else if(c == '-')
      result += "\\-";
    else if(result.empty() && (c == '.' || c == '\''))
      result += std::string("\\&") + c;
    else
      result += c;
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }

// The parts of a value that are capital letters stand for something.
std::string value_as_text(const std::string& value)
{
  const bool is_literal =
      std::none_of(value.begin(), value.end(), [](unsigned char c) { return std::isupper(c) != 0; });
  return (is_literal ? "\\fB" : "\\fI") + escaped(value) + "\\fR";
}

void append_option(const Option_help& option, bool is_argument, std::string& out)
{
  out += ".TP\n";
  for(std::size_t i = 0; i < option.names.size(); ++i)
    out += (i == 0 ? "" : ", ") + (is_argument ? "\\fI" + escaped(option.names[i]) + "\\fR" : bold(option.names[i]));
  out += (option.value.empty() ? "" : ' ' + value_as_text(option.value)) + '\n' + escaped(option.text) + '\n';
}

// Of a list the lines that are indented once are terms, the others explain them.
void append_list(std::istringstream& lines, std::string& out)
{
  for(std::string line; std::getline(lines, line);)
  {
    const std::size_t indentation = line.find_first_not_of(' ');
    const std::string text = line.substr(indentation);
    out += indentation == 2 ? ".TP\n" + bold(text) + '\n' : escaped(text) + '\n';
  }
}

// "Examples:" begins a section of this name, and so does "Exit codes: ..." with what follows.
void append_footer_of_program(const std::string& paragraph, std::string& out)
{
  const std::size_t colon = paragraph.find(':');
  std::string title = paragraph.substr(0, colon);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  out += ".SH " + title + '\n';
  std::istringstream rest(paragraph.substr(colon + 1));
  std::string line;
  std::getline(rest, line);
  if(!line.empty())
    out += escaped(line.substr(line.find_first_not_of(' '))) + '\n';
  append_list(rest, out);
}

void append_command(const Command_help& command, std::string& out)
{
  std::string usage = command.name;
  for(const Option_help& argument : command.arguments)
    usage += ' ' + argument.names.front();
  out += ".SS " + escaped(usage) + '\n' + escaped(command.text) + ".\n";
  for(const Option_help& argument : command.arguments)
    append_option(argument, true, out);
  for(const Option_help& option : command.options)
    append_option(option, false, out);
  for(const std::string& paragraph : paragraphs(command.footer))
    out += ".PP\n" + escaped(paragraph) + '\n';
}

} // namespace

std::string man_page(const Command_help& program, const std::string& version)
{
  std::string title = program.name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string out = ".TH " + title + " 1 \"\" \"" + program.name + ' ' + version + "\" \"User Commands\"\n.SH NAME\n" +
                    program.name + " \\- find closed curves of locally minimal length on triangle meshes\n" +
                    ".SH SYNOPSIS\n" + bold(program.name) + " \\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n";
  out += ".SH DESCRIPTION\n";
  for(const std::string& paragraph : paragraphs(program.text))
    out += ".PP\n" + escaped(paragraph) + '\n';
  out += ".SH OPTIONS\n";
  for(const Option_help& option : program.options)
    append_option(option, false, out);
  out += ".SH COMMANDS\n";
  for(const Command_help& command : program.commands)
    append_command(command, out);
  for(const std::string& paragraph : paragraphs(program.footer))
    append_footer_of_program(paragraph, out);
  return out;
}

} // namespace constrictions
