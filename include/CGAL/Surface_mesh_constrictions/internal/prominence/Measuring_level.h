// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_MEASURING_LEVEL_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_MEASURING_LEVEL_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <cmath>
#include <cstddef>
#include <deque>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A coarser level of a surface, for measuring the prominences of curves that it holds as the input does.
struct Measuring_level
{
  Level_copy copy;
  Edge_lengths lengths;
  Corner_angles angles;

  // Copies the current surface. Linear in T^0.
  explicit Measuring_level(const Progressive_mesh& pm) : copy(pm), lengths(copy.surface()), angles(copy.surface()) {}
};

// The number of vertices of the coarsest level, and the ratio of two levels in turn. The last has less than a third of
// the vertices of the input; a larger one would save little.
constexpr std::size_t least_measuring_vertices = 8192, measuring_factor = 4;

// A level does not hold curves as T^0 does if the surface is smoother there: if its area differs by more than this
// share. The area of scans differs by a tenth of it, that of the steps of voxels by twenty times as much.
constexpr double greatest_difference_of_areas = 0.005;

// The area of the current surface. Linear in T^0.
inline double surface_area(const Progressive_mesh& pm)
{
  double sum = 0;
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
    if(pm.is_face(f) && !pm.is_ghost_face(f))
    {
      const Vector3 p = position(pm, pm.source(3 * f));
      sum += norm(cross(position(pm, pm.source(3 * f + 1)) - p, position(pm, pm.source(3 * f + 2)) - p)) / 2;
    }
  return sum;
}

// The levels of a surface to measure on, the coarsest first. `area` is that of T^0; the surface is at level 0
// afterwards. Linear in T^0.
inline std::deque<Measuring_level> measuring_levels(Progressive_mesh& pm, double area)
{
  std::deque<Measuring_level> levels;
  const std::size_t most = (pm.number_of_vertices() + pm.level()) / 3;
  for(std::size_t vertices = least_measuring_vertices; vertices < most; vertices *= measuring_factor)
  {
    const std::size_t level = pm.level_with(vertices);
    pm.go_to_level(level);
    if(pm.number_of_vertices() < most && std::abs(surface_area(pm) - area) <= greatest_difference_of_areas * area)
      levels.emplace_back(pm);
  }
  pm.go_to_level(0);
  return levels;
}

// The same for a surface at level 0.
inline std::deque<Measuring_level> measuring_levels(Progressive_mesh& pm)
{
  return measuring_levels(pm, surface_area(pm));
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_MEASURING_LEVEL_H
