// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef OPENMESH_DECIMATER_H
#define OPENMESH_DECIMATER_H

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

/// A triangle mesh that OpenMesh's decimater simplifies by quadric errors as far as it goes.
class Openmesh_decimater
{
public:
  Openmesh_decimater(const std::vector<std::array<double, 3>>& points,
                     const std::vector<std::array<std::size_t, 3>>& triangles);
  ~Openmesh_decimater();

  /// simplifies a copy of the mesh and returns the number of collapses; 0 if OpenMesh is not installed
  std::size_t collapses_of_a_copy() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

#endif // OPENMESH_DECIMATER_H
