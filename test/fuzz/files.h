// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_FILES_H
#define FUZZ_FILES_H

// Files of any content are read, or refused with one line.

#include "failure.h"

#include "input/input_file.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace fuzz {

// A file in the folder for temporary files, which is removed at the end.
class Temporary_file
{
public:
  Temporary_file(const std::string& extension, const void* data, std::size_t size)
    : m_name((std::filesystem::temp_directory_path() / ("fuzz" + std::to_string(getpid()) + extension)).string())
  {
    std::FILE* const file = std::fopen(m_name.c_str(), "wb");
    if(file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0)
      throw std::runtime_error("cannot write " + m_name);
  }

  ~Temporary_file() { std::remove(m_name.c_str()); }
  Temporary_file(const Temporary_file&) = delete;

  const std::string& name() const { return m_name; }

private:
  const std::string m_name;
};

// Whether a file was read; it may also be refused, with one line.
template <class Function>
bool is_read(const Function& function)
{
  std::string message;
  try
  {
    function();
    return true;
  }
  catch(const constrictions::Input_file_error& e)
  {
    message = e.what();
  }
  catch(const CGAL::Surface_mesh_constrictions::Invalid_input& e)
  {
    message = e.what();
  }
  if(message.empty() || message.size() > 2000 ||
     std::any_of(message.begin(), message.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    fail("a file is refused with the message: " + message);
  return false;
}

} // namespace fuzz

#endif // FUZZ_FILES_H
