// SPDX-License-Identifier: GPL-3.0-or-later

// Writes what is installed beside the program: its man page and the completions for shells.
//
//   constrictions_documents FOLDER
#include "command_line.h"
#include "help/command_help.h"

#include <fstream>
#include <iostream>
#include <string>
#include <utility>

int main(int argc, char** argv)
{
  using namespace constrictions;

  if(argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FOLDER" << std::endl;
    return 2;
  }
  CLI::App app;
  Options options;
  Words words;
  describe_program(app, options, words);
  const Command_help program = command_help(app);
  for(const auto& [name, text] :
      {std::pair<std::string, std::string>("constrictions.1", man_page(program, CONSTRICTIONS_VERSION)),
       {"constrictions.bash", bash_completion(program)},
       {"_constrictions", zsh_completion(program)}})
  {
    std::ofstream file(argv[1] + ('/' + name));
    file << text;
    file.close();
    if(!file)
    {
      std::cerr << argv[1] << '/' << name << ": cannot be written" << std::endl;
      return 3;
    }
  }
  return 0;
}
