// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_results.h"

#include "input/input_file.h"
#include "output/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace constrictions {

namespace {

namespace fs = std::filesystem;

std::string file_name(const Slice& slice)
{
  if(slice.count == 1)
    return "results.jsonl";
  return "results." + std::to_string(slice.index + 1) + "-of-" + std::to_string(slice.count) + ".jsonl";
}

std::vector<std::string> files_with_results(const std::string& folder)
{
  const std::regex pattern("results(\\.[0-9]+-of-[0-9]+)?\\.jsonl");
  std::vector<std::string> result;
  std::error_code error;
  for(fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if(std::regex_match(entry->path().filename().string(), pattern))
      result.push_back(entry->path().string());
  if(error)
    throw Input_file_error(folder, "the folder cannot be read: " + error.message());
  std::sort(result.begin(), result.end());
  return result;
}

// Returns the error, or 0. A process that was just killed may take a moment to end.
int lock(int file)
{
  for(int attempt = 0; flock(file, LOCK_EX | LOCK_NB) != 0; ++attempt)
  {
    if(errno != EWOULDBLOCK || attempt == 10)
      return errno;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return 0;
}

// Returns the number of bytes in lines that have an end.
std::uintmax_t read_lines(const std::string& name, const std::function<void(const Batch_line&)>& f)
{
  std::ifstream in(name, std::ios::binary);
  if(!in)
    throw Input_file_error(name, "cannot be opened: " + error_text(errno));
  std::uintmax_t size = 0;
  std::size_t number = 1;
  for(std::string line; std::getline(in, line) && !in.eof(); ++number)
  {
    try
    {
      f(parse_batch_line(line));
    }
    catch(const std::exception& e)
    {
      throw Input_file_error(name, "line " + std::to_string(number) + " " + e.what());
    }
    size += line.size() + 1;
  }
  return size;
}

} // namespace

Batch_results::Batch_results(const std::string& folder, const Slice& slice)
  : m_folder(folder), m_name((fs::path(folder) / file_name(slice)).string()),
    m_file(open(m_name.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666))
{
  if(m_file == -1)
    throw Output_file_error(m_name, "cannot be opened: " + error_text(errno));
  if(const int error = lock(m_file))
  {
    close(m_file);
    throw Output_file_error(m_name, error == EWOULDBLOCK ? "another process is writing to it"
                                                         : "cannot be locked: " + error_text(error));
  }
}

Batch_results::~Batch_results() { close(m_file); }

void Batch_results::for_each_line(const std::function<void(const Batch_line&)>& f) const
{
  for(const std::string& name : files_with_results(m_folder))
  {
    const std::uintmax_t size = read_lines(name, f);
    if(name == m_name && ftruncate(m_file, static_cast<off_t>(size)) != 0)
      throw Output_file_error(m_name, "cannot be shortened: " + error_text(errno));
  }
}

void Batch_results::append(const Batch_line& line) const
{
  const std::string text = as_text(line);
  for(std::string_view rest = text; !rest.empty();)
  {
    const ssize_t n = write(m_file, rest.data(), rest.size());
    if(n < 0 && errno != EINTR)
      throw Output_file_error(m_name, "cannot be written: " + error_text(errno));
    rest.remove_prefix(n < 0 ? 0 : static_cast<std::size_t>(n));
  }
}

void keep_settings(const std::string& folder, const nlohmann::ordered_json& settings)
{
  const std::string name = (fs::path(folder) / "settings.json").string();
  std::error_code error;
  if(!fs::exists(name, error))
  {
    write_files({{name, settings.dump(2) + '\n'}});
    return;
  }
  const auto old = nlohmann::ordered_json::parse(read_input_file(name).content, nullptr, false);
  if(!old.is_object())
    throw Input_file_error(name, "is not a JSON object");
  for(const auto& [member, value] : settings.items())
  {
    const nlohmann::ordered_json old_value = old.contains(member) ? old[member] : nlohmann::ordered_json();
    if(old_value != value)
      throw Input_file_error(name, "the results in this folder were made with other settings: " + member + " was " +
                                       old_value.dump() + ", not " + value.dump());
  }
}

} // namespace constrictions
