// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FIND_NESTED_CUTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FIND_NESTED_CUTS_H

#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Part_finder.h>

#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Parts that are united one by one.
class United_parts
{
public:
  explicit United_parts(std::size_t n) : m_size(n), m_united_with(n)
  {
    std::iota(m_united_with.begin(), m_united_with.end(), std::size_t(0));
  }

  // the number of those that are left
  std::size_t size() const { return m_size; }

  // the part that stands for all that a part is united with, the first of them
  std::size_t representative(std::size_t part)
  {
    while(m_united_with[part] != part)
      part = m_united_with[part] = m_united_with[m_united_with[part]];
    return part;
  }

  void unite(std::size_t a, std::size_t b)
  {
    a = representative(a);
    b = representative(b);
    if(a == b)
      return;
    m_united_with[a < b ? b : a] = a < b ? a : b;
    --m_size;
  }

private:
  std::size_t m_size;
  std::vector<std::size_t> m_united_with; // itself, or a lower number
};

// For each arranged curve, in their order, the number of parts from which on it cuts: curves are taken away from the
// last to the first, and the parts beside each are united. The number of parts that a curve cuts from on is that which
// it makes; a curve that makes none cuts from the number on that the next one makes, or, if none does, from the number
// of all parts on. Linear, but for the uniting of parts.
template <class TriangleMesh>
std::vector<Nested_cut> find_nested_cuts(const Curve_arrangement<TriangleMesh>& arrangement, const Part_finder& finder)
{
  const std::size_t n = arrangement.number_of_curves();
  std::unordered_map<std::size_t, std::size_t> place; // by the number of a curve
  for(std::size_t c = 0; c < n; ++c)
    place[arrangement.curve_number(c)] = c;
  std::vector<std::vector<Part_finder::Meeting>> meetings(n);
  for(const Part_finder::Meeting& m : finder.meetings())
    meetings[place.at(arrangement.curve_of_arc(m.arc))].push_back(m);

  std::vector<Nested_cut> result(n);
  United_parts parts(finder.size());
  std::size_t number_of_parts = parts.size();
  for(std::size_t c = n; c-- > 0;)
  {
    const std::size_t with_curve = parts.size();
    for(const Part_finder::Meeting& m : meetings[c])
      parts.unite(m.parts[0], m.parts[1]);
    if(parts.size() < with_curve)
      number_of_parts = with_curve;
    result[c] = {arrangement.curve_number(c), number_of_parts};
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FIND_NESTED_CUTS_H
