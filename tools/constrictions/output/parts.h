// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PARTS_H
#define CONSTRICTIONS_PARTS_H

#include "input/mesh_file.h"
#include "output/part_format.h"
#include "output/report.h"

#include <CGAL/Surface_mesh_constrictions/Surface_part.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

/// A surface that closes a part at a cut.
struct Cap
{
  std::vector<std::size_t> curves; ///< along which its border runs
  bool cuts_part;                  ///< whether it intersects the part, or another of its caps
};

/// A part of a surface, as a mesh of its own.
struct Part
{
  Mesh mesh;              ///< closed by caps, or open
  double area;            ///< without caps
  double volume;          ///< with caps; NaN if it has holes of the input
  std::size_t genus;      ///< with caps
  std::size_t boundaries; ///< closed curves along which it is cut, each counted on each side where the part lies
  std::vector<Cap> caps;
  bool is_cavity; ///< whether it encloses what is outside of the solid: its volume has not the sign of the whole
};

/// A surface cut along its constrictions.
struct Parts
{
  Mesh mesh;                             ///< split, so that the curves run along edges
  std::vector<std::size_t> part_of_face; ///< of that mesh, by the index of the face
  std::vector<Part> parts;
  std::vector<Label> labels;                   ///< of the parts, if these are those of labels; else empty
  std::vector<std::size_t> part_of_input_face; ///< by face of the input mesh, the part in which most of it lies
  std::vector<std::map<std::size_t, double>> area_of_input_face; ///< in each part
  std::vector<CGAL::Surface_mesh_constrictions::Part_adjacency> adjacencies;
  std::vector<CGAL::Surface_mesh_constrictions::Cut_outcome> outcomes; ///< one for each constriction or border
  /// for each constriction the least number of parts, as for `Segmentation::parts`, from which on it is a border,
  /// whatever their number here; none if it never is, and of borders between labels
  std::vector<std::optional<std::size_t>> border_from;
  double seconds = 0;
  Part_format format = Part_format::PLY; ///< of the files of the parts
  std::string unit;                      ///< of the coordinates, as 3MF names it; empty if it is not known
};

/// the name of the file of a part, which in some formats is that of all parts
std::string part_file_name(std::size_t part, Part_format format);

/// whether `part_file_name()` gives this name, for some part and format
bool is_part_file_name(const std::string& name);

/// the names of the files of parts in a folder that an earlier run has written there, as its parts.json says. Empty if
/// there is no such file, or it cannot be understood. The files need not be there any more.
std::vector<std::string> part_files_of_earlier_run(const std::string& folder);

/// the content of the file of a part: a mesh in the format of the parts, in the colour of the part. In STL, which is
/// binary, and in GLB coordinates are rounded to single precision; throws `std::range_error` if they are too large for
/// that. In OBJ it is an object `part_N`, in GLB a node of that name. In 3MF, a file of all parts, each is such an object;
/// throws `std::runtime_error` if the program was built without libzip.
std::string part_as_file(const Parts& parts, std::size_t part);

/// the parts as a 3MF file: an object `part_N` for each, in its colour, with all digits of the coordinates, in their
/// unit; if that is not known they count as millimetres. Throws `std::runtime_error` if the program was built without
/// libzip.
std::string parts_as_3mf(const Parts& parts);

/// the parts in the format "constrictions-parts/1", in one line
std::string parts_as_json(const Report& report, const Parts& parts);

/// the parts as a table for reading
std::string parts_as_table(const Parts& parts);

/// a mesh as binary PLY: coordinates as doubles, and of each face its part and the part's colour
std::string mesh_as_ply(const Mesh& mesh, const std::vector<std::size_t>& part_of_face);

/// a mesh as VTK PolyData: of each face its part, as `patch`, and the part's colour
std::string mesh_as_vtp(const Mesh& mesh, const std::vector<std::size_t>& part_of_face);

} // namespace constrictions

#endif // CONSTRICTIONS_PARTS_H
