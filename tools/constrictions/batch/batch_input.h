// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BATCH_INPUT_H
#define CONSTRICTIONS_BATCH_INPUT_H

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

/// Every `count`-th mesh, from the one at `index` (counted from 0) on.
struct Slice
{
  std::size_t index = 0;
  std::size_t count = 1;
};

/// returns the names of the meshes that the inputs stand for, each once, and of these the slice. An input is
/// - a mesh, if its extension is that of a mesh file (off, obj, ply, stl,
///   vtk, vtp, glb or 3mf, in any case, also with .gz behind it);
/// - a folder: the files in it that have such an extension, sorted by name;
/// - else a list: a text file with a name on each line, or "-", the standard input. Lines without any character are
///   skipped.
///
/// Whether the meshes exist is not looked at. Throws `Input_file_error` for a folder or a list that cannot be read or
/// has no meshes.
std::vector<std::string> batch_meshes(const std::vector<std::string>& inputs, const Slice& slice);

} // namespace constrictions

#endif // CONSTRICTIONS_BATCH_INPUT_H
