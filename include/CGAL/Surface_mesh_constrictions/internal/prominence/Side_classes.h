// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SIDE_CLASSES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SIDE_CLASSES_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/splitmix64.h>

#include <boost/dynamic_bitset.hpp>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Numbers sets of curves. Two places of a surface are in the same class if they lie on the same side of each curve; a
// class is given by the curves that lie between it and class 0.
class Side_classes
{
public:
  typedef boost::dynamic_bitset<> Curves; // a set

  Side_classes() { restart(0); }

  void restart(std::size_t number_of_curves)
  {
    m_numbers.clear();
    m_sets.assign(1, Curves(number_of_curves));
    m_hashes.assign(1, 0);
    m_numbers.emplace(0, 0);
  }

  const Curves& curves(Index c) const { return m_sets[c]; }

  bool is_beyond(Index c, Index curve) const { return m_sets[c].test(curve); }

  // Stands for the curves that lie between two classes: the same for the same curves.
  std::uint64_t difference(Index c, Index d) const { return m_hashes[c] ^ m_hashes[d]; }

  // The curves that lie between some of these classes, one at least.
  Curves curves_between(const std::vector<Index>& classes) const
  {
    Curves any = m_sets[classes.front()], all = any;
    for(Index c : classes)
    {
      any |= m_sets[c];
      all &= m_sets[c];
    }
    return any - all;
  }

  // The class on the other side of these curves. Linear in their number; for a new class in that of all curves.
  Index across(Index c, const std::vector<Index>& curves)
  {
    if(curves.empty())
      return c;
    std::uint64_t hash = m_hashes[c];
    for(Index a : curves)
      hash ^= splitmix64(a);
    const auto inserted = m_numbers.emplace(hash, static_cast<Index>(m_sets.size()));
    if(inserted.second)
    {
      m_sets.push_back(m_sets[c]);
      for(Index a : curves)
        m_sets.back().flip(a);
      m_hashes.push_back(hash);
    }
    return inserted.first->second;
  }

private:
  std::unordered_map<std::uint64_t, Index> m_numbers; // by the hash of a set
  std::vector<std::uint64_t> m_hashes;
  std::vector<Curves> m_sets;
};

// Calls f for each curve of a set, in ascending order.
template <class Function>
void for_each_curve(const Side_classes::Curves& curves, const Function& f)
{
  for(std::size_t a = curves.find_first(); a != Side_classes::Curves::npos; a = curves.find_next(a))
    f(static_cast<Index>(a));
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SIDE_CLASSES_H
