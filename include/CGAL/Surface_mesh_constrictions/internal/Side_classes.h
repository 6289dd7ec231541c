// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIDE_CLASSES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIDE_CLASSES_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Numbers sets of curves. Two places of a surface are in the same class if they lie on the same side of each curve; a
// class is given by the curves that lie between it and class 0.
class Side_classes
{
public:
  Side_classes() { restart(); }

  void restart()
  {
    m_numbers.clear();
    m_sets.assign(1, {});
    m_hashes.assign(1, 0);
    m_numbers.emplace(0, 0);
  }

  std::size_t size() const { return m_sets.size(); }

  const std::vector<Index>& curves(Index c) const { return m_sets[c]; }

  bool is_beyond(Index c, Index curve) const
  {
    return std::binary_search(m_sets[c].begin(), m_sets[c].end(), curve);
  }

  // Stands for the curves that lie between two classes: the same for the same curves.
  std::uint64_t difference(Index c, Index d) const { return m_hashes[c] ^ m_hashes[d]; }

  // The curves that lie between some of these classes.
  std::vector<Index> curves_between(const std::vector<Index>& classes) const
  {
    std::vector<Index> any, all, result;
    for(Index c : classes)
    {
      std::vector<Index> u, i;
      std::set_union(any.begin(), any.end(), m_sets[c].begin(), m_sets[c].end(), std::back_inserter(u));
      std::set_intersection(all.begin(), all.end(), m_sets[c].begin(), m_sets[c].end(), std::back_inserter(i));
      any.swap(u);
      all = c == classes.front() ? m_sets[c] : i;
    }
    std::set_difference(any.begin(), any.end(), all.begin(), all.end(), std::back_inserter(result));
    return result;
  }

  // The class on the other side of these curves, in ascending order. Linear in their number, but for new classes.
  Index across(Index c, const std::vector<Index>& curves)
  {
    if(curves.empty())
      return c;
    std::uint64_t hash = m_hashes[c];
    for(Index a : curves)
      hash ^= hash_of_curve(a);
    const auto inserted = m_numbers.emplace(hash, static_cast<Index>(m_sets.size()));
    if(inserted.second)
    {
      std::vector<Index> set;
      std::set_symmetric_difference(m_sets[c].begin(), m_sets[c].end(), curves.begin(), curves.end(),
                                    std::back_inserter(set));
      m_sets.push_back(std::move(set));
      m_hashes.push_back(hash);
    }
    return inserted.first->second;
  }

private:
  // A number as if drawn by lot, so that the sum modulo 2 of those of a set stands for the set (Zobrist).
  static std::uint64_t hash_of_curve(Index curve) // the finaliser of splitmix64
  {
    std::uint64_t x = (curve + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  std::unordered_map<std::uint64_t, Index> m_numbers; // by the hash of a set
  std::vector<std::uint64_t> m_hashes;
  std::vector<std::vector<Index> > m_sets;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIDE_CLASSES_H
