// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_BORDER_ARRANGER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_BORDER_ARRANGER_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Where a border can run.
template <class TriangleMesh>
struct Border_courses
{
  typedef std::vector<typename Constriction<TriangleMesh>::Location> Course;

  bool is_closed;
  Course tight;  // empty if there is none
  double length; // of that
  Course old;    // empty if it is not to stay
};

// Puts borders into an arrangement: tight ones, first the closed, the foremost first, then the others, the shortest
// first; and, of those that cross one before them or have no tight course, the old courses that do not cross.
template <class TriangleMesh>
class Border_arranger
{
public:
  typedef Curve_arrangement<TriangleMesh> Arrangement;

  enum class Course
  {
    TIGHT,
    OLD,
    NONE
  };

  // rank(closed) puts the places of some closed borders into the order in which they are foremost. It is called only if
  // some cross. The cost is that of `Curve_arrangement::insert()`.
  template <class Rank>
  Border_arranger(const TriangleMesh& tm, const std::vector<Border_courses<TriangleMesh>>& borders, const Rank& rank)
    : m_borders(borders)
  {
    std::vector<std::size_t> closed, open;
    for(std::size_t i = 0; i < borders.size(); ++i)
      if(!borders[i].tight.empty())
        (borders[i].is_closed ? closed : open).push_back(i);
    std::stable_sort(open.begin(), open.end(),
                     [&](std::size_t i, std::size_t j) { return borders[i].length < borders[j].length; });
    reset(tm);
    if(!insert_tight(closed))
    {
      rank(closed);
      reset(tm);
      insert_tight(closed);
    }
    insert_tight(open);
    for(std::size_t i = 0; i < borders.size(); ++i)
      if(m_course[i] == Course::NONE && !borders[i].old.empty() &&
         !m_arrangement->insert(borders[i].old, i, borders[i].is_closed))
        m_course[i] = Course::OLD;
  }

  const Arrangement& arrangement() const { return *m_arrangement; }

  Course course(std::size_t border) const { return m_course[border]; }

  // the border that the tight course of one crosses, itself perhaps
  std::optional<std::size_t> crossed(std::size_t border) const { return m_crossed[border]; }

private:
  void reset(const TriangleMesh& tm)
  {
    m_arrangement = std::make_unique<Arrangement>(tm);
    m_course.assign(m_borders.size(), Course::NONE);
    m_crossed.assign(m_borders.size(), std::nullopt);
  }

  // Whether none crosses another one.
  bool insert_tight(const std::vector<std::size_t>& order)
  {
    bool are_apart = true;
    for(std::size_t i : order)
    {
      m_crossed[i] = m_arrangement->insert(m_borders[i].tight, i, m_borders[i].is_closed);
      if(!m_crossed[i])
        m_course[i] = Course::TIGHT;
      else
        are_apart = are_apart && *m_crossed[i] == i;
    }
    return are_apart;
  }

  const std::vector<Border_courses<TriangleMesh>>& m_borders;
  std::unique_ptr<Arrangement> m_arrangement;
  std::vector<Course> m_course;
  std::vector<std::optional<std::size_t>> m_crossed;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_BORDER_ARRANGER_H
