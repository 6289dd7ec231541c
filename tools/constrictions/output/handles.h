// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_HANDLES_H
#define CONSTRICTIONS_HANDLES_H

#include "input/mesh_file.h"
#include "output/part_format.h"
#include "output/report.h"

#include <CGAL/Surface_mesh_constrictions/Removed_handle.h>

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh_constrictions::Removed_handle<Point> Removed_handle;

/// A surface from which handles have been removed.
struct Handle_removal
{
  Mesh mesh; ///< what is left
  std::size_t old_genus = 0;
  std::size_t target_genus = 0; ///< the one asked for
  std::vector<Removed_handle> handles;
  double seconds = 0; ///< of cutting and closing

  std::size_t genus() const { return old_genus - handles.size(); }
};

/// the name of the file of the surface without handles
std::string without_handles_file_name(Part_format format);

/// the content of that file, of which `part_as_file()` tells what the formats can hold
/// \param unit of the coordinates, as in `Parts`
std::string without_handles_as_file(const Handle_removal& removal, Part_format format, const std::string& unit);

/// what has been done in the format "constrictions-handles/1", in one line
std::string handles_as_json(const Report& report, const Handle_removal& removal, Part_format format);

/// what has been done as a table for reading
std::string handles_as_table(const Handle_removal& removal);

} // namespace constrictions

#endif // CONSTRICTIONS_HANDLES_H
