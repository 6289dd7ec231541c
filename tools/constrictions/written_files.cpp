// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_files.h"

#include "output/handles.h"
#include "output/part_format.h"
#include "output/parts.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace constrictions {

namespace {

namespace fs = std::filesystem;

// Whether a file has a name and a place that segment writes to.
bool is_part_file(const std::string& name, const std::string& folder)
{
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
  const std::string file = place.filename().string();
  return place.parent_path() == fs::weakly_canonical(fs::absolute(folder), error) &&
         (file == "parts.ply" || file == "parts.json" || file == "parts.vtp" || is_part_file_name(file));
}

// The files of one kind that have the curves: the one in the folder, and the one that an option names.
std::vector<std::string> files(const Options& options, const char* name_in_folder, const std::string& file)
{
  std::vector<std::string> result;
  if(!options.folder.empty() && options.command != Command::SEGMENT)
    result.push_back(options.file_in_folder(name_in_folder));
  if(!file.empty() && file != "-")
    result.push_back(file);
  return result;
}

} // namespace

std::string Options::file_in_folder(const std::string& name) const { return (fs::path(folder) / name).string(); }

std::vector<std::string> Options::json_files() const { return files(*this, "constrictions.json", json); }

std::vector<std::string> Options::polylines_files() const
{
  return files(*this, "constrictions.polylines.txt", polylines);
}

std::vector<std::string> Options::ply_files() const { return files(*this, "constrictions.ply", ""); }

std::vector<std::string> Options::vtp_files() const { return files(*this, "constrictions.vtp", ""); }

std::vector<std::string> Options::obj_files() const { return files(*this, "constrictions.obj", ""); }

std::string Options::labels_file() const
{
  return labels.empty() || folder.empty() ? std::string() : file_in_folder("labels.txt");
}

std::vector<std::string> Options::csv_files() const
{
  return csv.empty() || prints_csv() ? std::vector<std::string>() : std::vector<std::string>{csv};
}

void check_files(const Options& options)
{
  std::vector<std::string> names = {options.mesh == "-" ? "/dev/stdin" : options.mesh};
  const bool reads_prepared = options.command != Command::PREPARE;
  for(const std::string& name : {options.loops, options.places, options.labels, options.landmarks, options.curves,
                                 reads_prepared ? options.prepared : std::string()})
    if(!name.empty())
      names.push_back(name);
  const std::size_t inputs = names.size();
  for(const std::vector<std::string>& files : {options.json_files(), options.polylines_files(), options.ply_files(),
                                               options.vtp_files(), options.obj_files(), options.csv_files()})
    names.insert(names.end(), files.begin(), files.end());
  for(const std::string& name :
      {options.page, options.repaired, options.labels_file(), reads_prepared ? std::string() : options.prepared})
    if(!name.empty())
      names.push_back(name);

  if(options.prints_json() && options.prints_csv())
    throw CLI::ValidationError("--csv", "--json writes to the standard output, too");
  if(options.writes_parts())
    for(const std::string& name : {options.mesh, options.labels})
      if(!name.empty() && is_part_file(name, options.folder))
        throw CLI::ValidationError(name, "the output could overwrite the input");

  if(options.removes_handles())
  {
    names.push_back(options.file_in_folder("handles.json"));
    for(const std::string& format : part_format_names())
      names.push_back(options.file_in_folder(without_handles_file_name(*part_format(format))));
  }

  std::vector<fs::path> places;
  for(const std::string& name : names)
  {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
    for(std::size_t i = 0; i < places.size(); ++i)
      if(places.size() >= inputs && places[i] == place && !fs::is_other(place, error))
        throw CLI::ValidationError(name, i < inputs ? "the output would overwrite the input"
                                                    : "two outputs would go to the same file");
    places.push_back(place);
  }
}

} // namespace constrictions
