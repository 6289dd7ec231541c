// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_OPTIONS_H
#define CONSTRICTIONS_OPTIONS_H

#include "batch/batch_input.h"
#include "batch/process_pool.h"
#include "input/mesh_file.h"
#include "output/part_format.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

enum class Command
{
  DETECT,
  GIRTH,
  PREPARE,
  TIGHTEN,
  CERTIFY,
  SEGMENT,
  BATCH,
  VIEW,
  CHECK
};

enum class Policy
{
  GARLAND_HECKBERT,
  LINDSTROM_TURK,
  EDGE_LENGTH
};

/// Which of the curves that are found are reported. A threshold that was not given is the library's.
struct Selection
{
  std::optional<double> minimum_prominence;
  std::optional<double> minimum_isolation;
  std::optional<double> maximum_ratio;
  std::optional<double> minimum_length;
  std::optional<double> maximum_length;
  std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)();
  bool all = false;
  bool rims = false; ///< also those along the boundary of a hole
};

/// How constrictions are searched.
struct Search
{
  bool triangles_only = false; ///< seeds are non-face triangles, no others
  bool certifies = true;
  bool measures_prominence = true; ///< if not, all curves are reported
  bool proves_prominence = false;
  bool measures = false;                         ///< caps, and how wide the body gets beside each curve
  std::optional<std::array<double, 3>> location; ///< near which, instead of everywhere
};

/// Where loops are held, and which of them are reported.
struct Girth
{
  std::optional<std::array<double, 3>> location; ///< or else at landmarks
  std::size_t maximum_number = 1;
  double minimum_angle = 0.78539816339744828; ///< radians; a quarter of pi, as in the library
  std::optional<std::array<double, 3>> axis;  ///< of the limb, perpendicular to the plane of a section
};

/// Which constrictions cut the surface into parts, or cut handles off, and what is written of the result.
struct Segmentation
{
  std::optional<std::size_t> genus;   ///< to which handles are removed, instead of cutting into parts
  std::optional<std::size_t> handles; ///< how many are removed, likewise
  std::optional<std::size_t> parts;   ///< at most
  std::optional<CGAL::Surface_mesh_constrictions::Side> side;
  bool open = false; ///< without caps
  Part_format format = Part_format::PLY;
};

/// Which meshes are gone through, and what each may use.
struct Batch
{
  std::vector<std::string> inputs;
  Slice slice;
  Process_limits limits;
};

/// The command line. A file or folder that was not given has an empty name.
struct Options
{
  Command command = Command::DETECT;
  std::string mesh;
  std::string loops;
  std::string places; ///< of loops through places
  std::string labels;
  std::string landmarks;
  std::string prepared; ///< what `PREPARE` writes of the mesh, and others read
  std::string curves;
  std::string folder;
  std::string json; ///< "-" is the standard output
  std::string polylines;
  std::string csv; ///< "-" is the standard output
  std::string page;
  std::string repaired; ///< the mesh as repaired
  Reading reading;
  Policy policy = Policy::GARLAND_HECKBERT;
  Search search;
  Girth girth;
  Selection selection;
  Segmentation segmentation;
  std::optional<std::size_t> threads; ///< at most
  Batch batch;
  bool quiet = false;
  bool is_verbose = false;

  /// whether meshes of parts are written into the folder
  bool writes_parts() const
  {
    return (command == Command::SEGMENT && !removes_handles()) || (!labels.empty() && !folder.empty());
  }

  /// whether handles are removed, and the surface without them is written into the folder
  bool removes_handles() const { return segmentation.genus || segmentation.handles; }

  bool prints_json() const { return json == "-"; }
  bool prints_csv() const { return csv == "-"; }
  bool prints_table() const { return folder.empty() && json.empty() && polylines.empty() && csv.empty(); }

  std::vector<std::string> json_files() const;
  std::vector<std::string> polylines_files() const;
  std::vector<std::string> ply_files() const;
  std::vector<std::string> vtp_files() const;
  std::vector<std::string> obj_files() const;
  std::vector<std::string> csv_files() const;

  /// of the new labels
  std::string labels_file() const;

  /// the file of this name in the folder
  std::string file_in_folder(const std::string& name) const;
};

/// reads the command line. Returns the exit code if there is nothing to be done: after a request for help, and, with a
/// message on the standard error output, when the command line is wrong.
std::optional<int> parse_options(int argc, char** argv, Options& options);

} // namespace constrictions

#endif // CONSTRICTIONS_OPTIONS_H
