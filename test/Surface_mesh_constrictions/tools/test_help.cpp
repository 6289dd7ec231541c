// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// The help, and what is made of it: the man page and the completions for shells.
namespace test_help {

using program_fixture::Program;

typedef std::set<std::string> Names;

const std::vector<std::string> commands = {"detect",  "girth", "prepare", "tighten", "certify",
                                           "segment", "batch", "view",    "check"};

std::string document(const std::string& name)
{
  std::ostringstream result;
  result << std::ifstream(CONSTRICTIONS_DOCUMENT_DIR "/" + name).rdbuf();
  return result.str();
}

class Help : public Program
{
protected:
  // The names of options that stand at the beginning of a line.
  static Names options(const std::string& help)
  {
    Names result;
    const std::regex entry("  (--?[a-z-]+)(, (--?[a-z-]+))?( .*)?");
    std::istringstream lines(help);
    for(std::string line; std::getline(lines, line);)
    {
      std::smatch match;
      if(!std::regex_match(line, match, entry))
        continue;
      result.insert(match[1]);
      if(match[3].matched)
        result.insert(match[3]);
    }
    return result;
  }

  std::string help(const std::string& command) const { return run(command + " --help").out; }

  // What bash offers for the last one of these words.
  std::string completed(const std::string& words) const
  {
    write("complete.sh", "source '" CONSTRICTIONS_DOCUMENT_DIR "/constrictions.bash'\ncompopt() { :; }\n"
                         "COMP_WORDS=(" +
                             words +
                             ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_constrictions\necho ${COMPREPLY[*]} > "
                             "replies.txt\n");
    EXPECT_EQ(std::system(("cd '" + folder.string() + "' && bash complete.sh").c_str()), 0);
    std::string result = content("replies.txt");
    result.pop_back();
    return result;
  }
};

TEST_F(Help, lines_have_80_characters_at_most)
{
  std::vector<std::string> all = commands;
  all.push_back("");
  for(const std::string& command : all)
  {
    std::istringstream lines(help(command));
    std::string line;
    EXPECT_TRUE(std::getline(lines, line)) << command;
    for(; std::getline(lines, line);)
    {
      EXPECT_LE(line.size(), 80u) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
  }
}

TEST_F(Help, of_check_as_it_is)
{
  EXPECT_EQ(help("check"), "Say everything that is wrong with a mesh\n"
                           "\n"
                           "Usage: constrictions check [OPTIONS] MESH\n"
                           "\n"
                           "Arguments:\n"
                           "  MESH FILE|-           mesh (OFF, OBJ, PLY, STL, VTK, VTP, GLB or 3MF, also\n"
                           "                        gzipped); - is the standard input\n"
                           "\n"
                           "Options:\n"
                           "  -h, --help            Print this help message and exit\n"
                           "  --strict              refuse a mesh with polygons, duplicate or degenerate\n"
                           "                        faces, or edges or vertices that are not manifold,\n"
                           "                        instead of repairing it\n"
                           "  --merge EPS           merge vertices that are nearer to each other than this;\n"
                           "                        each is merged into the first vertex near it\n"
                           "  -o FILE               write the repaired mesh as OFF, OBJ or PLY, by the\n"
                           "                        extension\n"
                           "  --json FILE|-         write the report as JSON; - prints it, instead of the\n"
                           "                        lines\n"
                           "\n"
                           "The exit code is 0 if constrictions of the mesh can be computed, as it is or as\n"
                           "repaired, else 1.\n");
}

TEST_F(Help, man_page_and_completions_name_each_option)
{
  const std::string man = document("constrictions.1"), bash = document("constrictions.bash"),
                    zsh = document("_constrictions");
  std::size_t number = 0;
  for(const std::string& command : commands)
  {
    const Names names = options(help(command));
    number += names.size();
    EXPECT_TRUE(names.count("--help") == 1 && names.size() >= 5) << command;
    // each in the section of its command
    const std::size_t in_man = man.find("\n.SS " + command), in_bash = bash.find("\n    " + command + ")\n"),
                      in_zsh = zsh.find("\n    " + command + ")\n");
    ASSERT_TRUE(in_man != std::string::npos && in_bash != std::string::npos && in_zsh != std::string::npos) << command;
    const std::string of_man = man.substr(in_man, man.find("\n.S", in_man + 1) - in_man),
                      of_bash = bash.substr(in_bash, bash.find("\n      ;;", in_bash) - in_bash),
                      of_zsh = zsh.substr(in_zsh, zsh.find("\n      ;;", in_zsh) - in_zsh);
    for(const std::string& name : names)
    {
      const std::string in_roff = std::regex_replace(name, std::regex("-"), "\\-");
      EXPECT_NE(of_man.find("\\fB" + in_roff + "\\fR"), std::string::npos) << command << ' ' << name;
      EXPECT_TRUE(std::regex_search(of_bash, std::regex("options=\".*" + name + "[ \"]"))) << command << ' ' << name;
      EXPECT_TRUE(std::regex_search(of_zsh, std::regex("[ ,{]" + name + "[',}\\[ ]"))) << command << ' ' << name;
    }
  }
  EXPECT_GT(number, 80u);
  for(const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS", "EXAMPLES", "EXIT CODES"})
    EXPECT_NE(man.find(std::string("\n.SH ") + section + '\n'), std::string::npos) << section;
}

TEST_F(Help, bash_completes)
{
  EXPECT_EQ(completed("constrictions seg"), "segment");
  EXPECT_EQ(completed("constrictions --v"), "--version");
  EXPECT_EQ(completed("constrictions detect --min-i"), "--min-isolation");
  EXPECT_EQ(completed("constrictions segment --format ''"), "ply stl obj glb 3mf");
  EXPECT_EQ(completed("constrictions segment --format g"), "glb");
  EXPECT_EQ(completed("constrictions detect --policy l"), "lt length");
  EXPECT_EQ(completed("constrictions check --policy l"), ""); // it has none
}

} // namespace test_help
