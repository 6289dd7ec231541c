// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_REPORT_H
#define CONSTRICTIONS_REPORT_H

#include "input/landmarks_file.h"
#include "input/mesh_file.h"
#include "output/labelling.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/Plane_section.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
typedef CGAL::Surface_mesh_constrictions::Geodesic_loop<Mesh> Geodesic_loop;

/// Wall time of the stages.
struct Stage_seconds
{
  double read = 0;
  double simplify = 0;
  double seeds = 0;
  double refine = 0;
  double tighten = 0;
  double certify = 0;
  double select = 0;
  double total = 0;
};

/// What was found at a place of a file of landmarks.
struct Landmark_answer
{
  Landmark landmark;
  std::vector<std::size_t> curves; ///< their ids
  std::string hint;                ///< why there is none; may be empty
};

/// A loop through places of the user, held there, and the constriction that it becomes when it is let go.
struct Held_loop
{
  CGAL::Surface_mesh_constrictions::Loop_through_locations<Mesh> loop;
  std::size_t line;                        ///< of the file, counted from 1
  std::optional<std::size_t> constriction; ///< its id
};

/// The section with the plane through a place, and the loop that it becomes when it is tightened.
struct Section_answer
{
  CGAL::Surface_mesh_constrictions::Plane_section<Mesh> section;
  std::optional<std::size_t> curve; ///< the id of the loop
};

/// What a run of the program has found.
struct Report
{
  std::string mesh_file;
  Mesh mesh;
  File_record file; ///< how elements of the mesh are called in its file, and what was repaired
  /// or, of `girth`, the loops, which are not constrictions; they have no locations, which are in `loops`
  std::vector<Constriction> constrictions;
  std::vector<Geodesic_loop> loops; ///< of `girth`, one for each of the above; else empty
  bool is_girth = false;
  std::optional<Labelling> labelling;     ///< of `tighten` with labels
  std::vector<Landmark_answer> landmarks; ///< of places in a file, in their order; else empty
  std::vector<Held_loop> held_loops;      ///< of `tighten` through places
  std::vector<Section_answer> sections;   ///< of `girth` along an axis, one for each place
  CGAL::Surface_mesh_constrictions::Detection_statistics statistics;
  Stage_seconds seconds;
  std::vector<std::string> remarks; ///< lines about loops of the user that did not become constrictions
  std::string hint;                 ///< a sentence that says how more is found, if nothing was; may be empty
};

/// what a section is at its place: closed, open or point
std::string section_name(CGAL::Surface_mesh_constrictions::Section_kind kind);

/// the sections, a line for each
std::string sections_as_text(const Report& report);

/// the report in the format "constrictions/1", in one line
std::string report_as_json(const Report& report);

/// the report as a table for reading, in lines of no more than 80 characters but for what has gone wrong
/// \param is_verbose whether to show also the centroids and what belongs to the search, in lines as long as they get
std::string report_as_table(const Report& report, bool is_verbose);

/// the curves as comma-separated values, as RFC 4180 has them but for the ends of lines: a line with the names of the
/// columns, which are those of the members in JSON, and a line for each curve. Numbers have all their digits.
std::string report_as_csv(const Report& report);

/// the curves in CGAL's `.polylines.txt` format, one line each
std::string report_as_polylines(const Report& report);

/// the curves as VTK PolyData: a closed line each, with `id`, `length`, `prominence`, `is_certified`, `side`, which is
/// 0 for the object, 1 for the complement and 2 for both, and a colour for the side; and for each point whether it is a
/// pivot. The prominence is what a viewer shows in colours at first.
std::string report_as_vtp(const Report& report);

/// the curves as the vertices and edges of a binary PLY file. Vertices have the colour of the side; edges have none, as
/// there are programs that cannot read colours of edges.
std::string report_as_ply(const Report& report);

/// the curves as a Wavefront OBJ file: of each an object `constriction_N` that is a closed line
std::string report_as_obj(const Report& report);

} // namespace constrictions

#endif // CONSTRICTIONS_REPORT_H
