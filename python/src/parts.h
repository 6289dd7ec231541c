// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_PARTS_H
#define CONSTRICTIONS_PYTHON_PARTS_H

#include "surface.h"

#include <CGAL/Surface_mesh_constrictions/Surface_part.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace constrictions {

/// The class `Segmentation` of Python.
struct Segmentation
{
  std::vector<std::int64_t> labels; ///< the part of each face
  CGAL::Surface_mesh_constrictions::Surface_parts parts;
};

/// The class `Split` of Python.
struct Split
{
  std::vector<double> vertices;                  ///< three coordinates each
  std::vector<std::int64_t> faces;               ///< three vertices each
  std::vector<std::int64_t> labels;              ///< the part of each face
  std::vector<std::int64_t> parents;             ///< the face of the surface that each face comes from
  std::vector<std::vector<std::int64_t>> curves; ///< the vertices along each curve
  std::vector<CGAL::Surface_mesh_constrictions::Cut_outcome> outcomes;
};

/// tells the parts that curves cut a mesh into
Segmentation segment(const Mesh& mesh, const std::vector<Constriction>& curves, std::optional<std::size_t> parts);

/// splits the faces of a copy of a mesh along curves
Split split(const Mesh& mesh, const std::vector<Constriction>& curves, std::optional<std::size_t> parts);

/// adds the classes to the module
void define_parts(pybind11::module_& module);

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_PARTS_H
