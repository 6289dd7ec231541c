// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/run_batch.h"

#include "batch/batch_input.h"
#include "batch/batch_line.h"
#include "batch/batch_progress.h"
#include "batch/batch_results.h"
#include "batch/batch_summary.h"
#include "batch/process_pool.h"
#include "input/input_file.h"
#include "output/output_file.h"
#include "system/posix.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <numeric>
#include <optional>
#include <system_error>
#include <unordered_set>
#include <vector>

namespace constrictions {

namespace {

typedef std::function<Report(const std::string& mesh)> Detect;

nlohmann::ordered_json settings(const Options& options)
{
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  const Selection& s = options.selection;
  nlohmann::ordered_json result = {{"format", "constrictions-batch-settings/1"},
                                   {"version", CONSTRICTIONS_VERSION},
                                   {"policy", options.policy == Policy::GARLAND_HECKBERT ? "gh"
                                              : options.policy == Policy::LINDSTROM_TURK ? "lt"
                                                                                         : "length"},
                                   {"seeds", options.search.triangles_only ? "triangles" : "all"},
                                   {"certify", options.search.certifies},
                                   {"strict", options.reading.is_strict},
                                   {"merge", options.reading.merging_distance},
                                   {"all", s.all},
                                   {"rims", s.rims},
                                   {"max", nullptr},
                                   {"min-prominence", or_null(s.minimum_prominence)},
                                   {"min-isolation", or_null(s.minimum_isolation)},
                                   {"max-ratio", or_null(s.maximum_ratio)},
                                   {"min-length", or_null(s.minimum_length)},
                                   {"max-length", or_null(s.maximum_length)}};
  if(s.maximum_number != Selection().maximum_number)
    result["max"] = s.maximum_number;
  return result;
}

// Never throws but for a lack of memory for a line.
std::string detect_as_line(const std::string& mesh, const Detect& detect)
{
  const auto failed = [&](const char* kind, const std::string& error) {
    return failed_batch_line(mesh, kind, error).dump();
  };
  try
  {
    return batch_line(detect(mesh)).dump();
  }
  catch(const Input_file_error& e)
  {
    return failed("input", e.what());
  }
  catch(const CGAL::Surface_mesh_constrictions::Invalid_input& e)
  {
    return failed("input", printable(mesh) + ": " + printable(e.what()));
  }
  catch(const std::bad_alloc&)
  {
    return failed("memory", printable(mesh) + ": not enough memory");
  }
  catch(const std::exception& e)
  {
    return failed("exception", printable(mesh) + ": " + printable(e.what()));
  }
}

// An estimate of the work, never 0: the size of the file, and something for the process.
std::uint64_t weight(const std::string& mesh)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(mesh, error);
  return 10000 + (error ? 0 : size);
}

// Adds up the lines of the meshes that are in the results, and takes these out.
void pass_over_done(const Batch_results& results, std::vector<std::string>& meshes, Batch_summary& summary)
{
  const std::unordered_set<std::string> wanted(meshes.begin(), meshes.end());
  std::unordered_set<std::string> done;
  results.for_each_line([&](const Batch_line& line) {
    const std::string file = file_of(line);
    if(wanted.count(file) != 0 && done.insert(file).second)
      summary.add(line);
  });
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(), [&](const std::string& m) { return done.count(m) != 0; }),
               meshes.end());
}

// Until a signal is caught.
void go_through(const std::vector<std::string>& meshes, const Options& options, const Detect& detect,
                std::optional<Batch_results>& results, Batch_summary& summary)
{
  std::vector<std::uint64_t> weights;
  for(const std::string& mesh : meshes)
    weights.push_back(weight(mesh));
  Batch_progress progress(!options.quiet && is_error_output_terminal(), meshes.size(),
                          std::accumulate(weights.begin(), weights.end(), std::uint64_t(0)));
  Process_pool pool(options.batch.limits);
  std::size_t next = 0;
  while(noted_signal() == 0 && (next < meshes.size() || !pool.is_empty()))
  {
    for(; next < meshes.size() && !pool.is_full(); ++next)
      pool.start(next, [&] {
        results.reset(); // the file must not stay locked by a child that outlives this process for a moment
        return detect_as_line(meshes[next], detect);
      });
    progress.show();
    for(const Task_end& end : pool.wait(std::chrono::milliseconds(500)))
    {
      const Batch_line line = batch_line(meshes[end.task], end, options.batch.limits);
      if(results)
        results->append(line);
      else
        write_to_standard_output(as_text(line));
      summary.add(line);
      progress.add(weights[end.task], line["status"] != "ok");
    }
  }
  progress.show();
}

} // namespace

void run_batch(const Options& options, const Detect& detect)
{
  std::vector<std::string> meshes = batch_meshes(options.batch.inputs, options.batch.slice);
  std::optional<Batch_results> results;
  Batch_summary summary;
  if(!options.folder.empty())
  {
    create_folder(options.folder);
    keep_settings(options.folder, settings(options));
    results.emplace(options.folder, options.batch.slice);
    pass_over_done(*results, meshes, summary);
  }
  note_signals();
  go_through(meshes, options, detect, results, summary);
  if(noted_signal() != 0)
  {
    if(results && !options.quiet)
      std::cerr << "constrictions: batch: interrupted; the same command goes on where this one has ended" << std::endl;
    end_by_noted_signal();
  }
  if(results && !options.quiet)
    write_to_standard_output(summary.as_table());
}

} // namespace constrictions
