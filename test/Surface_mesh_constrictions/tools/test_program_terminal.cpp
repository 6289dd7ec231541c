// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/progress_line.h"

#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_program_terminal {

using program_fixture::Cubes;
using program_fixture::dumbbell;
using program_fixture::Grid_point;
using program_fixture::Program;
using program_fixture::Result;

class Terminal : public Program
{
protected:
  // What is shown after the bars of progress.
  static void expect_at_the_end(const Result& r, const std::string& text)
  {
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_TRUE(r.err.size() >= text.size() && r.err.compare(r.err.size() - text.size(), text.size(), text) == 0)
        << r.err << "does not end with\n"
        << text;
  }
};

TEST_F(Terminal, a_mistake_is_told_in_one_line_with_a_guess)
{
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"", "a command is missing; see constrictions --help"},
      {"detekt dumbbell.off", "there is no command \"detekt\"; did you mean detect? See constrictions --help"},
      {"refine dumbbell.off", "there is no command \"refine\"; see constrictions --help"},
      {"dumbbell.off", "there is no command \"dumbbell.off\"; see constrictions --help"},
      {"--jsn", "constrictions has no option \"--jsn\"; see constrictions --help"},
      {"detect", "MESH is required; see constrictions detect --help"},
      {"detect dumbbell.off tetrahedron.off",
       "\"tetrahedron.off\" is one argument too many for detect; see constrictions detect --help"},
      {"detect dumbbell.off --jsn a.json",
       "detect has no option \"--jsn\"; did you mean --json? See constrictions detect --help"},
      {"detect dumbbell.off --polcy=lt",
       "detect has no option \"--polcy\"; did you mean --policy? See constrictions detect --help"},
      {"detect --min-lenght 3 dumbbell.off",
       "detect has no option \"--min-lenght\"; did you mean --min-length? See constrictions detect --help"},
      {"detect dumbbell.off --loops l.txt",
       "detect has no option \"--loops\"; it is one of tighten; see constrictions detect --help"},
      {"certify dumbbell.off --curves c.json --near 1,2,3",
       "certify has no option \"--near\"; it is one of detect; see constrictions certify --help"},
      {"check dumbbell.off --threads 2", "check has no option \"--threads\"; it is one of detect, prepare, segment and "
                                         "view; see constrictions check --help"},
      {"detect dumbbell.off --threads 0", "--threads: give a whole number from 1 on; see constrictions detect --help"},
      {"detect dumbbell.off --threads two",
       "--threads: give a whole number from 1 on; see constrictions detect --help"},
      {"detect dumbbell.off --max -1", "--max: give a whole number; see constrictions detect --help"},
      {"detect dumbbell.off --max 1.5", "--max: give a whole number; see constrictions detect --help"},
      {"detect dumbbell.off --max-ratio nan",
       "--max-ratio: give a number that is not negative; see constrictions detect --help"},
      {"segment dumbbell.off -o parts --parts 0",
       "--parts: give a whole number from 1 on; see constrictions segment --help"},
      {"batch dumbbell.off -j 501", "-j: give a whole number from 1 to 500; see constrictions batch --help"},
      {"detect dumbbell.off --near 1,2",
       "--near: give three numbers separated by commas, as in 0.5,-1,2e3; see constrictions detect --help"},
      {"detect dumbbell.off --csv - --json -",
       "--csv: --json writes to the standard output, too; see constrictions detect --help"},
      {"detect dumbbell.off --json dumbbell.off",
       "dumbbell.off: the output would overwrite the input; see constrictions detect --help"},
      {"detect dumbbell.off --json a --csv a",
       "a: two outputs would go to the same file; see constrictions detect --help"},
      {"detect dumbbell.off --min-length 3 --max-length 2",
       "--min-length: is greater than --max-length: no curve can be as long as that; see constrictions detect --help"},
      {"detect dumbbell.off --polylines -", "--polylines: give the name of a file; see constrictions detect --help"},
      {"check dumbbell.off -o a.stl",
       "-o: give a file name that ends in .off, .obj or .ply; see constrictions check --help"},
      {"check dumbbell.off --merge 0", "--merge: give a number that is greater than 0; see constrictions check --help"},
      {"tighten dumbbell.off", "--loops, --through or --labels is required; see constrictions tighten --help"},
      {"batch dumbbell.off --slice 3/2",
       "--slice: give the number of a slice and the number of slices, as in 2/10; see constrictions batch --help"},
      {"segment dumbbell.off", "-o is required; see constrictions segment --help"}};
  EXPECT_GE(mistakes.size(), 30u);
  for(const auto& [arguments, message] : mistakes)
  {
    expect_wrong_usage(arguments);
    EXPECT_EQ(run(arguments).err, "constrictions: " + message + '\n');
  }
  expect_wrong_usage("$'detect\n'"); // still one line
}

TEST_F(Terminal, what_was_written_and_found_is_told)
{
  expect_at_the_end(run_in_terminal("detect dumbbell.off -o results --csv a.csv"),
                    "written: results/constrictions.json\n"
                    "         results/constrictions.polylines.txt\n"
                    "         results/constrictions.ply\n"
                    "         results/constrictions.vtp\n"
                    "         results/constrictions.obj\n"
                    "         a.csv\n"
                    "1 constriction, 4 long, around 3 1.5 1.5\n");
  EXPECT_EQ(run_in_terminal("detect dumbbell.off -o results --quiet").err, "");
  EXPECT_EQ(run("detect dumbbell.off -o results").err, "");
  expect_at_the_end(run_in_terminal("segment dumbbell.off -o parts"), "written: parts/parts.ply\n"
                                                                      "         parts/parts.vtp\n"
                                                                      "         parts/parts.json\n"
                                                                      "         parts/part_0.ply\n"
                                                                      "         parts/part_1.ply\n");
  const Result cactus = run_in_terminal("segment '" CONSTRICTIONS_MESH_DIR "/cactus.off' --format obj -o parts");
  expect_at_the_end(cactus, "         parts/parts.json\n         parts/part_0.obj to parts/part_3.obj\n");
  const Result table = run_in_terminal("detect dumbbell.off"); // says it itself
  EXPECT_EQ(table.err.find("written"), std::string::npos);
  EXPECT_NE(table.out, "");
  const Result several = run_in_terminal("detect '" CONSTRICTIONS_MESH_DIR "/cactus.off' --json a.json");
  EXPECT_NE(several.err.find("written: a.json\n3 constrictions; the narrowest, number 1, is 0.283957 long, around "),
            std::string::npos)
      << several.err;
  expect_at_the_end(run_in_terminal("check dumbbell.off -o checked.ply"), "written: checked.ply\n");
  expect_at_the_end(run_in_terminal("certify dumbbell.off --curves results/constrictions.json --json c.json"),
                    "written: c.json\n");
  EXPECT_EQ(run_in_terminal("check dumbbell.off").err, "");
  if(!CONSTRICTIONS_HAS_VIEWER)
    return;
  expect_at_the_end(run_in_terminal("view dumbbell.off -o dumbbell.html"),
                    "written: dumbbell.html\n1 constriction, 4 long, around 3 1.5 1.5\n");
  expect_at_the_end(
      run_in_terminal("view dumbbell.off -o dumbbell.html --min-prominence 100"),
      "1 constriction, 4 long, around 3 1.5 1.5\n1 of a smaller prominence than 100 is not shown at first\n");
}

// What is typed, and what is shown, in a terminal of 80 columns.
TEST_F(Terminal, a_session)
{
  EXPECT_EQ(run("check dumbbell.off").out, "dumbbell.off\n"
                                           "vertices      116\n"
                                           "faces         228\n"
                                           "triangles     228\n"
                                           "components    1\n"
                                           "genus         0\n"
                                           "holes         0\n"
                                           "border_edges  0\n"
                                           "area          114.0\n"
                                           "usable\n");
  const std::string table = run("detect dumbbell.off").out, end = " seed curves\n";
  const std::string expected = " id      length  diameter prominence roundness separating certificate       side\n"
                               "  0           4     1.273      2.308     0.785        yes  not strict     object\n"
                               "1 constriction from ";
  EXPECT_EQ(table.substr(0, expected.size()), expected);
  EXPECT_EQ(table.substr(table.size() - end.size()), end);
  const Result parts = run_in_terminal("segment dumbbell.off -o parts");
  EXPECT_EQ(parts.out, " part          area        volume   genus  boundaries\n"
                       "    0            53            27       0           1\n"
                       "    1            61            29       0           1\n"
                       "2 parts, cut along 1 of 1 constriction\n");
  EXPECT_EQ(parts.err.substr(parts.err.rfind('\x1b') == std::string::npos ? 0 : parts.err.rfind('\x1b') + 3),
            "written: parts/parts.ply\n"
            "         parts/parts.vtp\n"
            "         parts/parts.json\n"
            "         parts/part_0.ply\n"
            "         parts/part_1.ply\n");
  for(const std::string& text : {expected, parts.out, run("detect '" CONSTRICTIONS_MESH_DIR "/cactus.off' --all").out})
  {
    std::istringstream lines(text);
    for(std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80u) << line;
  }
}

TEST(Progress, is_a_line_for_the_whole_with_the_time_left)
{
  using CGAL::Surface_mesh_constrictions::Detection_stage;
  using constrictions::progress_line;
  const constrictions::Stages all = {Detection_stage::SIMPLIFICATION, Detection_stage::SELECTION};
  EXPECT_EQ(progress_line(all, Detection_stage::SIMPLIFICATION, 0, 1), "Simplification, 0%, 0:00:01");
  EXPECT_EQ(progress_line(all, Detection_stage::SIMPLIFICATION, 0.8, 2),
            "Simplification, 10%, 0:00:02, about 0:00:17 left");
  EXPECT_EQ(progress_line(all, Detection_stage::SELECTION, 1, 3700), "Selection, 100%, 1:01:40, about 0:00:00 left");
  EXPECT_EQ(progress_line({Detection_stage::CERTIFICATION, Detection_stage::CERTIFICATION},
                          Detection_stage::CERTIFICATION, 0.5, 30),
            "Certification, 50%, 0:00:30, about 0:00:30 left");
  // it never goes back
  double last = -1;
  for(int stage = 0; stage < 6; ++stage)
    for(double part : {0., 0.5, 1.})
    {
      const std::string line = progress_line(all, static_cast<Detection_stage>(stage), part, 10);
      const double now = std::stod(line.substr(line.find(", ") + 2));
      EXPECT_GE(now, last) << line;
      EXPECT_LT(line.size(), 80u) << line;
      last = now;
    }
}

TEST_F(Terminal, loops_that_are_no_constrictions_are_told)
{
  Cubes cubes = dumbbell();
  write("dumbbell.off", cubes.off());
  std::ostringstream loop;
  for(const Grid_point& p : {Grid_point{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}})
    loop << cubes.vertex(p) << ' ';
  write("loops.txt", loop.str());
  expect_at_the_end(run_in_terminal("tighten dumbbell.off --loops loops.txt --json a.json"),
                    "written: a.json\nloop on line 1: degenerate, it shortens to a point\n0 constrictions\n");
}

TEST_F(Terminal, nothing_found_points_to_all)
{
  const std::string hint = "Closed geodesics were found but are not selected; --all shows them";
  EXPECT_NE(run("detect dumbbell.off --min-prominence 100").out.find("seed curves\n" + hint + ".\n"),
            std::string::npos);
  EXPECT_NE(run("detect dumbbell.off --min-prominence 100 --min-length 1").out.find(hint + ", within the bounds"),
            std::string::npos);
  EXPECT_NE(run("segment dumbbell.off --min-prominence 100 -o parts").out.find(hint), std::string::npos);
  expect_at_the_end(run_in_terminal("detect dumbbell.off --min-prominence 100 --json a.json"),
                    "0 constrictions\n" + hint + ".\n");
  EXPECT_NE(run("detect dumbbell.off --min-prominence 100 --all").out.find("3 constrictions from"), std::string::npos);
  // where there is nothing it points to nothing
  for(const char* arguments : {"detect tetrahedron.off", "detect tetrahedron.off --all", "detect dumbbell.off --max 0",
                               "detect dumbbell.off --all --min-length 1000"})
    EXPECT_EQ(run(arguments).out.find("--all"), std::string::npos) << arguments;
}

} // namespace test_program_terminal
