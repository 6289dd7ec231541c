// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_LABEL_PATHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_LABEL_PATHS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A border between the faces of two labels: halfedges one after the other, in faces of the lesser label.
struct Label_path
{
  std::vector<Index> halfedges;
  bool is_closed; // else it is held at its ends
};

// The borders between the labels of faces. They are held at each vertex where three labels meet, and at each end on the
// rim of a hole. Where faces of two labels alternate around a vertex those of the greater label are taken not to hang
// together there, and at a rim those that do not lie along it: so no border crosses itself.
class Label_paths
{
public:
  // `labels` of the faces without ghosts. Linear.
  Label_paths(const Progressive_mesh& pm, const std::vector<Index>& labels)
    : m_pm(pm), m_labels(labels), m_parted(pm.number_of_vertex_ids(), null_index),
      m_is_done(pm.number_of_halfedge_ids(), false)
  {
    std::vector<Index> borders, held;
    for(Index h = 0; h < 3 * labels.size(); ++h)
      if(is_border(h))
        borders.push_back(h);
    std::vector<bool> is_seen(pm.number_of_vertex_ids(), false);
    for(Index h : borders)
      for(Index v : {pm.source(h), pm.target(h)})
        if(!is_seen[v])
        {
          is_seen[v] = true;
          m_parted[v] = parted_label(v);
        }
    for(Index h : borders)
      if(is_held(pm.source(h)))
        follow(h, false);
    for(Index h : borders)
      if(!m_is_done[h])
        follow(h, true);
  }

  // those that are held first, each kind in the order of their first halfedges
  const std::vector<Label_path>& paths() const { return m_paths; }

private:
  bool is_ghost(Index h) const { return m_pm.is_ghost_face(m_pm.face(h)); }
  Index label(Index h) const { return m_labels[m_pm.face(h)]; }
  bool is_held(Index v) const { return m_parted[v] == null_index; }

  // Of the two halfedges of an edge between labels the one in the face of the lesser.
  bool is_border(Index h) const
  {
    const Index o = m_pm.opposite(h);
    return !is_ghost(h) && !is_ghost(o) && label(h) < label(o);
  }

  // The label of two at a vertex whose faces are parted there; null_index if borders are held. O(degree).
  Index parted_label(Index v) const
  {
    Index begin = m_pm.outgoing(v);
    bool is_on_rim = false;
    for(Index h = begin;;)
    {
      if(!is_ghost(h) && is_ghost(m_pm.opposite(h)))
      {
        is_on_rim = true;
        begin = h;
        break;
      }
      h = m_pm.ccw(h);
      if(h == begin)
        break;
    }
    const Index first = label(begin);
    Index other = null_index, last = first;
    Index h = begin;
    do
    {
      if(!is_ghost(h))
      {
        last = label(h);
        if(last != first && other == null_index)
          other = last;
        if(last != first && last != other)
          return null_index;
      }
      h = m_pm.ccw(h);
    } while(h != begin);
    if(is_on_rim)
      return last == first ? other : null_index;
    return (std::max)(first, other);
  }

  // The border that goes on where this halfedge ends. O(degree).
  Index next(Index h) const
  {
    Index i = m_pm.opposite(h);
    const Index parted = m_parted[m_pm.target(h)];
    if(parted == label(h))
    {
      do
        i = m_pm.cw(i);
      while(label(m_pm.opposite(i)) == parted); // there is another label before a hole
    }
    else
    {
      do
        i = m_pm.ccw(i);
      while(label(i) == parted);
    }
    return i;
  }

  void follow(Index first, bool is_closed)
  {
    Label_path path = {{}, is_closed};
    for(Index h = first;; h = next(h))
    {
      path.halfedges.push_back(h);
      m_is_done[h] = true;
      if(is_closed ? next(h) == first : is_held(m_pm.target(h)))
        break;
    }
    m_paths.push_back(std::move(path));
  }

  const Progressive_mesh& m_pm;
  const std::vector<Index>& m_labels;
  std::vector<Index> m_parted;
  std::vector<bool> m_is_done;
  std::vector<Label_path> m_paths;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_LABEL_PATHS_H
