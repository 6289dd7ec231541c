// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SURFACE_CYCLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SURFACE_CYCLES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Answers for closed curves what they bound, in time that depends on the curve alone.
//
// A spanning tree of the vertices, and one of the faces that crosses none of its edges, leave 2g edges of each
// component of genus g (tree-cotree decomposition, Eppstein, "Dynamic generators of topologically embedded graphs",
// 2003). Each of these closes a cycle of faces through the tree of faces, and the cycles are a basis of the first
// homology group. How often a path crosses each of them, modulo 2, is its homology class; a path bounds if and only if
// all are even. The holes of a surface with boundary are filled, and what fills them has no area.
class Surface_cycles
{
public:
  // Linear.
  explicit Surface_cycles(const Progressive_mesh& pm)
    : m_pm(pm), m_to_parent(pm.number_of_face_ids(), null_index), m_first(pm.number_of_face_ids(), 0),
      m_end(pm.number_of_face_ids(), 0), m_number_of_vertices(pm.number_of_face_ids(), 0)
  {
    std::vector<bool> is_in_tree(pm.number_of_halfedge_ids(), false); // by edge
    span_vertices(is_in_tree);
    span_faces(is_in_tree);
    for(Index h = 0; h < pm.number_of_halfedge_ids(); ++h)
      if(pm.is_face(pm.face(h)) && pm.edge(h) == h && !is_in_tree[h])
        m_left_over.push_back(h);
  }

  // the area of the component that a face belongs to
  double area_of_component(Index f) const { return area_of_subtree(component(f)); }

  // The area of what would fill the holes of the component that a face belongs to, flat.
  double hole_area_of_component(Index f) const { return hole_area_of_subtree(component(f)); }

  // a face that stands for the component that a face belongs to
  Index component(Index f) const
  {
    return *(std::upper_bound(m_roots.begin(), m_roots.end(), m_first[f],
                              [this](Index first, Index root) { return first < m_first[root]; }) -
             1);
  }

  // The basis cycles that a closed path of vertices crosses an odd number of times, ascending. Consecutive vertices may
  // be equal. O((k + g) log k) for k edges and genus g.
  std::vector<Index> homology_class(const std::vector<Index>& path) const
  {
    std::vector<Index> result;
    if(m_left_over.empty())
      return result;
    std::vector<Index> bounds; // of the intervals of faces beyond the edges of the path
    std::vector<Index> own;
    for_each_edge(path, [&](Index h) {
      const Index child = child_across(h);
      if(child != null_index)
      {
        bounds.push_back(m_first[child]);
        bounds.push_back(m_end[child]);
      }
      const auto it = std::lower_bound(m_left_over.begin(), m_left_over.end(), m_pm.edge(h));
      if(it != m_left_over.end() && *it == m_pm.edge(h))
        own.push_back(static_cast<Index>(it - m_left_over.begin()));
    });
    std::sort(bounds.begin(), bounds.end());
    std::vector<bool> is_odd(m_left_over.size(), false);
    for(Index i : own)
      is_odd[i] = !is_odd[i];
    const auto number_before = [&](Index f) {
      return std::upper_bound(bounds.begin(), bounds.end(), m_first[f]) - bounds.begin();
    };
    for(Index i = 0; i < m_left_over.size(); ++i)
    {
      const Index h = m_left_over[i];
      if((number_before(m_pm.face(h)) + number_before(m_pm.face(m_pm.opposite(h)))) % 2 != 0)
        is_odd[i] = !is_odd[i];
      if(is_odd[i])
        result.push_back(i);
    }
    return result;
  }

  // For a closed path that bounds, and an area of which only rounding keeps a multiple of the area of the component
  // away: whether the path leaves no face of the surface on its left but at most ghosts, and some of these. Then it has
  // no area there, and else all. Linear in the path.
  bool has_only_ghosts_on_left(const std::vector<Index>& path) const
  {
    long faces = 0, ghosts = 0;
    for_each_subtree_beside(path, [&](Index f, int sign) {
      ghosts += sign * ghosts_of_subtree(f);
      faces += sign * (subtree(f).faces - ghosts_of_subtree(f));
    });
    const Index root = component(m_pm.face(m_pm.outgoing(path[0])));
    const long all_ghosts = ghosts_of_subtree(root), all_faces = subtree(root).faces - all_ghosts;
    const long turns = faces >= 0 ? faces / all_faces : -((all_faces - 1 - faces) / all_faces);
    faces -= turns * all_faces;
    return faces == 0 ? ghosts - turns * all_ghosts > 0 : 2 * faces < all_faces;
  }

  // The area on the left of a closed path that bounds, up to multiples of the area of the component. Linear in the
  // path.
  double area_on_left(const std::vector<Index>& path) const
  {
    double sum = 0;
    for_each_subtree_beside(path, [&](Index f, int sign) { sum += sign * area_of_subtree(f); });
    return sum;
  }

  // Whether a simple closed path that bounds has a face of its component on its left. The sum of the subtrees beside
  // the path counts the faces on the left once more often than those on the right. Linear in the path.
  bool is_on_left(const std::vector<Index>& path, Index f) const
  {
    double sum = 0;
    long often = 0;
    for_each_subtree_beside(path, [&](Index top, int sign) {
      sum += sign * area_of_subtree(top);
      often += m_first[top] <= m_first[f] && m_first[f] < m_end[top] ? sign : 0;
    });
    return sum < static_cast<double>(often) * area_of_component(f);
  }

  // As `area_on_left()`, of what would fill the holes.
  double hole_area_on_left(const std::vector<Index>& path) const
  {
    double sum = 0;
    if(m_pm.has_boundary())
      for_each_subtree_beside(path, [&](Index f, int sign) { sum += sign * hole_area_of_subtree(f); });
    return sum;
  }

  // The bounds of the intervals of faces beyond the edges of a closed path, ascending. O(k log k) for k edges.
  std::vector<Index> bounds(const std::vector<Index>& path) const
  {
    std::vector<Index> result;
    for_each_edge(path, [&](Index h) {
      const Index child = child_across(h);
      if(child == null_index)
        return;
      result.push_back(m_first[child]);
      result.push_back(m_end[child]);
    });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Of two closed paths with these bounds, of the component with a face `f`, that bound together, modulo 2: the area of
  // what has an odd number of them between itself and the rest, or of that rest, the lesser of the two. Linear.
  double area_between(Index f, const std::vector<Index>& bounds, const std::vector<Index>& other) const
  {
    double sum = 0;
    Index begin = 0; // of the interval that is open
    bool is_open = false;
    for(auto i = bounds.begin(), j = other.begin(); i != bounds.end() || j != other.end();)
    {
      const Index bound = j == other.end() || (i != bounds.end() && *i < *j) ? *i++ : *j++;
      if(is_open)
        sum += m_area_before[bound] - m_area_before[begin];
      begin = bound;
      is_open = !is_open;
    }
    return (std::max)((std::min)(sum, area_of_component(f) - sum), 0.0);
  }

  // The genera of what a simple closed curve that bounds has on its left and on its right. The curve passes no vertex
  // and is given by the halfedges that it crosses, their targets on its left. Linear in their number.
  //
  // The Euler characteristic of what is on the left is V - F / 2, with V its vertices and F the faces whose middle it
  // has: an edge with m crossings has (m + the number of its ends on the left) / 2 pieces there, and a face with m
  // strands, each of which cuts off a corner, (m + the number of its corners on the left - [its middle is]) / 2.
  std::array<std::size_t, 2> genera(const std::vector<Index>& crossings) const
  {
    // Moved to its left, to the next vertices, the curve leaves a middle on its right where it cuts off a corner on the
    // right. A vertex counts as its face's middle does, but for the strands between the two.
    std::vector<Index> path;
    for(Index h : crossings)
      path.push_back(m_pm.target(h));
    Numbers left;
    for_each_subtree_beside(path, [&](Index f, int sign) { left.add(subtree(f), sign); });
    for(std::size_t i = 0; i < crossings.size(); ++i)
    {
      const Index h = crossings[i], next = crossings[(i + 1) % crossings.size()], f = m_pm.face(next);
      const bool is_corner_on_left = m_pm.target(h) == m_pm.target(next);
      const Index corner = is_corner_on_left ? m_pm.target(h) : m_pm.source(h);
      const bool belongs_to_face = face_of_vertex(corner) == f;
      if(is_corner_on_left)
        left.add({0, belongs_to_face}, 1);
      else
      {
        left.add(own(f), 1);
        left.add({0, belongs_to_face}, -1);
      }
    }
    // Neither side is without a vertex and the middle of a face, so the multiples of the whole are told.
    const Numbers whole = subtree(component(m_pm.face(crossings.front())));
    while(left.faces < 0 || (left.faces == 0 && left.vertices <= 0))
      left.add(whole, 1);
    while(left.faces > whole.faces || (left.faces == whole.faces && left.vertices >= whole.vertices))
      left.add(whole, -1);
    const auto genus = [](const Numbers& side) {
      return static_cast<std::size_t>((2 - 2 * side.vertices + side.faces) / 4);
    };
    return {{genus(left), genus({whole.faces - left.faces, whole.vertices - left.vertices})}};
  }

  // the genus of the component that a face belongs to
  std::size_t genus_of_component(Index f) const
  {
    const Numbers whole = subtree(component(f));
    return static_cast<std::size_t>((4 - 2 * whole.vertices + whole.faces) / 4);
  }

private:
  // Of faces, and of the vertices that belong to them.
  struct Numbers
  {
    long faces = 0, vertices = 0;

    void add(const Numbers& other, long factor)
    {
      faces += factor * other.faces;
      vertices += factor * other.vertices;
    }
  };

  // The one of its faces that a vertex belongs to.
  Index face_of_vertex(Index v) const { return m_pm.face(m_pm.outgoing(v)); }

  Numbers own(Index f) const
  {
    Numbers result = {1, 0};
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      result.vertices += face_of_vertex(m_pm.source(h)) == f;
    return result;
  }

  Numbers subtree(Index f) const
  {
    return {static_cast<long>(m_end[f]) - static_cast<long>(m_first[f]), static_cast<long>(m_number_of_vertices[f])};
  }

  double area_of_subtree(Index f) const { return m_area_before[m_end[f]] - m_area_before[m_first[f]]; }

  long ghosts_of_subtree(Index f) const
  {
    return m_ghosts_before.empty()
               ? 0
               : static_cast<long>(m_ghosts_before[m_end[f]]) - static_cast<long>(m_ghosts_before[m_first[f]]);
  }

  double hole_area_of_subtree(Index f) const
  {
    return m_hole_area_before.empty() ? 0 : m_hole_area_before[m_end[f]] - m_hole_area_before[m_first[f]];
  }

  // By hole, the length of the area vector of its boundary, in equal shares of its ghost faces: that is the area of a
  // flat hole, and of one whose boundary is jagged about that of a sheet across it.
  std::vector<double> hole_area_per_ghost() const
  {
    const std::size_t n = m_pm.number_of_holes(), first = m_pm.number_of_vertex_ids() - n;
    std::vector<Vector3> sum(n, Vector3{0, 0, 0});
    std::vector<std::size_t> ghosts(n, 0);
    std::vector<Index> origin(n, null_index);
    for(Index f = 0; f < m_pm.number_of_face_ids(); ++f)
    {
      if(!m_pm.is_face(f) || !m_pm.is_ghost_face(f))
        continue;
      Index h = 3 * f;
      while(!m_pm.is_ghost_vertex(m_pm.source(h)))
        ++h;
      const Index from = m_pm.target(h), to = m_pm.source(m_pm.prev(h));
      const std::size_t hole = m_pm.source(h) - first;
      if(origin[hole] == null_index)
        origin[hole] = from;
      const auto& o = m_pm.point(origin[hole]);
      sum[hole] = sum[hole] + cross(vector(o, m_pm.point(from)), vector(o, m_pm.point(to)));
      ++ghosts[hole];
    }
    std::vector<double> result(n, 0);
    for(std::size_t i = 0; i < n; ++i)
      if(ghosts[i] > 0)
        result[i] = norm(sum[i]) / 2 / static_cast<double>(ghosts[i]);
    return result;
  }

  // The subtrees of faces that a path turns off, and 1 or -1 for whether their top is on its left or on its right.
  template <class F>
  void for_each_subtree_beside(const std::vector<Index>& path, const F& f) const
  {
    for_each_edge(path, [&](Index h) {
      if(m_to_parent[m_pm.face(h)] == h)
        f(m_pm.face(h), 1);
      else if(m_to_parent[m_pm.face(m_pm.opposite(h))] == m_pm.opposite(h))
        f(m_pm.face(m_pm.opposite(h)), -1);
    });
  }

  template <class F>
  void for_each_edge(const std::vector<Index>& path, const F& f) const
  {
    for(std::size_t i = 0; i < path.size(); ++i)
      if(path[i] != path[(i + 1) % path.size()])
        f(m_pm.halfedge(path[i], path[(i + 1) % path.size()]));
  }

  // The face whose way to the root of its tree leads across an edge, or `null_index`.
  Index child_across(Index h) const
  {
    for(Index k : {h, m_pm.opposite(h)})
      if(m_to_parent[m_pm.face(k)] == k)
        return m_pm.face(k);
    return null_index;
  }

  void span_vertices(std::vector<bool>& is_in_tree) const
  {
    std::vector<bool> is_reached(m_pm.number_of_vertex_ids(), false);
    std::vector<Index> queue;
    for(Index root = 0; root < m_pm.number_of_vertex_ids(); ++root)
    {
      if(!m_pm.is_vertex(root) || is_reached[root])
        continue;
      is_reached[root] = true;
      queue.assign(1, root);
      for(std::size_t i = 0; i < queue.size(); ++i)
      {
        const Index begin = m_pm.outgoing(queue[i]);
        Index h = begin;
        do
        {
          const Index v = m_pm.target(h);
          if(!is_reached[v])
          {
            is_reached[v] = true;
            is_in_tree[m_pm.edge(h)] = true;
            queue.push_back(v);
          }
          h = m_pm.ccw(h);
        } while(h != begin);
      }
    }
  }

  // Numbers the faces such that those of a subtree are consecutive, and adds up vertices towards the roots.
  void span_faces(std::vector<bool>& is_in_tree)
  {
    std::vector<Index> order, stack;
    std::vector<bool> is_reached(m_pm.number_of_face_ids(), false);
    for(Index root = 0; root < m_pm.number_of_face_ids(); ++root)
    {
      if(!m_pm.is_face(root) || is_reached[root])
        continue;
      const std::size_t begin = order.size();
      is_reached[root] = true;
      m_roots.push_back(root);
      stack.assign(1, root);
      while(!stack.empty())
      {
        const Index f = stack.back();
        stack.pop_back();
        m_first[f] = static_cast<Index>(order.size());
        m_end[f] = m_first[f] + 1;
        m_number_of_vertices[f] = static_cast<Index>(own(f).vertices);
        order.push_back(f);
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
        {
          const Index o = m_pm.opposite(h), g = m_pm.face(o);
          if(is_in_tree[m_pm.edge(h)] || is_reached[g])
            continue;
          is_reached[g] = true;
          m_to_parent[g] = o;
          is_in_tree[m_pm.edge(h)] = true;
          stack.push_back(g);
        }
      }
      for(std::size_t i = order.size(); i-- > begin + 1;)
      {
        const Index f = order[i], parent = m_pm.face(m_pm.opposite(m_to_parent[f]));
        m_end[parent] = (std::max)(m_end[parent], m_end[f]);
        m_number_of_vertices[parent] += m_number_of_vertices[f];
      }
    }
    m_area_before.reserve(order.size() + 1);
    m_area_before.push_back(0);
    for(Index f : order)
      m_area_before.push_back(m_area_before.back() + face_area(m_pm, f));
    if(!m_pm.has_boundary())
      return;
    m_ghosts_before.assign(1, 0);
    for(Index f : order)
      m_ghosts_before.push_back(m_ghosts_before.back() + (m_pm.is_ghost_face(f) ? 1 : 0));
    const std::vector<double> share = hole_area_per_ghost();
    m_hole_area_before.assign(1, 0);
    for(Index f : order)
    {
      double area = 0;
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(m_pm.is_ghost_vertex(m_pm.source(h)))
          area = share[m_pm.source(h) - (m_pm.number_of_vertex_ids() - share.size())];
      m_hole_area_before.push_back(m_hole_area_before.back() + area);
    }
  }

  static double face_area(const Progressive_mesh& pm, Index f)
  {
    if(pm.is_ghost_face(f))
      return 0;
    const auto& p = pm.point(pm.source(3 * f));
    return norm(cross(vector(p, pm.point(pm.source(3 * f + 1))), vector(p, pm.point(pm.source(3 * f + 2))))) / 2;
  }

  const Progressive_mesh& m_pm;
  std::vector<Index> m_to_parent;          // of a face: its halfedge to the next face on the way to its root
  std::vector<Index> m_first, m_end;       // of a face: the numbers of the faces of its subtree
  std::vector<Index> m_roots;              // of the trees, in the order of their faces' numbers
  std::vector<Index> m_number_of_vertices; // that belong to the faces of the subtree of a face
  std::vector<double> m_area_before;       // by the number of a face
  std::vector<Index> m_ghosts_before;      // by the number of a face; empty if there are none
  std::vector<double> m_hole_area_before;  // by the number of a face; empty if there are no holes
  std::vector<Index> m_left_over;          // edges neither in the tree of vertices nor crossed by that of faces
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SURFACE_CYCLES_H
