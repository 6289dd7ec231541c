// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_PACKED_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_PACKED_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Seeds in a third of the memory: most are triangles, and there may be hundreds of thousands.
class Packed_seeds
{
public:
  Packed_seeds() = default;

  explicit Packed_seeds(const std::vector<Seed_curve>& seeds)
  {
    std::size_t vertices = 0;
    for(const Seed_curve& s : seeds)
      vertices += s.vertices.size();
    m_vertices.reserve(vertices);
    m_seeds.reserve(seeds.size());
    for(const Seed_curve& s : seeds)
    {
      m_vertices.insert(m_vertices.end(), s.vertices.begin(), s.vertices.end());
      m_seeds.push_back({static_cast<Index>(s.level), static_cast<Index>(s.vertices.size()), s.origin});
    }
  }

  std::vector<Seed_curve> unpacked() const
  {
    std::vector<Seed_curve> result;
    result.reserve(m_seeds.size());
    auto begin = m_vertices.begin();
    for(const Seed& s : m_seeds)
    {
      const auto end = begin + static_cast<std::ptrdiff_t>(s.size);
      result.push_back({s.level, std::vector<Index>(begin, end), s.origin});
      begin = end;
    }
    return result;
  }

private:
  struct Seed
  {
    Index level, size;
    Seed_origin origin;
  };

  std::vector<Seed> m_seeds;
  std::vector<Index> m_vertices; // of all, one after the other
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_PACKED_SEEDS_H
