// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshoptimizer_simplifier.h"

#ifdef WITH_MESHOPTIMIZER

#include <meshoptimizer.h>

Meshoptimizer_simplifier::Meshoptimizer_simplifier(const std::vector<std::array<double, 3>>& points,
                                                   const std::vector<std::array<std::size_t, 3>>& triangles)
{
  m_points.reserve(3 * points.size());
  for(const std::array<double, 3>& p : points)
    for(const double x : p)
      m_points.push_back(static_cast<float>(x));
  m_indices.reserve(3 * triangles.size());
  for(const std::array<std::size_t, 3>& t : triangles)
    for(const std::size_t v : t)
      m_indices.push_back(static_cast<unsigned int>(v));
  m_result.resize(m_indices.size());
}

std::size_t Meshoptimizer_simplifier::faces_after_simplification(std::size_t target)
{
  constexpr float any_error = 1e6f; // in sizes of the mesh
  return meshopt_simplify(m_result.data(), m_indices.data(), m_indices.size(), m_points.data(), m_points.size() / 3,
                          3 * sizeof(float), 3 * target, any_error, 0, nullptr) /
         3;
}

#else

Meshoptimizer_simplifier::Meshoptimizer_simplifier(const std::vector<std::array<double, 3>>&,
                                                   const std::vector<std::array<std::size_t, 3>>&)
{}

std::size_t Meshoptimizer_simplifier::faces_after_simplification(std::size_t) { return 0; }

#endif
