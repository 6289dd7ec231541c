// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include "command_line.h"
#include "help/command_help.h"
#include "option_values.h"
#include "output/mesh_as_text.h"
#include "output/parts.h"
#include "usage_error.h"
#include "written_files.h"
#include "zip_archive.h"

#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;

const char* const description =
    "Finds the constrictions of a surface: closed curves of locally minimal length, where a rubber band around the\n"
    "object stays put. The surface is a mesh in an OFF, OBJ, PLY, STL, VTK, VTP, GLB or 3MF file, which may be\n"
    "gzipped; the file name - is the standard input. Polygons are triangulated, and places that are not manifold are\n"
    "repaired, without moving a vertex; a line on the standard error output, and the JSON, say what was done. Faces\n"
    "and vertices are numbered as in the file.\n";

const char* const examples =
    "\nExamples:\n"
    "  constrictions detect bone.ply\n"
    "      prints a table of the constrictions of bone.ply\n"
    "  constrictions detect bone.ply -o result\n"
    "      writes result/constrictions.json, and the curves as polylines, PLY and VTP\n"
    "  constrictions detect hand.ply --near 1.5,0,-2 --max 1\n"
    "      prints the constriction nearest to a place: the loop around a finger\n"
    "  constrictions detect bone.ply --max-length 30 --csv necks.csv\n"
    "      writes a table, for spreadsheets, of the constrictions that are no longer than 30\n"
    "  constrictions girth hand.ply --at 1.5,0,-2\n"
    "      prints the length of the shortest loop around the finger through a place, whether it is narrow there or "
    "not\n"
    "  constrictions girth body.ply --landmarks landmarks.csv --csv -\n"
    "      prints a table of the girths at many places, each on a line x,y,z or name,x,y,z\n"
    "  constrictions prepare body.ply -o body.prepared\n"
    "      prepares a large mesh once; with --prepared body.prepared, detect and girth then start at once\n"
    "  constrictions tighten bone.ply --loops loops.txt --json -\n"
    "      shortens your own loops, given as vertex numbers, and prints the outcome as JSON\n"
    "  constrictions tighten bone.ply --labels parts.txt -o result\n"
    "      makes the borders of your own parts, given as a number for each face, as short as they can be\n"
    "  constrictions segment bone.ply -o parts --side object\n"
    "      cuts the surface at its necks; writes parts/parts.ply, parts/parts.json and parts/part_0.ply ...\n"
    "  constrictions segment scan.ply -o clean --genus 0\n"
    "      cuts the handles that do not belong there, along the shortest curves; writes clean/without_handles.ply\n"
    "  constrictions view bone.ply -o bone.html\n"
    "      writes a page that shows the surface with its constrictions and parts; open it in a browser\n"
    "  constrictions certify bone.ply --curves result/constrictions.json\n"
    "      proves with exact arithmetic that the curves are constrictions, or says what is wrong with them\n"
    "  constrictions check scan.stl -o repaired.ply\n"
    "      prints what is wrong with a mesh, and writes the repaired mesh that the other commands would use\n"
    "  constrictions batch meshes -o results -j 8 --time-limit 60\n"
    "      processes the meshes of a folder, 8 at a time; writes a line of JSON for each into results/results.jsonl\n"
    "\n"
    "Exit codes: 0 done (there may be no constrictions), 1 the input is not a usable mesh, or a curve is not\n"
    "certified, 2 wrong usage, 3 an output could not be written.\n";

void add_reading(CLI::App& command, Reading& reading)
{
  command.add_flag("--strict", reading.is_strict,
                   "refuse a mesh with polygons, duplicate or degenerate faces, or edges or vertices that are not "
                   "manifold, instead of repairing it");
  command
      .add_option(
          "--merge", reading.merging_distance,
          "merge vertices that are nearer to each other than this; each is merged into the first vertex near it")
      ->type_name("EPS")
      ->check(greater_than_zero());
}

void add_mesh(CLI::App& command, Options& options)
{
  command
      .add_option("MESH", options.mesh,
                  "mesh (OFF, OBJ, PLY, STL, VTK, VTP, GLB or 3MF, also gzipped); - is the standard input")
      ->type_name("FILE|-")
      ->required()
      ->check(not_empty);
  add_reading(command, options.reading);
}

void add_check_options(CLI::App& command, Options& options)
{
  add_mesh(command, options);
  command.add_option("-o", options.repaired, "write the repaired mesh as OFF, OBJ or PLY, by the extension")
      ->type_name("FILE")
      ->check(not_empty)
      ->check(CLI::Validator(
          [](const std::string& name) {
            return is_text_format(name) ? "" : "give a file name that ends in .off, .obj or .ply";
          },
          ""));
  command.add_option("--json", options.json, "write the report as JSON; - prints it, instead of the lines")
      ->type_name("FILE|-")
      ->check(not_empty);
  command.footer(
      "\nThe exit code is 0 if constrictions of the mesh can be computed, as it is or as repaired, else 1.\n");
}

void add_no_certify(CLI::App& command, Search& search)
{
  command.add_flag_callback(
      "--no-certify", [&search] { search.certifies = false; },
      "skip the proof with exact arithmetic: curves rest on rounded numbers");
}

void add_common_options(CLI::App& command, Options& options)
{
  const CLI::Validator not_dash([](const std::string& name) { return name == "-" ? "give the name of a file" : ""; },
                                "");

  add_mesh(command, options);
  command
      .add_option("-o", options.folder,
                  "write constrictions.json, constrictions.polylines.txt, and, for other viewers, constrictions.ply, "
                  "constrictions.vtp and constrictions.obj into the folder DIR; it is created if missing")
      ->type_name("DIR")
      ->check(not_empty);
  command.add_option("--json", options.json, "write all data of the curves as JSON; - prints it")
      ->type_name("FILE|-")
      ->check(not_empty);
  command.add_option("--polylines", options.polylines, "write the points of the curves in CGAL's polylines format")
      ->type_name("FILE")
      ->check(not_empty)
      ->check(not_dash);
  command
      .add_option("--csv", options.csv,
                  "write a table of comma-separated values with a line for each curve; - prints it")
      ->type_name("FILE|-")
      ->check(not_empty);
  add_no_certify(command, options.search);
  command.add_flag("--quiet", options.quiet, "show no progress, and no summary at the end");
  command.add_flag("--verbose", options.is_verbose,
                   "add centroids, numbers of pivots and seed levels to the table, and how the seeds ended");
  command.footer("\nWithout -o, --json, --csv and --polylines a table is printed.\n");
}

void add_threads(CLI::App& command, Options& options)
{
  command
      .add_option("--threads", options.threads,
                  "use N threads at most, by default one for each processor; the result does not depend on it")
      ->type_name("N")
      ->check(whole_number(1));
}

void add_certify_options(CLI::App& command, Options& options)
{
  add_mesh(command, options);
  command
      .add_option("--curves", options.curves,
                  "closed curves on the mesh: the locations and pivots of a JSON file as detect and tighten write it")
      ->type_name("FILE")
      ->required()
      ->check(not_empty);
  command.add_option("--json", options.json, "write the verdicts as JSON; - prints them, instead of the lines")
      ->type_name("FILE|-")
      ->check(not_empty);
  command.add_flag("--quiet", options.quiet, "show no progress");
  command.footer("\nPrints a line for each curve: its id, and strict_constriction, constriction, or not_certified with "
                 "the\nreason. The exit code is 0 only if every curve is certified, else 1.\n");
}

void add_policy(CLI::App& command, std::string& policy)
{
  command
      .add_option("--policy", policy,
                  "how the mesh is simplified in the search for curves: gh (Garland-Heckbert, default), lt "
                  "(Lindstrom-Turk) or length (shortest edge first)")
      ->type_name("gh|lt|length")
      ->check(CLI::IsMember({"gh", "lt", "length"}).description(""));
}

CLI::Option* add_seeds(CLI::App& command, Search& search)
{
  return command
      .add_option_function<std::string>(
          "--seeds", [&search](const std::string& seeds) { search.triangles_only = seeds == "triangles"; },
          "where the search starts: all (default) takes several kinds of closed curves on the simplified mesh; "
          "triangles "
          "takes only three edges without a face, which is faster and misses more")
      ->type_name("all|triangles")
      ->check(CLI::IsMember({"all", "triangles"}).description(""));
}

void add_segment_options(CLI::App& command, Options& options, std::string& side)
{
  add_mesh(command, options);
  command
      .add_option(
          "-o", options.folder,
          "write parts.ply and parts.vtp, the mesh with a colour and a patch number for each face, parts.json, and "
          "for each part a closed mesh part_0.ply, part_1.ply ... into the folder DIR; it is created if missing. "
          "Files of parts that an earlier run has written there are removed")
      ->type_name("DIR")
      ->required()
      ->check(not_empty);
  command
      .add_option("--parts", options.segmentation.parts,
                  "cut into N parts at most, along the first curves of the table")
      ->type_name("N")
      ->check(whole_number(1));
  command
      .add_option(
          "--side", side,
          "cut only along curves that choke the object, as at its necks, or the space around it, as in the hole of a "
          "ring")
      ->type_name("object|complement")
      ->check(CLI::IsMember({"object", "complement"}).description(""));
  command
      .add_option_function<std::string>(
          "--format", [&options](const std::string& name) { options.segmentation.format = *part_format(name); },
          "the format of the files of the parts, by default ply; stl and glb have coordinates in single precision; "
          "3mf is one file, parts.3mf, with an object for each part")
      ->type_name("ply|stl|obj|glb|3mf")
      ->check(CLI::IsMember(part_format_names()).description(""));
  command.add_flag("--open", options.segmentation.open, "do not close the holes of the parts");
  add_no_certify(command, options.search);
  command.add_flag("--quiet", options.quiet, "show no progress, and print no table");
  command.footer("\nPrints a table of the parts. Of two curves that cross, the more prominent one cuts.\n");
}

// After the options of the selection, which choose other curves than the shortest.
void add_handle_options(CLI::App& command, Options& options)
{
  CLI::Option* const genus =
      command
          .add_option("--genus", options.segmentation.genus,
                      "instead of cutting into parts, cut handles or fill tunnels until the genus is G: along the "
                      "shortest curves, each closed on both sides. Writes the surface as without_handles.ply, and "
                      "handles.json, into the folder; --side and --max-length limit the curves")
          ->type_name("G")
          ->check(whole_number(0));
  CLI::Option* const handles =
      command.add_option("--handles", options.segmentation.handles, "the same, but remove N handles")
          ->type_name("N")
          ->check(whole_number(1))
          ->excludes(genus);
  for(const char* other :
      {"--parts", "--open", "--max", "--min-prominence", "--min-isolation", "--max-ratio", "--all", "--rims"})
  {
    genus->excludes(other);
    handles->excludes(other);
  }
}

void add_view_options(CLI::App& command, Options& options)
{
  add_mesh(command, options);
  command
      .add_option(
          "-o", options.page,
          "write a page that shows the mesh, its parts and constrictions, and how these were found; it needs no "
          "other file and no network")
      ->type_name("FILE.html")
      ->required()
      ->check(not_empty);
  add_no_certify(command, options.search);
  command.add_flag("--quiet", options.quiet, "show no progress, and no summary at the end");
  command.footer("\nA slider in the page shows weaker curves, too, down to a prominence of 0.01, or all with --all.\n");
}

// The end of a sentence.
std::string by_default(double x)
{
  std::ostringstream out;
  out << "; by default " << x;
  return out.str();
}

void add_selection_options(CLI::App& command, Selection& selection)
{
  command.add_flag("--all", selection.all, "report every distinct closed geodesic found, without selection");
  command.add_flag("--rims", selection.rims,
                   "report also curves that run along the boundary of a hole for most of their length");
  command
      .add_option("--max", selection.maximum_number,
                  "report N curves at most: those with the greatest product of prominence and roundness, or, with "
                  "detect --near, "
                  "the nearest")
      ->type_name("N")
      ->check(whole_number(0));
  command
      .add_option(
          "--min-prominence", selection.minimum_prominence,
          "leave out curves that slide to a shorter one, or off, when they are stretched by less than this share "
          "of their length" +
              by_default(SMC::default_minimum_prominence))
      ->type_name("P")
      ->check(not_negative());
  command
      .add_option(
          "--min-isolation", selection.minimum_isolation,
          "leave out curves that lie beside a more prominent one: the area between the two, divided by length^2, "
          "is less than this" +
              by_default(SMC::default_minimum_isolation))
      ->type_name("I")
      ->check(not_negative());
  command
      .add_option(
          "--max-ratio", selection.maximum_ratio,
          "leave out curves that cut off too small an area: length^2 / (4 pi area) is greater than this, which is 0.5 "
          "for the equator of a sphere" +
              by_default(SMC::default_maximum_isoperimetric_ratio))
      ->type_name("R")
      ->check(not_negative());
  command
      .add_option("--min-length", selection.minimum_length,
                  "after the selection, leave out curves that are shorter than this, in the unit of the mesh; --max "
                  "counts the rest")
      ->type_name("L")
      ->check(not_negative());
  command
      .add_option("--max-length", selection.maximum_length,
                  "after the selection, leave out curves that are longer than this")
      ->type_name("L")
      ->check(not_negative());
}

void add_near_option(CLI::App& command, Search& search)
{
  command
      .add_option_function<std::string>(
          "--near", [&search](const std::string& text) { search.location = parse_location(text); },
          "report the curves around this location, the nearest first, such as the loop around an arm; weak ones, too, "
          "unless --min-prominence is given; none where nothing is narrow")
      ->type_name("X,Y,Z")
      ->check(is_location());
}

CLI::Option* add_landmarks_option(CLI::App& command, Options& options)
{
  return command
      .add_option(
          "--landmarks", options.landmarks,
          "instead of one place, those of a file of comma-separated values: on each line x,y,z, or a name before "
          "them; the mesh is prepared once")
      ->type_name("FILE")
      ->check(not_empty);
}

CLI::Option* add_prepared_option(CLI::App& command, Options& options)
{
  return command
      .add_option("--prepared", options.prepared,
                  "read what the command prepare has written of this mesh, instead of preparing it again; the results "
                  "are the same")
      ->type_name("FILE")
      ->check(not_empty);
}

void add_prepare_options(CLI::App& command, Options& options)
{
  add_mesh(command, options);
  command
      .add_option("-o", options.prepared,
                  "write the simplification of the mesh and its seed curves into FILE, about 25 bytes for each face")
      ->type_name("FILE")
      ->required()
      ->check(not_empty);
  add_threads(command, options);
  command.add_flag("--quiet", options.quiet, "show no progress");
  command.footer(
      "\nFor detect --prepared FILE and girth --prepared FILE with the same mesh, --merge and --strict: what "
      "was\nprepared of another mesh, or by another version of the format, is refused.\n");
}

void add_girth_options(CLI::App& command, Girth& girth)
{
  command
      .add_option_function<std::string>(
          "--at", [&girth](const std::string& text) { girth.location = parse_location(text); },
          "hold the loops at this place, or at the point of the surface that is nearest to it")
      ->type_name("X,Y,Z")
      ->check(is_location());
  CLI::Option* const axis =
      command
          .add_option_function<std::string>(
              "--axis", [&girth](const std::string& text) { girth.axis = parse_location(text); },
              "the direction of the limb: measure the section with the plane through the place that is perpendicular "
              "to it, and report the loop that the section becomes when it is tightened with the place held")
          ->type_name("X,Y,Z")
          ->check(is_location());
  command.add_option("--max", girth.maximum_number, "report N loops at most, the shortest ones; by default 1")
      ->type_name("N")
      ->check(whole_number(1))
      ->excludes(axis);
  command
      .add_option(
          "--min-angle", girth.minimum_angle,
          "leave out loops whose angle at the place, in radians, is less than this, by default 0.785; it is near 3.14 "
          "around a tube, and small where a loop runs to a limb, around it, and back")
      ->type_name("A")
      ->check(not_negative())
      ->excludes(axis);
}

void add_batch_options(CLI::App& command, Options& options)
{
  const CLI::Validator is_slice(
      [](const std::string& text) {
        return parse_slice(text) ? "" : "give the number of a slice and the number of slices, as in 2/10";
      },
      "");
  const CLI::Validator positive = greater_than_zero();
  Batch& batch = options.batch;
  batch.limits.processes = (std::max)(1u, std::thread::hardware_concurrency());
  batch.limits.seconds = 3600;

  command
      .add_option(
          "INPUT", batch.inputs,
          "a text file with the name of a mesh on each line (- is the standard input), a folder with OFF, OBJ, PLY, "
          "STL, VTK, VTP, GLB and 3MF files, also gzipped, or a mesh")
      ->type_name("LIST|DIR|MESH ...")
      ->required()
      ->check(not_empty);
  command
      .add_option("-o", options.folder,
                  "write the lines into DIR/results.jsonl; meshes that have a line there are skipped")
      ->type_name("DIR")
      ->check(not_empty);
  command.add_option("-j", batch.limits.processes, "process N meshes at a time, by default one for each processor")
      ->type_name("N")
      ->check(whole_number(1, 500));
  command.add_option("--time-limit", batch.limits.seconds, "give up a mesh after this time; by default 3600")
      ->type_name("SECONDS")
      ->check(positive);
  command
      .add_option("--memory-limit", batch.limits.bytes,
                  "give up a mesh that needs more memory (address space) than this, as in 500MB or 2GB")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(true).description(""))
      ->check(positive);
  command
      .add_option_function<std::string>(
          "--slice", [&batch](const std::string& text) { batch.slice = *parse_slice(text); },
          "take only every N-th mesh, from the I-th on, and write DIR/results.I-of-N.jsonl: for the tasks of a job "
          "array")
      ->type_name("I/N")
      ->check(is_slice);
  add_reading(command, options.reading);
  add_no_certify(command, options.search);
  command.add_flag("--quiet", options.quiet, "show no progress, and print no table");
  command.footer(
      "\nEach mesh has a process of its own, so a failure is only a line with its reason. Without -o the lines "
      "are\nprinted. To process a mesh again, delete its line.\n");
}

// Bounds between which there is nothing.
void check_bounds(const Selection& selection)
{
  if(selection.minimum_length && selection.maximum_length && *selection.minimum_length > *selection.maximum_length)
    throw CLI::ValidationError("--min-length", "is greater than --max-length: no curve can be as long as that");
}

Command command_of(const std::string& name)
{
  const std::array<std::pair<const char*, Command>, 8> others = {{{"girth", Command::GIRTH},
                                                                  {"prepare", Command::PREPARE},
                                                                  {"tighten", Command::TIGHTEN},
                                                                  {"certify", Command::CERTIFY},
                                                                  {"segment", Command::SEGMENT},
                                                                  {"batch", Command::BATCH},
                                                                  {"view", Command::VIEW},
                                                                  {"check", Command::CHECK}}};
  for(const auto& [other, command] : others)
    if(name == other)
      return command;
  return Command::DETECT;
}

} // namespace

void describe_program(CLI::App& app, Options& options, Words& words)
{
  app.name("constrictions");
  app.description(description);
  app.formatter(std::make_shared<Help_formatter>());
  app.set_version_flag("--version", "constrictions " CONSTRICTIONS_VERSION);
  app.require_subcommand(1);
  app.footer(examples);

  CLI::App& detect = *app.add_subcommand("detect", "find the constrictions of a mesh");
  add_common_options(detect, options);
  std::string &policy = words.policy, &side = words.side;
  add_policy(detect, policy);
  add_threads(detect, options);
  add_selection_options(detect, options.selection);
  add_near_option(detect, options.search);
  detect.add_flag(
      "--prove-prominence", options.search.proves_prominence,
      "add a lower bound of the prominence, which is proved: the table has it as \"at least\", JSON and CSV "
      "as an interval");
  detect.add_flag("--measure", options.search.measures,
                  "add the area of the cap that closes a cut along the curve, and the girths of its two sides: the "
                  "lengths of the longest curves parallel to it (JSON and CSV)");
  add_landmarks_option(detect, options)->excludes("--near")->excludes("--policy");
  add_seeds(detect, options.search)->excludes("--near")->excludes("--landmarks");
  add_prepared_option(detect, options)->excludes("--policy")->excludes("--seeds");

  CLI::App& girth = *app.add_subcommand("girth", "find the shortest loop around the limb through a place");
  add_common_options(girth, options);
  add_girth_options(girth, options.girth);
  add_landmarks_option(girth, options)->excludes("--at");
  add_prepared_option(girth, options);

  CLI::App& prepare = *app.add_subcommand("prepare", "prepare a mesh for many calls of detect and girth");
  add_prepare_options(prepare, options);

  CLI::App& tighten = *app.add_subcommand(
      "tighten", "shorten given loops, or the borders of given parts, until they are constrictions");
  add_common_options(tighten, options);
  tighten
      .add_option("--loops", options.loops,
                  "closed loops of mesh edges, one a line: vertex numbers counted from 0 and separated by blanks, the "
                  "first not repeated; lines that start with # are skipped")
      ->type_name("FILE")
      ->check(not_empty);
  tighten
      .add_option(
          "--through", options.places,
          "instead of loops of edges, loops through a few places, one a line: vertex numbers or points x,y,z, "
          "separated by blanks. They are joined by geodesics in their order, and the last to the first; the JSON "
          "has the loop as it is held at the places, too")
      ->type_name("FILE")
      ->excludes("--loops")
      ->check(not_empty);
  tighten
      .add_option("--labels", options.labels,
                  "instead of loops, the borders between parts: a label for each face of the mesh, a whole number on "
                  "each line. Borders that meet where there are three labels are held there. With -o the new labels "
                  "are written into DIR/labels.txt, and the parts as segment does")
      ->type_name("FILE")
      ->excludes("--loops")
      ->excludes("--through")
      ->check(not_empty);

  CLI::App& certify = *app.add_subcommand("certify", "prove that given curves are constrictions");
  add_certify_options(certify, options);

  CLI::App& segment = *app.add_subcommand("segment", "cut the surface into parts along its constrictions");
  add_segment_options(segment, options, side);
  add_selection_options(segment, options.selection);
  add_handle_options(segment, options);
  add_policy(segment, policy);
  add_threads(segment, options);
  add_seeds(segment, options.search);

  CLI::App& batch = *app.add_subcommand("batch", "find the constrictions of many meshes");
  add_batch_options(batch, options);
  add_selection_options(batch, options.selection);
  add_policy(batch, policy);
  add_seeds(batch, options.search);

  CLI::App& view = *app.add_subcommand("view", "write a page that shows the constrictions in a browser");
  add_view_options(view, options);
  add_selection_options(view, options.selection);
  add_policy(view, policy);
  add_threads(view, options);
  add_seeds(view, options.search);

  CLI::App& check = *app.add_subcommand("check", "say everything that is wrong with a mesh");
  add_check_options(check, options);
}

std::optional<int> parse_options(int argc, char** argv, Options& options)
{
  CLI::App app;
  Words words;
  describe_program(app, options, words);
  try
  {
    app.parse(argc, argv);
    options.command = command_of(app.get_subcommands().front()->get_name());
    options.policy = words.policy == "gh"   ? Policy::GARLAND_HECKBERT
                     : words.policy == "lt" ? Policy::LINDSTROM_TURK
                                            : Policy::EDGE_LENGTH;
    const bool is_near = options.search.location || (options.command == Command::DETECT && !options.landmarks.empty());
    if(is_near && !options.selection.minimum_prominence)
      options.selection.minimum_prominence = 0;
    if(is_near && !options.selection.minimum_isolation)
      options.selection.minimum_isolation = 0;
    if(!words.side.empty())
      options.segmentation.side = words.side == "object" ? CGAL::Surface_mesh_constrictions::Side::OBJECT
                                                         : CGAL::Surface_mesh_constrictions::Side::COMPLEMENT;
    options.search.measures_prominence = !options.removes_handles();
    check_bounds(options.selection);
    if(options.segmentation.format == Part_format::THREE_MF && !has_zip())
      throw CLI::ValidationError("--format", "this program was built without libzip, which writes 3MF files");
    if(options.command == Command::TIGHTEN && options.loops.empty() && options.places.empty() && options.labels.empty())
      throw CLI::RequiredError("--loops, --through or --labels");
    if(options.command == Command::GIRTH && !options.girth.location && options.landmarks.empty())
      throw CLI::RequiredError("--at or --landmarks");
    if(options.girth.axis && *options.girth.axis == std::array<double, 3>{{0, 0, 0}})
      throw CLI::ValidationError("--axis", "give a direction that is not 0,0,0");
    if(options.command != Command::BATCH) // whose folder has files of other names
      check_files(options);
  }
  catch(const CLI::ParseError& e)
  {
    if(e.get_exit_code() == 0) // help is no error
      return app.exit(e);
    std::cerr << "constrictions: " << usage_error_as_text(app, e) << std::endl;
    return 2;
  }
  return std::nullopt;
}

} // namespace constrictions
