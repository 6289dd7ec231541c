// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MESHOPTIMIZER_SIMPLIFIER_H
#define MESHOPTIMIZER_SIMPLIFIER_H

#include <array>
#include <cstddef>
#include <vector>

/// A triangle mesh in arrays of floats and of indices, which meshoptimizer simplifies.
class Meshoptimizer_simplifier
{
public:
  Meshoptimizer_simplifier(const std::vector<std::array<double, 3>>& points,
                           const std::vector<std::array<std::size_t, 3>>& triangles);

  /// simplifies the mesh to a number of faces, whatever the error, into an array that is there already, and returns the
  /// number of faces that is reached; 0 if meshoptimizer is not installed
  std::size_t faces_after_simplification(std::size_t target);

private:
  std::vector<float> m_points;
  std::vector<unsigned int> m_indices, m_result;
};

#endif // MESHOPTIMIZER_SIMPLIFIER_H
