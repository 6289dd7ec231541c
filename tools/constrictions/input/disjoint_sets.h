// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_DISJOINT_SETS_H
#define CONSTRICTIONS_DISJOINT_SETS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace constrictions {

/// Sets of numbers, each of which is named by its smallest one.
class Disjoint_sets
{
public:
  typedef CGAL::Surface_mesh_constrictions::Index Index;

  explicit Disjoint_sets(std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), Index(0)); }

  Index find(Index i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  /// returns whether they were two sets
  bool unite(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    if(a == b)
      return false;
    if(b < a)
      std::swap(a, b);
    m_parent[b] = a;
    return true;
  }

private:
  std::vector<Index> m_parent;
};

} // namespace constrictions

#endif // CONSTRICTIONS_DISJOINT_SETS_H
