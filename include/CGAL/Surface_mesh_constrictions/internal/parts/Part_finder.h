// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_PART_FINDER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_PART_FINDER_H

#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Cut_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The connected parts of a surface that is cut along curves. They are numbered by their first cells. Ghosts belong to
// none.
class Part_finder
{
  typedef Cut_surface::Vector Vector;

public:
  static constexpr std::size_t none = Cut_surface::none;

  // Linear, as everything below.
  explicit Part_finder(const Cut_surface& surface) : m_surface(surface), m_part(surface.face_of_cell.size(), none)
  {
    std::vector<std::size_t> side_of_cell(m_part.size());
    for(std::size_t s = 0; s < surface.sides.size(); ++s)
      side_of_cell[surface.sides[s].cell] = s;
    std::vector<std::size_t> stack;
    for(std::size_t cell = 0; cell < m_part.size(); ++cell)
    {
      if(m_part[cell] != none || surface.is_ghost(cell))
        continue;
      m_part[cell] = m_size++;
      stack.push_back(cell);
      while(!stack.empty())
      {
        const std::size_t first = side_of_cell[stack.back()];
        stack.pop_back();
        std::size_t s = first;
        do
        {
          const std::size_t beyond = surface.sides[surface.sides[s].opposite].cell;
          if(surface.sides[s].arc == none && m_part[beyond] == none)
          {
            m_part[beyond] = m_part[cell];
            stack.push_back(beyond);
          }
          s = surface.sides[s].next;
        } while(s != first);
      }
    }
  }

  std::size_t size() const { return m_size; }

  // none of a ghost
  std::size_t part_of_cell(std::size_t cell) const { return m_part[cell]; }

  // the part that a side bounds; none of a ghost's
  std::size_t part_of_side(std::size_t s) const { return m_part[m_surface.sides[s].cell]; }

  double length(std::size_t s) const
  {
    return std::sqrt((m_surface.points[end(s)] - m_surface.points[m_surface.sides[s].vertex]).squared_length());
  }

  // For each face of the mesh the part with the greatest share of its area, the first of equal ones.
  std::vector<std::size_t> parts_of_faces() const
  {
    std::vector<std::size_t> part_of_face;
    std::map<std::size_t, std::map<std::size_t, double>> shares; // of faces with several pieces
    for(std::size_t cell = 0; cell < m_part.size(); ++cell)
    {
      const std::size_t f = m_surface.face_of_cell[cell];
      if(m_surface.is_ghost(cell))
        continue;
      if(f == part_of_face.size())
      {
        part_of_face.push_back(m_part[cell]);
        continue;
      }
      std::map<std::size_t, double>& s = shares[f];
      if(s.empty()) // the first piece of a face has its number
        s[m_part[f]] = m_surface.area_of_cell[f];
      s[m_part[cell]] += m_surface.area_of_cell[cell];
    }
    for(const auto& [f, s] : shares)
    {
      double greatest = -1;
      for(const auto& [part, area] : s)
        if(area > greatest)
        {
          greatest = area;
          part_of_face[f] = part;
        }
    }
    return part_of_face;
  }

  // Everything but the numbers of faces.
  std::vector<Surface_part> parts() const
  {
    std::vector<Surface_part> result(m_size, Surface_part{0, 0, 0, 0, 0});
    const std::vector<long> euler_characteristic = euler_characteristics();
    for(std::size_t cell = 0; cell < m_part.size(); ++cell)
      if(!m_surface.is_ghost(cell))
        result[m_part[cell]].area += m_surface.area_of_cell[cell];
    add_volumes(result);
    close_boundaries(result);
    for(std::size_t p = 0; p < m_size; ++p)
      result[p].genus = static_cast<std::size_t>(
          (2 - euler_characteristic[p] - static_cast<long>(result[p].number_of_boundaries)) / 2);
    return result;
  }

  // Two parts on the left and on the right of a piece of an arc.
  struct Meeting
  {
    std::size_t arc;
    std::array<std::size_t, 2> parts;
    double length;
  };

  std::vector<Meeting> meetings() const
  {
    std::vector<Meeting> result;
    for(std::size_t s = 0; s < m_surface.sides.size(); ++s)
    {
      const Cut_surface::Side& side = m_surface.sides[s];
      if(m_surface.is_on_curve(s) && side.is_forward && part_of_side(s) != none && part_of_side(side.opposite) != none)
        result.push_back({side.arc, {{part_of_side(s), part_of_side(side.opposite)}}, length(s)});
    }
    return result;
  }

private:
  std::size_t end(std::size_t s) const { return m_surface.sides[m_surface.sides[s].opposite].vertex; }

  // Of the parts without their boundaries: a circle counts nothing.
  std::vector<long> euler_characteristics() const
  {
    std::vector<long> twice(m_size, 0);
    std::vector<bool> is_counted(m_surface.points.size(), false);
    for(const Cut_surface::Side& side : m_surface.sides)
      if(side.arc != none)
        is_counted[side.vertex] = true;
    for(std::size_t s = 0; s < m_surface.sides.size(); ++s)
    {
      const Cut_surface::Side& side = m_surface.sides[s];
      if(part_of_side(s) == none)
        continue;
      if(side.arc == none)
        --twice[part_of_side(s)];
      if(!is_counted[side.vertex])
        twice[part_of_side(s)] += 2;
      is_counted[side.vertex] = true;
    }
    for(std::size_t p : m_part)
      if(p != none)
        twice[p] += 2;
    for(long& x : twice)
      x /= 2;
    return twice;
  }

  static double volume(const Vector& p, const Vector& q, const Vector& r) { return CGAL::determinant(p, q, r) / 6; }

  // Of the cones from the origin.
  void add_volumes(std::vector<Surface_part>& result) const
  {
    std::vector<std::size_t> apex(m_part.size(), none); // of a cell: a vertex
    for(std::size_t s = 0; s < m_surface.sides.size(); ++s)
    {
      const Cut_surface::Side& side = m_surface.sides[s];
      if(part_of_side(s) == none)
        continue;
      if(apex[side.cell] == none)
        apex[side.cell] = side.vertex;
      if(side.vertex != apex[side.cell] && end(s) != apex[side.cell])
        result[m_part[side.cell]].volume +=
            volume(m_surface.points[apex[side.cell]], m_surface.points[side.vertex], m_surface.points[end(s)]);
    }
  }

  // For each vertex a vertex that stands for all that arcs connect with it; itself if there are none.
  std::vector<std::size_t> clusters_of_vertices() const
  {
    std::vector<std::size_t> cluster(m_surface.points.size());
    std::iota(cluster.begin(), cluster.end(), std::size_t(0));
    const auto find = [&cluster](std::size_t v) {
      while(cluster[v] != v)
        v = cluster[v] = cluster[cluster[v]];
      return v;
    };
    for(std::size_t s = 0; s < m_surface.sides.size(); ++s)
      if(m_surface.sides[s].arc != none)
        cluster[find(m_surface.sides[s].vertex)] = find(end(s));
    for(std::size_t v = 0; v < cluster.size(); ++v)
      cluster[v] = find(v);
    return cluster;
  }

  // Counts the boundary curves and adds the volumes of the cones over them. Curves that touch each other have the same
  // apex, their common centre of mass, so that the cones on the two sides of each piece cancel, wherever else the
  // boundary curves run.
  void close_boundaries(std::vector<Surface_part>& result) const
  {
    struct Weighted
    {
      Vector moment = NULL_VECTOR;
      double length = 0;
    };
    const std::vector<std::size_t> cluster = clusters_of_vertices();
    std::map<std::size_t, Weighted> centres;
    for(std::size_t s = 0; s < m_surface.sides.size(); ++s)
      if(m_surface.sides[s].arc != none)
      {
        Weighted& c = centres[cluster[end(s)]];
        c.moment = c.moment + length(s) / 2 * (m_surface.points[m_surface.sides[s].vertex] + m_surface.points[end(s)]);
        c.length += length(s);
      }

    std::vector<bool> is_seen(m_surface.sides.size(), false);
    for(std::size_t first = 0; first < m_surface.sides.size(); ++first)
    {
      if(m_surface.sides[first].arc == none || is_seen[first] || part_of_side(first) == none)
        continue;
      const Weighted& c = centres.at(cluster[end(first)]);
      const Vector centre = c.length > 0 ? c.moment / c.length : m_surface.points[m_surface.sides[first].vertex];
      Surface_part& part = result[part_of_side(first)];
      ++part.number_of_boundaries;
      std::size_t s = first;
      do
      {
        is_seen[s] = true;
        part.volume += volume(m_surface.points[end(s)], m_surface.points[m_surface.sides[s].vertex], centre);
        s = m_surface.sides[s].next;
        while(m_surface.sides[s].arc == none)
          s = m_surface.sides[m_surface.sides[s].opposite].next;
      } while(s != first);
    }
  }

  const Cut_surface& m_surface;
  std::vector<std::size_t> m_part; // of a cell
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_PART_FINDER_H
