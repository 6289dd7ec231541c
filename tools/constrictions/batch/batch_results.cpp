// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_results.h"

#include "input/input_file.h"
#include "output/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <regex>
#include <system_error>
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
  : m_folder(folder), m_name((fs::path(folder) / file_name(slice)).string())
{
  if(const int error = m_file.open(m_name))
    throw Output_file_error(m_name, "cannot be opened: " + error_text(error));
  if(const int error = m_file.lock())
    throw Output_file_error(m_name, is_locked_error(error) ? "another process is writing to it"
                                                           : "cannot be locked: " + error_text(error));
}

void Batch_results::for_each_line(const std::function<void(const Batch_line&)>& f) const
{
  for(const std::string& name : files_with_results(m_folder))
  {
    const std::uintmax_t size = read_lines(name, f);
    if(const int error = name == m_name ? m_file.shorten(size) : 0)
      throw Output_file_error(m_name, "cannot be shortened: " + error_text(error));
  }
}

void Batch_results::append(const Batch_line& line) const
{
  if(const int error = m_file.append(as_text(line)))
    throw Output_file_error(m_name, "cannot be written: " + error_text(error));
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
