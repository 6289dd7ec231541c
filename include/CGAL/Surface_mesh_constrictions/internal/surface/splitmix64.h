// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SPLITMIX64_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SPLITMIX64_H

#include <cstdint>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A number as if drawn by lot for each x: a sum of those of a set, or a sum modulo 2, stands for the set (Zobrist).
// What the generator splitmix64 draws from the state x (Steele, Lea and Flood 2014).
inline std::uint64_t splitmix64(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SPLITMIX64_H
