// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_input.h"

#include "input/input_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

namespace constrictions {

namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const fs::path& name)
{
  std::string extension = name.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool has_mesh_extension(const fs::path& name)
{
  std::string extension = lower_case_extension(name);
  if(extension == ".gz")
    extension = lower_case_extension(name.stem());
  const std::array<std::string_view, 8> extensions = {".off", ".obj", ".ply", ".stl", ".vtk", ".vtp", ".glb", ".3mf"};
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::vector<std::string> meshes_in_folder(const std::string& folder)
{
  std::vector<std::string> result;
  std::error_code error;
  for(fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if(has_mesh_extension(entry->path()) && !fs::is_directory(fs::status(entry->path(), error)))
      result.push_back(entry->path().string());
  if(error)
    throw Input_file_error(folder, "the folder cannot be read: " + error.message());
  if(result.empty())
    throw Input_file_error(folder, "there is no OFF, OBJ, PLY, STL, VTK, VTP, GLB or 3MF file in the folder");
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> meshes_in_list(const std::string& list)
{
  const std::string content =
      list == "-" ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : read_input_file(list).content;
  const std::string name = list == "-" ? "standard input" : list;
  if(content.find('\0') != std::string::npos)
    throw Input_file_error(name, "is not a list of meshes: it is not text");
  std::vector<std::string> result;
  std::istringstream in(content);
  for(std::string line; std::getline(in, line);)
  {
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    if(!line.empty())
      result.push_back(line);
  }
  if(result.empty())
    throw Input_file_error(name, "the list of meshes is empty");
  return result;
}

std::vector<std::string> meshes(const std::string& input)
{
  std::error_code error;
  if(fs::is_directory(input, error))
    return meshes_in_folder(input);
  if(has_mesh_extension(input))
    return {input};
  return meshes_in_list(input);
}

} // namespace

std::vector<std::string> batch_meshes(const std::vector<std::string>& inputs, const Slice& slice)
{
  std::vector<std::string> result;
  std::unordered_set<std::string> seen;
  for(const std::string& input : inputs)
    for(std::string& mesh : meshes(input))
      if(seen.insert(mesh).second && (seen.size() - 1) % slice.count == slice.index)
        result.push_back(std::move(mesh));
  return result;
}

} // namespace constrictions
