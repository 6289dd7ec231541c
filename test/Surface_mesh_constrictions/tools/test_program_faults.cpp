// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever call fails: the program ends with 1 or 3 and one line, and each file is the old one or the new one.
#include "include/program_fixture.h"
#include "include/sanitizers.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace test_program_faults {

using namespace program_fixture;

class Faults : public Program
{
protected:
  void SetUp() override
  {
    if(sanitizers::are_on)
      GTEST_SKIP() << "the sanitizers have an allocator of their own";
  }

  // Runs the program with an environment, after a command of the shell. -1 if it was ended by a signal.
  Result run_in(const std::string& environment, const std::string& arguments, const std::string& before = "true") const
  {
    const std::string command = "cd '" + folder.string() + "' && " + before + " && exec env " + environment +
                                " '" CONSTRICTIONS_PROGRAM "' " + arguments + " > stdout.txt 2> stderr.txt < /dev/null";
    const int status = std::system(("sh -c \"" + command + '"').c_str());
    const Result result{WIFEXITED(status) && WEXITSTATUS(status) < 128 ? WEXITSTATUS(status) : -1,
                        content("stdout.txt"), content("stderr.txt")};
    fs::remove(folder / "stdout.txt");
    fs::remove(folder / "stderr.txt");
    return result;
  }

  Result run_with_fault(const std::string& fault, const std::string& arguments) const
  {
    return run_in("LD_PRELOAD='" CONSTRICTIONS_FAULTS "' FAULT=" + fault, arguments);
  }

  // How many calls of each kind a run makes.
  std::map<std::string, long> calls(const std::string& arguments) const
  {
    const Result r = run_in("LD_PRELOAD='" CONSTRICTIONS_FAULTS "' FAULT_LOG=calls.txt", arguments);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    std::istringstream in(content("calls.txt"));
    std::map<std::string, long> result;
    std::string call;
    for(long n; in >> call >> n;)
      result[call] = n;
    fs::remove(folder / "calls.txt");
    EXPECT_FALSE(result.empty());
    return result;
  }

  std::map<fs::path, std::string> contents() const
  {
    std::map<fs::path, std::string> result;
    for(const fs::path& file : files())
      if(fs::is_regular_file(folder / file))
        result[file] = content(file);
    return result;
  }

  // After a failure each file is as before, or as it should be; and nothing else is there, but for what a killed process
  // could not remove.
  void expect_old_or_new(const std::map<fs::path, std::string>& old_files,
                         const std::map<fs::path, std::string>& new_files, bool may_leave_parts) const
  {
    for(const auto& [file, text] : contents())
    {
      if(may_leave_parts && file.filename().string().find(".part") != std::string::npos)
        continue;
      const auto before = old_files.find(file), after = new_files.find(file);
      EXPECT_TRUE((before != old_files.end() && before->second == text) ||
                  (after != new_files.end() && without_times(after->second) == without_times(text)))
          << file;
    }
  }

  // The JSON files say how long the stages took, and how much memory.
  static std::string without_times(const std::string& text)
  {
    const std::size_t at = text.find("\"seconds\"");
    return at == std::string::npos ? text : text.substr(0, at);
  }

  // Lets the calls fail one after the other, but of very many only some.
  void fail_calls(const std::string& arguments, const std::vector<std::string>& kinds, const std::string& mode)
  {
    const std::map<std::string, long> number = calls(arguments);
    const std::map<fs::path, std::string> new_files = contents();
    const bool tries_all = std::getenv("CONSTRICTIONS_ALL_FAULTS") != nullptr;
    std::size_t survived = 0, tried = 0; // are in the report of the test
    for(const std::string& kind : kinds)
    {
      const long step = tries_all ? 1 : (std::max)(1L, number.at(kind) / 25);
      for(long n = 1; n <= number.at(kind); n += step)
      {
        SCOPED_TRACE(kind + ':' + std::to_string(n) + mode);
        const std::map<fs::path, std::string> before = contents();
        const Result r = run_with_fault(kind + ':' + std::to_string(n) + mode, arguments);
        ++tried;
        expect_old_or_new(before, new_files, mode == ":kill");
        if(mode == ":kill")
        {
          EXPECT_EQ(r.exit_code, -1);
          for(const fs::path& file : files())
            if(fs::is_regular_file(folder / file) && before.count(file) == 0)
              fs::remove(folder / file);
          continue;
        }
        if(r.exit_code == 0)
        {
          // what failed did not matter: closing a file that was read, say
          ++survived;
          for(const auto& [file, text] : contents())
            EXPECT_EQ(without_times(new_files.at(file)), without_times(text)) << file;
          continue;
        }
        EXPECT_TRUE(r.exit_code == 1 || r.exit_code == 3) << r.exit_code << ' ' << r.err;
        EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
        EXPECT_EQ(r.err.rfind("constrictions: ", 0), 0u) << r.err;
      }
    }
    RecordProperty("tried", static_cast<int>(tried));
    RecordProperty("survived", static_cast<int>(survived));
  }
};

const char* const detect = "detect dumbbell.off -o out --csv table.csv --threads 1";
const char* const segment = "segment dumbbell.off -o parts --threads 1";
const std::vector<std::string> calls_of_files = {"fopen", "fwrite", "fclose", "rename"};

TEST_F(Faults, EachAllocationMayFail)
{
  fail_calls(detect, {"new"}, "");
  fail_calls(segment, {"new"}, "");
}

// There are destructors there that allocate.
TEST_F(Faults, MemoryMayBeExhaustedWhereOptionsAreDescribed)
{
  for(long n = 1; n < 4000; n += 13)
  {
    const Result r = run_with_fault("new:" + std::to_string(n) + ":on", detect);
    EXPECT_TRUE(r.exit_code == 1 || r.exit_code == 3) << n << ' ' << r.exit_code << ' ' << r.err;
    EXPECT_EQ(r.err.rfind("constrictions: ", 0), 0u) << n << ' ' << r.err;
  }
}

TEST_F(Faults, MemoryMayBeExhaustedAtAnyPlace)
{
  // without a JSON file: the destructor of nlohmann's values allocates memory, and ends the process where there is none
  fail_calls("detect dumbbell.off --csv table.csv --threads 1", {"new"}, ":on");
}

TEST_F(Faults, EachCallThatWritesMayFail)
{
  fail_calls(detect, calls_of_files, "");
  fail_calls(segment, calls_of_files, "");
}

TEST_F(Faults, AFolderMayNotBeCreated)
{
  const std::set<fs::path> before = files();
  const Result r = run_with_fault("mkdir:1", detect);
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_EQ(r.err.rfind("constrictions: out: ", 0), 0u) << r.err;
  EXPECT_EQ(files(), before);
}

TEST_F(Faults, TheProcessMayBeKilledWhereItWrites)
{
  fail_calls(detect, {"fwrite", "rename"}, ":kill");
  fail_calls(segment, {"fwrite", "rename"}, ":kill");
  EXPECT_EQ(run(segment).exit_code, 0);
}

TEST_F(Faults, AFileThatGrowsBeyondTheLimitIsRemoved)
{
  const std::set<fs::path> before = files();
  const Result r = run_in("", "detect dumbbell.off --json out.json --threads 1", "ulimit -f 1");
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_EQ(r.err.rfind("constrictions: out.json: ", 0), 0u) << r.err;
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  EXPECT_EQ(files(), before);
}

} // namespace test_program_faults
