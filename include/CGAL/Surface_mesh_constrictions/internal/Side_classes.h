// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIDE_CLASSES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIDE_CLASSES_H

#include <CGAL/Surface_mesh_constrictions/internal/Curve_crossings.h>

#include <algorithm>
#include <iterator>
#include <map>
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
  Side_classes() { restart(0); }

  // Only curves with numbers below `end` count.
  void restart(Index end)
  {
    m_end = end;
    m_numbers.clear();
    m_sets.assign(1, {});
    m_numbers.emplace(m_sets[0], 0);
  }

  Index end() const { return m_end; }

  std::size_t size() const { return m_sets.size(); }

  const std::vector<Index>& curves(Index c) const { return m_sets[c]; }

  bool is_beyond(Index c, Index curve) const
  {
    return std::binary_search(m_sets[c].begin(), m_sets[c].end(), curve);
  }

  // The class on the other side of these curves. Constant if none of them counts.
  Index across(Index c, const Curve_crossings::Range& curves)
  {
    if(curves.empty() || *curves.begin() >= m_end)
      return c;
    std::vector<Index> set;
    const Index* const last = std::lower_bound(curves.begin(), curves.end(), m_end);
    std::set_symmetric_difference(m_sets[c].begin(), m_sets[c].end(), curves.begin(), last, std::back_inserter(set));
    const auto inserted = m_numbers.emplace(std::move(set), static_cast<Index>(m_sets.size()));
    if(inserted.second)
      m_sets.push_back(inserted.first->first);
    return inserted.first->second;
  }

private:
  Index m_end = 0;
  std::map<std::vector<Index>, Index> m_numbers;
  std::vector<std::vector<Index> > m_sets;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIDE_CLASSES_H
