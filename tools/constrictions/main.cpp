// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/run_batch.h"
#include "compute/computations.h"
#include "compute/thread_limit.h"
#include "input/curves_file.h"
#include "input/input_file.h"
#include "input/labels_file.h"
#include "input/landmarks_file.h"
#include "options.h"
#include "output/certificates.h"
#include "output/check_report.h"
#include "output/closing_words.h"
#include "output/handles.h"
#include "output/mesh_as_text.h"
#include "output/mesh_json.h"
#include "output/output_file.h"
#include "output/parts.h"
#include "system/posix.h"
#include "view/view_page.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

using CGAL::Surface_mesh_constrictions::Detection_stage;
using CGAL::Surface_mesh_constrictions::Input_defect;
using CGAL::Surface_mesh_constrictions::Invalid_input;

double seconds_since(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Whether somebody is there who reads what was written, and found.
bool tells_results(const Options& options) { return !options.quiet && is_error_output_terminal(); }

// Before the long computation.
void check_outputs(const Options& options)
{
  if(!options.folder.empty())
    check_folder(options.folder);
  if(options.writes_parts())
    for(const char* name : {"parts.json", "parts.ply", "parts.vtp"})
      check_writable(options.file_in_folder(name));
  if(options.removes_handles())
    for(const std::string& name : {std::string("handles.json"), without_handles_file_name(options.segmentation.format)})
      check_writable(options.file_in_folder(name));
  if(options.command == Command::VIEW)
    check_writable(options.page);
  if(!options.repaired.empty())
    check_writable(options.repaired);
  if(options.command == Command::PREPARE)
    check_writable(options.prepared);
  if(!options.labels_file().empty())
    check_writable(options.labels_file());
  for(const std::vector<std::string>& files : {options.json_files(), options.polylines_files(), options.ply_files(),
                                               options.vtp_files(), options.obj_files(), options.csv_files()})
    for(const std::string& file : files)
      check_writable(file);
}

void detect_by_policy(const Options& options, const Selection& selection, Stage_monitor& monitor, Report& report,
                      Levels* levels)
{
  if(!options.prepared.empty())
  {
    detect_prepared(options.prepared, selection, options.search, monitor, report);
    return;
  }
  switch(options.policy)
  {
  case Policy::GARLAND_HECKBERT:
    report.constrictions = detect_with_garland_heckbert(report.mesh, selection, options.search, monitor, levels);
    break;
  case Policy::LINDSTROM_TURK:
    report.constrictions = detect_with_lindstrom_turk(report.mesh, selection, options.search, monitor, levels);
    break;
  case Policy::EDGE_LENGTH:
    report.constrictions = detect_with_edge_length(report.mesh, selection, options.search, monitor, levels);
    break;
  }
  report.statistics = monitor.statistics;
}

void detect(const Options& options, const Selection& selection, Stage_monitor& monitor, Report& report, Levels* levels)
{
  try
  {
    detect_by_policy(options, selection, monitor, report, levels);
  }
  catch(const Invalid_input& e)
  {
    throw with_hint(e, report.file);
  }
}

void tighten(const Options& options, const Loops& loops, Stage_monitor& monitor, Report& report)
{
  try
  {
    tighten_loops(loops, options.search.certifies, monitor, report);
  }
  catch(const Invalid_input& e)
  {
    if(e.defect() != Input_defect::INVALID_LOOP)
      throw with_hint(e, report.file);
    throw Input_file_error(options.loops, "line " + std::to_string(loops.lines.at(e.element())) + ": " + e.what());
  }
}

void tighten_borders(const Options& options, const std::vector<Label>& labels, Stage_monitor& monitor, Report& report)
{
  try
  {
    tighten_labels(labels, options.search.certifies, monitor, report);
  }
  catch(const Invalid_input& e)
  {
    throw with_hint(e, report.file);
  }
}

void girth(const Options& options, Stage_monitor& monitor, Report& report)
{
  try
  {
    find_girth(options.prepared, options.girth, options.search.certifies, monitor, report);
  }
  catch(const Invalid_input& e)
  {
    throw with_hint(e, report.file);
  }
}

void ask_at_landmarks(const Options& options, const std::vector<Landmark>& landmarks, Stage_monitor& monitor,
                      Report& report)
{
  try
  {
    if(options.command == Command::GIRTH)
      find_girths(options.prepared, landmarks, options.girth, options.search.certifies, monitor, report);
    else
      detect_near_landmarks(options.prepared, landmarks, options.selection, options.search.certifies, monitor, report);
  }
  catch(const Invalid_input& e)
  {
    throw with_hint(e, report.file);
  }
}

void tighten_through(const Options& options, const Place_loops& loops, Stage_monitor& monitor, Report& report)
{
  try
  {
    tighten_through_places(options.places, loops, options.search.certifies, monitor, report);
  }
  catch(const Invalid_input& e)
  {
    throw with_hint(e, report.file);
  }
}

// The files of parts, and those of an earlier run that are to be removed.
struct Part_files
{
  std::vector<Output_file> files;
  std::vector<std::string> obsolete;
};

Part_files files_of_parts(const Options& options, const Report& report, const Parts& parts)
{
  // parts.json is the last, as it says which files of parts there are
  std::vector<Output_file> files = {{options.file_in_folder("parts.ply"), mesh_as_ply(parts.mesh, parts.part_of_face)},
                                    {options.file_in_folder("parts.vtp"), mesh_as_vtp(parts.mesh, parts.part_of_face)}};
  std::vector<std::string> names;
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
  {
    names.push_back(part_file_name(p, parts.format));
    if(p > 0 && names[p] == names[p - 1]) // one file has all
      continue;
    try
    {
      files.push_back({options.file_in_folder(names.back()), part_as_file(parts, p)});
    }
    catch(const std::runtime_error& e)
    {
      throw Output_file_error(options.file_in_folder(names.back()), e.what());
    }
  }
  files.push_back({options.file_in_folder("parts.json"), parts_as_json(report, parts)});
  std::vector<std::string> obsolete;
  for(const std::string& name : part_files_of_earlier_run(options.folder))
    if(std::find(names.begin(), names.end(), name) == names.end())
      obsolete.push_back(options.file_in_folder(name));
  return {files, obsolete};
}

void write_parts(const Options& options, const Report& report, const Parts& parts)
{
  const Part_files written = files_of_parts(options, report, parts);
  write_files(written.files, written.obsolete);
  if(tells_results(options))
    std::cerr << written_files_as_text(written.files) << std::flush;
  if(!options.quiet)
    write_to_standard_output(parts_as_table(parts) + (report.hint.empty() ? "" : report.hint + '\n'));
}

// Removes handles in rounds, as `remove_handles()` of the library does.
Handle_removal remove_handles(const Options& options, Stage_monitor& monitor, const Report& report)
{
  Handle_removal result;
  result.mesh = report.mesh;
  result.old_genus = mesh_as_json(report.mesh_file, report.mesh, report.file).at("genus").get<std::size_t>();
  const std::size_t number = options.segmentation.genus.value_or(options.segmentation.handles.value_or(0));
  if(number > result.old_genus)
    throw Input_file_error(options.mesh,
                           "its genus is " + std::to_string(result.old_genus) + ", less than the " +
                               (options.segmentation.genus ? "one asked for, " : "number of handles to remove, ") +
                               std::to_string(number));
  result.target_genus = options.segmentation.genus ? number : result.old_genus - number;
  for(std::size_t round = 0; result.genus() > result.target_genus; ++round)
  {
    Report found;
    found.mesh = result.mesh;
    if(round == 0)
      found.file = report.file;
    detect(options, options.selection, monitor, found, nullptr);
    const auto detected = std::chrono::steady_clock::now();
    const bool has_cut =
        cut_along_handles(found.constrictions, options.segmentation, options.selection.maximum_length, round, result);
    result.seconds += seconds_since(detected);
    if(!has_cut)
      break;
  }
  return result;
}

// Returns the exit code.
int write_handles(const Options& options, const Report& report, const Handle_removal& removal)
{
  const Part_format format = options.segmentation.format;
  const std::string name = options.file_in_folder(without_handles_file_name(format));
  std::vector<Output_file> files;
  try
  {
    files.push_back({name, without_handles_as_file(removal, format, report.file.unit)});
  }
  catch(const std::range_error& e)
  {
    throw Output_file_error(name, e.what());
  }
  files.push_back({options.file_in_folder("handles.json"), handles_as_json(report, removal, format)});
  write_files(files);
  if(tells_results(options))
    std::cerr << written_files_as_text(files) << std::flush;
  if(!options.quiet)
    write_to_standard_output(handles_as_table(removal));
  if(removal.genus() == removal.target_genus)
    return 0;
  std::cerr << "constrictions: " << printable(options.mesh) << ": the genus is " << removal.genus() << ", not "
            << removal.target_genus << ": no other curve fits" << std::endl;
  return 1;
}

void write_outputs(const Options& options, const Report& report)
{
  std::vector<Output_file> files;
  const bool wants_json = options.prints_json() || !options.json_files().empty();
  const std::string json = wants_json ? report_as_json(report) : std::string();
  for(const std::string& name : options.json_files())
    files.push_back({name, json});
  for(const std::string& name : options.polylines_files())
    files.push_back({name, report_as_polylines(report)});
  for(const std::string& name : options.ply_files())
    files.push_back({name, report_as_ply(report)});
  for(const std::string& name : options.vtp_files())
    files.push_back({name, report_as_vtp(report)});
  for(const std::string& name : options.obj_files())
    files.push_back({name, report_as_obj(report)});
  for(const std::string& name : options.csv_files())
    files.push_back({name, report_as_csv(report)});
  std::vector<std::string> obsolete;
  if(report.labelling && !options.folder.empty())
  {
    const Part_files parts = files_of_parts(options, report, cut_along_borders(report.mesh, *report.labelling));
    files.push_back({options.labels_file(),
                     labels_as_lines(labels_of_file(report.mesh, report.file.numbering, *report.labelling))});
    files.insert(files.end(), parts.files.begin(), parts.files.end());
    obsolete = parts.obsolete;
  }
  write_files(files, obsolete);
  if(!files.empty() && tells_results(options))
    std::cerr << written_files_as_text(files) << result_as_text(report) << std::flush;
  if(options.prints_json())
    write_to_standard_output(json);
  if(options.prints_csv())
    write_to_standard_output(report_as_csv(report));
  if(options.prints_table())
    write_to_standard_output(report_as_table(report, options.is_verbose));
}

// Of the curves of a page that are shown at first.
double minimum_prominence(const Options& options)
{
  return options.selection.minimum_prominence.value_or(CGAL::Surface_mesh_constrictions::default_minimum_prominence);
}

// The curves of a page: the weaker ones of its slider, too.
Selection selection_for_page(const Options& options)
{
  Selection result = options.selection;
  result.minimum_prominence = (std::min)(minimum_prominence(options), least_prominence_in_page);
  return result;
}

void write_page(const Options& options, const Report& report, Levels& levels)
{
  const Parts parts = segment_mesh(report.mesh, report.constrictions, options.segmentation);
  const Playback playback = record_playback(report.mesh, report.constrictions, std::move(levels.value()));
  const std::vector<Output_file> files = {
      {options.page, view_page(report, parts, playback, minimum_prominence(options))}};
  write_files(files);
  if(!tells_results(options))
    return;
  std::cerr << written_files_as_text(files) << result_as_text(report);
  const auto hidden =
      std::count_if(report.constrictions.begin(), report.constrictions.end(),
                    [&](const Constriction& c) { return c.prominence() < minimum_prominence(options); });
  if(hidden > 0)
    std::cerr << hidden << " of a smaller prominence than " << minimum_prominence(options)
              << (hidden == 1 ? " is" : " are") << " not shown at first\n";
  std::cerr << std::flush;
}

// On one line, if there is anything to tell.
void tell_of_repairs(const std::string& mesh, const File_record& record)
{
  const std::string summary = summary_of(record.findings);
  if(!summary.empty())
    std::cerr << "constrictions: " << printable(mesh) << ": " << summary << std::endl;
}

// How to see what was found, if nothing of it is selected; else empty.
std::string hint_at_all(const Options& options, const Report& report)
{
  const Selection& s = options.selection;
  if(!report.constrictions.empty() || s.all || s.maximum_number == 0)
    return "";
  if(options.search.location)
    return near_hint(report.statistics.not_selected);
  if(report.statistics.not_selected == 0)
    return "";
  return std::string("Closed geodesics were found but are not selected; --all shows them") +
         (s.minimum_length || s.maximum_length ? ", within the bounds of the length." : ".");
}

// Returns the exit code.
int run(const Options& options)
{
  const auto begin = std::chrono::steady_clock::now();
  Report report;
  report.mesh_file = options.mesh;
  report.mesh = read_mesh_file(options.mesh, options.reading, report.file);
  report.seconds.read = seconds_since(begin);
  Loops loops;
  Place_loops place_loops;
  std::vector<Label> labels;
  std::vector<Landmark> landmarks;
  if(!options.landmarks.empty())
    landmarks = read_landmarks_file(options.landmarks);
  else if(!options.places.empty())
    place_loops = read_places_file(options.places, report.mesh, report.file.numbering);
  else if(!options.labels.empty())
    labels = read_labels_file(options.labels, report.file.numbering.faces);
  else if(options.command == Command::TIGHTEN)
    loops = read_loops_file(options.loops, report.mesh, report.file.numbering);
  check_outputs(options);

  Levels levels;
  Handle_removal removal;
  {
    Stage_monitor monitor(!options.quiet && is_error_output_terminal());
    if(!landmarks.empty())
      ask_at_landmarks(options, landmarks, monitor, report);
    else if(!options.places.empty())
      tighten_through(options, place_loops, monitor, report);
    else if(!options.labels.empty())
      tighten_borders(options, labels, monitor, report);
    else if(options.command == Command::TIGHTEN)
      tighten(options, loops, monitor, report);
    else if(options.command == Command::GIRTH)
      girth(options, monitor, report);
    else if(options.removes_handles())
      removal = remove_handles(options, monitor, report);
    else if(options.command == Command::VIEW)
      detect(options, selection_for_page(options), monitor, report, &levels);
    else
      detect(options, options.selection, monitor, report, nullptr);
    if(options.search.measures)
      measure_curves(report);
    report.seconds.simplify = monitor.seconds(Detection_stage::SIMPLIFICATION);
    report.seconds.seeds = monitor.seconds(Detection_stage::SEEDS);
    report.seconds.refine = monitor.seconds(Detection_stage::REFINEMENT);
    report.seconds.tighten = monitor.seconds(Detection_stage::TIGHTENING);
    report.seconds.certify = monitor.seconds(Detection_stage::CERTIFICATION);
    report.seconds.select = monitor.seconds(Detection_stage::SELECTION);
  }
  tell_of_repairs(options.mesh, report.file);
  if(options.removes_handles())
  {
    report.seconds.total = seconds_since(begin);
    return write_handles(options, report, removal);
  }
  if(options.command != Command::GIRTH && landmarks.empty())
    report.hint = hint_at_all(options, report);
  if(options.command == Command::VIEW)
  {
    write_page(options, report, levels);
    return 0;
  }
  if(options.command == Command::SEGMENT)
  {
    const auto detected = std::chrono::steady_clock::now();
    Parts parts = segment_mesh(report.mesh, report.constrictions, options.segmentation);
    parts.format = options.segmentation.format;
    parts.unit = report.file.unit;
    parts.seconds = seconds_since(detected);
    report.seconds.total = seconds_since(begin);
    write_parts(options, report, parts);
    return 0;
  }
  report.seconds.total = seconds_since(begin);
  write_outputs(options, report);
  return 0;
}

// Returns the exit code.
int certify(const Options& options)
{
  File_record record;
  const Mesh mesh = read_mesh_file(options.mesh, options.reading, record);
  const Curves curves = read_curves_file(options.curves, mesh, record.numbering);
  check_outputs(options);

  std::vector<Certified_curve> certified;
  {
    Stage_monitor monitor(!options.quiet && is_error_output_terminal(), Detection_stage::CERTIFICATION);
    try
    {
      certified = certify_curves(mesh, curves, monitor);
    }
    catch(const Invalid_input& e)
    {
      throw with_hint(e, record);
    }
  }
  tell_of_repairs(options.mesh, record);
  if(curves.are_found_by_points)
    std::cerr << "constrictions: " << printable(options.curves)
              << ": the mesh is numbered in another way now; the curves were found by their points" << std::endl;
  const std::string json = certificates_as_json(options.mesh, record.numbering, certified);
  std::vector<Output_file> files;
  for(const std::string& name : options.json_files())
    files.push_back({name, json});
  write_files(files);
  if(tells_results(options))
    std::cerr << written_files_as_text(files) << std::flush;
  write_to_standard_output(options.prints_json() ? json : certificates_as_lines(certified));

  const auto failures = std::count_if(certified.begin(), certified.end(),
                                      [](const Certified_curve& c) { return !c.certificate.is_certified(); });
  if(failures == 0)
    return 0;
  std::cerr << "constrictions: " << printable(options.curves) << ": " << failures << " of " << certified.size()
            << (certified.size() == 1 ? " curve" : " curves") << " not certified" << std::endl;
  return 1;
}

// Returns the exit code.
int prepare(const Options& options)
{
  File_record record;
  const Mesh mesh = read_mesh_file(options.mesh, options.reading, record);
  check_outputs(options);
  std::vector<Output_file> files;
  {
    Stage_monitor monitor(!options.quiet && is_error_output_terminal(), Detection_stage::SEEDS);
    try
    {
      files.push_back({options.prepared, prepare_mesh(mesh, monitor)});
    }
    catch(const Invalid_input& e)
    {
      throw with_hint(e, record);
    }
  }
  tell_of_repairs(options.mesh, record);
  write_files(files);
  if(tells_results(options))
    std::cerr << written_files_as_text(files) << std::flush;
  return 0;
}

// Returns the exit code.
int check(const Options& options)
{
  check_outputs(options);
  const Check_report report = check_mesh(options.mesh, options.reading);
  const std::string json = check_as_json(report);
  std::vector<Output_file> files;
  for(const std::string& name : options.json_files())
    files.push_back({name, json});
  if(!options.repaired.empty() && report.mesh.number_of_faces() > 0)
    files.push_back({options.repaired, mesh_as_text(report.mesh, options.repaired)});
  write_files(files);
  if(tells_results(options))
    std::cerr << written_files_as_text(files) << std::flush;
  write_to_standard_output(options.prints_json() ? json : check_as_text(report));
  return report.refusal.empty() ? 0 : 1;
}

// What `detect` finds in a mesh.
Report detection(const Options& options, const std::string& mesh)
{
  Report report;
  report.mesh_file = mesh;
  report.mesh = read_mesh_file(mesh, options.reading, report.file);
  Stage_monitor monitor(false);
  detect(options, options.selection, monitor, report, nullptr);
  return report;
}

// The exit code that belongs to the exception being handled, after its message has been shown.
int report_failure(const Options& options)
{
  const int unusable_input = 1, unwritable_output = 3;
  const std::string subject = options.command == Command::BATCH ? "batch" : printable(options.mesh);
  try
  {
    throw;
  }
  catch(const Output_file_error& e)
  {
    std::cerr << "constrictions: " << e.what() << std::endl;
    return unwritable_output;
  }
  catch(const Input_file_error& e)
  {
    std::cerr << "constrictions: " << e.what() << std::endl;
  }
  catch(const std::bad_alloc&)
  {
    std::cerr << "constrictions: " << subject << ": not enough memory" << std::endl;
  }
  catch(const std::exception& e)
  {
    std::cerr << "constrictions: " << subject << ": " << printable(e.what()) << std::endl;
  }
  return unusable_input;
}

const char* const memory_message = "constrictions: not enough memory\n";

std::terminate_handler handler_of_other_exceptions = nullptr;

// Ends the process where memory is used up and the exception cannot leave: the destructor of a JSON value allocates.
[[noreturn]] void end_without_memory()
{
  if(std::current_exception() != nullptr)
    try
    {
      throw;
    }
    catch(const std::bad_alloc&)
    {
      std::fputs(memory_message, stderr);
      std::_Exit(1);
    }
    catch(...)
    {}
  else if(std::uncaught_exceptions() > 0) // a destructor has thrown while another exception was on its way
  {
    std::fputs(memory_message, stderr);
    std::_Exit(1);
  }
  handler_of_other_exceptions();
  std::abort();
}

} // namespace

} // namespace constrictions

int main(int argc, char** argv)
{
  constrictions::handler_of_other_exceptions = std::set_terminate(&constrictions::end_without_memory);
  constrictions::fail_beyond_limit_of_file_sizes(); // and tell of it
  constrictions::Options options;
  try
  {
    if(const std::optional<int> exit_code = constrictions::parse_options(argc, argv, options))
      return *exit_code;
    if(options.command == constrictions::Command::VIEW && constrictions::page_template().empty())
    {
      std::cerr << "constrictions: view: this program was built without the viewer, which needs esbuild and three.js"
                << std::endl;
      return 2;
    }
    constrictions::limit_threads(options.threads);
    if(options.command == constrictions::Command::CERTIFY)
      return constrictions::certify(options);
    if(options.command == constrictions::Command::PREPARE)
      return constrictions::prepare(options);
    if(options.command == constrictions::Command::CHECK)
      return constrictions::check(options);
    if(options.command == constrictions::Command::BATCH)
    {
      constrictions::run_batch(options, [&options](const std::string& mesh) {
        constrictions::limit_threads(1); // several meshes are gone through at a time
        return constrictions::detection(options, mesh);
      });
      return 0;
    }
    return constrictions::run(options);
  }
  catch(...)
  {
    try
    {
      return constrictions::report_failure(options);
    }
    catch(const std::bad_alloc&) // nor for the message
    {
      std::fputs(constrictions::memory_message, stderr);
      return 1;
    }
  }
}
