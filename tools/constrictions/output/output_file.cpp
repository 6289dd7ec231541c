// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/output_file.h"

#include "input/input_file.h"
#include "system/posix.h"

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

// Folders that are missing, which are created now, and removed again unless they are kept.
class New_folders
{
public:
  New_folders() = default;
  New_folders(const New_folders&) = delete;
  New_folders& operator=(const New_folders&) = delete;

  ~New_folders()
  {
    std::error_code error;
    for(; !m_created.empty(); m_created.pop_back())
      fs::remove(m_created.back(), error); // only if nothing is in it
  }

  void create(const std::string& name)
  {
    std::error_code error;
    std::vector<fs::path> missing;
    for(fs::path place = fs::absolute(name, error); !fs::exists(place, error) && place != place.parent_path();
        place = place.parent_path())
      missing.push_back(place);
    for(; !missing.empty(); missing.pop_back())
    {
      if(fs::create_directory(missing.back(), error))
        m_created.push_back(missing.back());
      if(error)
        throw Output_file_error(name, "the folder cannot be created: " + error.message());
    }
    if(!fs::is_directory(name, error))
      throw Output_file_error(name, "is not a folder");
  }

  // in which a file is to be
  void create_for(const std::string& file)
  {
    const fs::path folder = fs::path(file).parent_path();
    if(!folder.empty())
      create(folder.string());
  }

  void keep() { m_created.clear(); }

private:
  std::vector<fs::path> m_created;
};

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
  New_folders folders;
  folders.create(name);
  folders.keep();
}

void check_folder(const std::string& name) { New_folders().create(name); }

void check_writable(const std::string& name)
{
  std::error_code error;
  if(fs::is_directory(name, error))
    throw Output_file_error(name, "is a folder, not a file");
  // opening a pipe would wait for its reader
  if(is_pipe_or_device(name))
    return;
  New_folders folders;
  folders.create_for(name);
  Temporary_file{name};
}

void write_files(const std::vector<Output_file>& files, const std::vector<std::string>& obsolete)
{
  const Held_signals held;
  New_folders folders;
  std::vector<Temporary_file> written;
  for(const Output_file& file : files)
    if(is_pipe_or_device(file.name))
      write_directly(file);
    else
    {
      folders.create_for(file.name);
      written.emplace_back(file.name);
      written.back().write(file.content);
    }
  for(std::size_t i = 0; i + 1 < written.size(); ++i)
    written[i].rename();
  for(const std::string& name : obsolete)
    remove_file(name);
  if(!written.empty())
    written.back().rename();
  folders.keep();
}

void write_to_standard_output(const std::string& content)
{
  std::cout << content << std::flush;
  if(!std::cout)
    throw Output_file_error("standard output", "cannot be written");
}

} // namespace constrictions
