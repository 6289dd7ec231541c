// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_LABELLING_H
#define CONSTRICTIONS_LABELLING_H

#include "input/labels_file.h"
#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Label_border.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh_constrictions::Label_border<Mesh, Label> Label_border;

/// The labels of faces and the borders between them, as tightened.
struct Labelling
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<Label> old_labels, labels; ///< by triangle
  CGAL::Surface_mesh_constrictions::Tightened_labels<Mesh, Label> tightened;
  std::vector<std::size_t> constriction; ///< by border, its place among the constrictions of the report; none if it
                                         ///< is not one
};

/// in the words of the JSON
const char* outcome_name(CGAL::Surface_mesh_constrictions::Label_border_outcome outcome);

/// where a border runs now, and its length and certificate. Of a border that is held the curve is not closed.
CGAL::Surface_mesh_constrictions::Constriction<Mesh> curve_of_border(const Label_border& border);

/// the labels of the faces of a file: of a polygon that of most of its area, of a face that was left out that of one
/// beside it, if there is one
std::vector<std::optional<Label>> labels_of_file(const Mesh& mesh, const File_numbering& numbering,
                                                 const Labelling& labelling);

/// these labels, one a line, as `read_labels_file()` reads them; -1 for faces without
std::string labels_as_lines(const std::vector<std::optional<Label>>& labels);

/// the borders as a table, with what has become of them and of the labels
std::string borders_as_table(const Labelling& labelling);

} // namespace constrictions

#endif // CONSTRICTIONS_LABELLING_H
