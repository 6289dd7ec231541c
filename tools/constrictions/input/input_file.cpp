// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/input_file.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace constrictions {

Input_file_error::Input_file_error(const std::string& file, const std::string& reason)
  : std::runtime_error(printable(file) + ": " + printable(reason))
{}

namespace {

void read_to_end(std::FILE& in, std::size_t announced_size, Input_file& file)
{
  std::size_t filled = 0, got = 0;
  do
  {
    // one byte more than the announced size, so that the end of the file is seen by the first read
    file.content.resize(filled == 0 ? announced_size + 1 : filled + (std::size_t(1) << 20));
    got = std::fread(file.content.data() + filled, 1, file.content.size() - filled, &in);
    filled += got;
  } while(filled == file.content.size());
  if(std::ferror(&in))
    file.fail("cannot be read: " + error_text(errno));
  file.content.resize(filled);
}

} // namespace

Input_file read_input_file(const std::string& name)
{
  Input_file file{name, std::string()};
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(name, error);
  if(status.type() == std::filesystem::file_type::not_found)
    file.fail("no such file");
  if(is_directory(status))
    file.fail("is a folder, not a file");
  // a device may never end
  if(is_character_file(status) || is_block_file(status) || is_socket(status))
    file.fail("is a device, not a file");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(name.c_str(), "rb"), &std::fclose);
  if(in == nullptr)
    file.fail("cannot be opened: " + error_text(errno));

  const std::uintmax_t size = is_regular_file(status) ? std::filesystem::file_size(name, error) : 0;
  read_to_end(*in, error ? 0 : static_cast<std::size_t>(size), file);
  return file;
}

Input_file read_standard_input()
{
  Input_file file{"-", std::string()};
  read_to_end(*stdin, 0, file);
  return file;
}

std::string error_text(int error) { return std::generic_category().message(error); }

std::string printable(std::string_view text)
{
  std::string result(text);
  for(char& c : result)
    if(static_cast<unsigned char>(c) < 32 || c == 127)
      c = '?';
  return result;
}

std::string quoted(std::string_view text)
{
  const std::size_t longest = 40;
  return '"' + printable(text.substr(0, longest)) + (text.size() > longest ? "...\"" : "\"");
}

} // namespace constrictions
