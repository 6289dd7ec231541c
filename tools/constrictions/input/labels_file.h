// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_LABELS_FILE_H
#define CONSTRICTIONS_LABELS_FILE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace constrictions {

typedef std::int64_t Label;

/// reads a label for each face of a mesh file, in the order of the faces: a whole number a line. Empty lines and lines
/// that start with # are passed over.
///
/// Throws `Input_file_error`, with the number of the line, for anything else, and if there are more or fewer labels
/// than faces.
std::vector<Label> read_labels_file(const std::string& name, std::size_t number_of_faces);

} // namespace constrictions

#endif // CONSTRICTIONS_LABELS_FILE_H
