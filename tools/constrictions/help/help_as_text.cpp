// SPDX-License-Identifier: GPL-3.0-or-later
#include "help/command_help.h"

#include <cctype>
#include <cstddef>
#include <sstream>

namespace constrictions {

namespace {

const std::size_t width = 80;

// Appends words, with a line end and an indentation wherever a line would become too long. `column` is where the last
// line ends.
void append_words(const std::string& text, std::size_t indentation, std::size_t column, std::string& out)
{
  std::istringstream words(text);
  bool is_first = true;
  for(std::string word; words >> word; is_first = false)
  {
    if(!is_first && column + 1 + word.size() > width)
    {
      out += '\n' + std::string(indentation, ' ');
      column = indentation;
    }
    else if(!is_first)
    {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
  }
  out += '\n';
}

// The lines of a list keep their indentation.
void append_paragraph(const std::string& paragraph, std::string& out)
{
  std::istringstream lines(paragraph);
  for(std::string line; std::getline(lines, line);)
  {
    const std::size_t indentation = line.find_first_not_of(' ');
    out += std::string(indentation, ' ');
    append_words(line, indentation, indentation, out);
  }
}

// A name, and what it means, in two columns.
void append_entry(const std::string& name, const std::string& text, std::string& out)
{
  const std::size_t margin = 2, second_column = 24;
  out += std::string(margin, ' ') + name;
  const std::size_t end = margin + name.size();
  if(end + 2 > second_column)
    out += '\n' + std::string(second_column, ' ');
  else
    out += std::string(second_column - end, ' ');
  append_words(text, second_column, second_column, out);
}

void append_options(const std::string& title, const std::vector<Option_help>& options, std::string& out)
{
  if(options.empty())
    return;
  out += '\n' + title + ":\n";
  for(const Option_help& option : options)
  {
    std::string name;
    for(const std::string& n : option.names)
      name += (name.empty() ? "" : ", ") + n;
    append_entry(name + (option.value.empty() ? "" : ' ' + option.value), option.text, out);
  }
}

std::string capitalised(std::string text)
{
  if(!text.empty())
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

} // namespace

std::string help_as_text(const Command_help& help, const std::string& called)
{
  std::string out;
  for(const std::string& paragraph : paragraphs(capitalised(help.text)))
    append_paragraph(paragraph, out);
  std::string usage = "Usage: " + called + " [OPTIONS]";
  for(const Option_help& argument : help.arguments)
    usage += ' ' + argument.names.front();
  out += '\n' + usage + (help.commands.empty() ? "" : " COMMAND ...") + '\n';
  append_options("Arguments", help.arguments, out);
  append_options("Options", help.options, out);
  if(!help.commands.empty())
  {
    out += "\nCommands:\n";
    for(const Command_help& command : help.commands)
      append_entry(command.name, command.text, out);
  }
  for(const std::string& paragraph : paragraphs(help.footer))
  {
    out += '\n';
    append_paragraph(paragraph, out);
  }
  return out;
}

} // namespace constrictions
