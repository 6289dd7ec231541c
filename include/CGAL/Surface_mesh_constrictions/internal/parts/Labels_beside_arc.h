// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABELS_BESIDE_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABELS_BESIDE_ARC_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The labels that borders along one piece of a curve name on its two sides. Between borders that lie on each other
// nothing is left: a label that some name on the left and others on the right is not there.
template <class Label>
class Labels_beside_arc
{
public:
  void add(const Label& left, const Label& right)
  {
    if(!take(m_right, left))
      m_left.push_back(left);
    if(!take(m_left, right))
      m_right.push_back(right);
  }

  // whether the same label, whichever it is, is on both sides
  bool is_no_border() const { return m_left.empty() && m_right.empty(); }

  // whether each side has one label
  bool is_clear() const { return m_left.size() == 1 && m_right.size() == 1; }

  // of a clear one
  const Label& left() const { return m_left.front(); }
  const Label& right() const { return m_right.front(); }

  // whether these are still there
  bool has(const Label& left, const Label& right) const
  {
    return std::find(m_left.begin(), m_left.end(), left) != m_left.end() &&
           std::find(m_right.begin(), m_right.end(), right) != m_right.end();
  }

private:
  static bool take(std::vector<Label>& labels, const Label& label)
  {
    const auto found = std::find(labels.begin(), labels.end(), label);
    if(found == labels.end())
      return false;
    labels.erase(found);
    return true;
  }

  std::vector<Label> m_left, m_right;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABELS_BESIDE_ARC_H
