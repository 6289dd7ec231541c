// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_VERTEX_CLASSES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_VERTEX_CLASSES_H

#include <CGAL/Surface_mesh_constrictions/internal/prominence/Side_classes.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The classes of vertices with respect to some curves. Restarted in constant time, but for new curves.
class Vertex_classes
{
public:
  explicit Vertex_classes(std::size_t number_of_vertices) : m_class(number_of_vertices), m_sweep_of(number_of_vertices)
  {}

  void restart(std::size_t number_of_curves)
  {
    ++m_sweep;
    m_classes.restart(number_of_curves);
    m_wrong_in.resize(number_of_curves, 0);
    m_compared.clear();
  }

  const Side_classes& classes() const { return m_classes; }

  bool has(Index v) const { return m_sweep_of[v] == m_sweep; }
  Index operator[](Index v) const { return m_class[v]; }

  void set(Index v, Index c)
  {
    if(has(v))
      compare(m_class[v], c);
    m_class[v] = c;
    m_sweep_of[v] = m_sweep;
  }

  // Sets the class of a vertex that these curves part from another one.
  void set_across(Index v, Index other, const std::vector<Index>& curves)
  {
    set(v, m_classes.across(m_class[other], curves));
  }

  // Checks whether these curves, and no others, part two vertices.
  void check_across(Index v, Index other, const std::vector<Index>& curves)
  {
    if(m_class[v] != m_class[other] || !curves.empty())
      compare(m_class[v], m_classes.across(m_class[other], curves));
  }

  // whether all ways to the same vertex were found to cross a curve equally often, but for a multiple of two
  bool is_consistent(Index curve) const { return m_wrong_in[curve] != m_sweep; }

private:
  void compare(Index c, Index d)
  {
    if(c == d)
      return;
    if(!m_compared.insert(m_classes.difference(c, d)).second)
      return;
    for_each_curve(m_classes.curves(c) ^ m_classes.curves(d), [&](Index a) { m_wrong_in[a] = m_sweep; });
  }

  Side_classes m_classes;
  Zeroed_array<Index> m_class;                  // of a vertex
  Zeroed_array<Index> m_sweep_of;               // the sweep that this was in
  std::vector<Index> m_wrong_in;                // of a curve: the last sweep in which it was found to be inconsistent
  std::unordered_set<std::uint64_t> m_compared; // differences of classes that have been looked at
  Index m_sweep = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_VERTEX_CLASSES_H
