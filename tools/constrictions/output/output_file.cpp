// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/output_file.h"

#include "input/input_file.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <random>
#include <system_error>
#include <utility>

namespace constrictions {

namespace {

namespace fs = std::filesystem;

// A file with a name of its own in the folder of the target, which it becomes when renamed. Removed otherwise.
class Temporary_file
{
public:
  explicit Temporary_file(const std::string& target) : m_target(target), m_place(target)
  {
    std::error_code error;
    if(fs::is_symlink(m_place, error)) // the file that it points to is replaced, not the link
      m_place = fs::weakly_canonical(m_place, error);
    std::random_device random;
    for(int attempt = 0; m_stream == nullptr && attempt < 10; ++attempt)
    {
      m_name = m_place;
      m_name += ".part" + std::to_string(random());
      m_stream = std::fopen(m_name.c_str(), "wbx");
      if(m_stream == nullptr && errno != EEXIST)
        break;
    }
    if(m_stream == nullptr)
      throw Output_file_error(target, "cannot be created: " + error_text(errno));
  }

  Temporary_file(Temporary_file&& other) noexcept
    : m_target(std::move(other.m_target)), m_place(std::move(other.m_place)), m_name(std::move(other.m_name)),
      m_stream(std::exchange(other.m_stream, nullptr))
  {
    other.m_name.clear();
  }

  Temporary_file& operator=(Temporary_file&&) = delete;

  ~Temporary_file()
  {
    if(m_stream != nullptr)
      std::fclose(m_stream);
    if(!m_name.empty())
      std::remove(m_name.c_str());
  }

  void write(const std::string& content)
  {
    const bool written = std::fwrite(content.data(), 1, content.size(), m_stream) == content.size();
    // a full disk may be noticed as late as this
    if(std::fclose(std::exchange(m_stream, nullptr)) != 0 || !written)
      throw Output_file_error(m_target, "cannot be written: " + error_text(errno));
  }

  void rename()
  {
    std::error_code error;
    fs::rename(m_name, m_place, error);
    if(error)
      throw Output_file_error(m_target, "cannot be replaced: " + error.message());
    m_name.clear();
  }

private:
  std::string m_target;
  fs::path m_place, m_name;
  std::FILE* m_stream = nullptr;
};

bool is_pipe_or_device(const std::string& name)
{
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_directly(const Output_file& file)
{
  std::FILE* stream = std::fopen(file.name.c_str(), "wb");
  if(stream == nullptr)
    throw Output_file_error(file.name, "cannot be opened: " + error_text(errno));
  const bool written = std::fwrite(file.content.data(), 1, file.content.size(), stream) == file.content.size();
  if(std::fclose(stream) != 0 || !written)
    throw Output_file_error(file.name, "cannot be written: " + error_text(errno));
}

// If it is there.
void remove_file(const std::string& name)
{
  std::error_code error;
  const fs::file_status status = fs::symlink_status(name, error);
  if(!fs::is_regular_file(status) && !fs::is_symlink(status))
    return;
  if(!fs::remove(name, error) && error)
    throw Output_file_error(name, "is of an earlier run and cannot be removed: " + error.message());
}

} // namespace

Output_file_error::Output_file_error(const std::string& file, const std::string& reason)
  : std::runtime_error(printable(file) + ": " + reason)
{}

void create_folder(const std::string& name)
{
  std::error_code error;
  fs::create_directories(name, error);
  if(error)
    throw Output_file_error(name, "the folder cannot be created: " + error.message());
  if(!fs::is_directory(name, error))
    throw Output_file_error(name, "is not a folder");
}

void check_writable(const std::string& name)
{
  std::error_code error;
  if(fs::is_directory(name, error))
    throw Output_file_error(name, "is a folder, not a file");
  // opening a pipe would wait for its reader
  if(!is_pipe_or_device(name))
    Temporary_file{name};
}

void write_files(const std::vector<Output_file>& files, const std::vector<std::string>& obsolete)
{
  std::vector<Temporary_file> written;
  for(const Output_file& file : files)
    if(is_pipe_or_device(file.name))
      write_directly(file);
    else
    {
      written.emplace_back(file.name);
      written.back().write(file.content);
    }
  for(std::size_t i = 0; i + 1 < written.size(); ++i)
    written[i].rename();
  for(const std::string& name : obsolete)
    remove_file(name);
  if(!written.empty())
    written.back().rename();
}

void write_to_standard_output(const std::string& content)
{
  std::cout << content << std::flush;
  if(!std::cout)
    throw Output_file_error("standard output", "cannot be written");
}

} // namespace constrictions
