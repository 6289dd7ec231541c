// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABEL_CHOOSER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABEL_CHOOSER_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Cut_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Labels_beside_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Part_finder.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The labels of the parts that borders divide a surface into. A part has the label that the borders around it name on
// its side. If they name several, because a border between them is gone, faces keep theirs as far as it is one of
// these. If there are no borders, because all are degenerate, the label of most of the area is left.
class Label_chooser
{
public:
  static constexpr std::size_t none = Cut_surface::none;

  // `surface` is cut along the arrangement, and is mended where nothing is left between borders that lie on each other.
  // `border_labels` are those on the left and right of the borders, by their numbers; `old_labels` of faces. Linear.
  template <class TriangleMesh>
  Label_chooser(Cut_surface& surface, const Curve_arrangement<TriangleMesh>& arrangement,
                const std::vector<std::array<Index, 2>>& border_labels, const std::vector<Index>& old_labels)
    : m_beside(arrangement.arcs().size()), m_old_labels(old_labels)
  {
    for(std::size_t c = 0; c < arrangement.number_of_curves(); ++c)
      for(const auto& use : arrangement.curve(c))
      {
        const std::array<Index, 2>& labels = border_labels[arrangement.curve_number(c)];
        m_beside[use.arc].add(labels[use.is_forward ? 0 : 1], labels[use.is_forward ? 1 : 0]);
      }
    mend(surface, [this](std::size_t s, const Cut_surface& cut) { return m_beside[cut.sides[s].arc].is_no_border(); });
    m_finder.emplace(surface);
    m_named.resize(m_finder->size());
    for(std::size_t s = 0; s < surface.sides.size(); ++s)
    {
      const std::size_t part = m_finder->part_of_side(s);
      if(part == none || !surface.is_on_curve(s) || !m_beside[surface.sides[s].arc].is_clear())
        continue;
      const Labels_beside_arc<Index>& labels = m_beside[surface.sides[s].arc];
      m_named[part][surface.sides[s].is_forward ? labels.left() : labels.right()] += m_finder->length(s);
    }
    // what ends inside of a part parts nothing
    if(mend(surface, [this](std::size_t s, const Cut_surface& cut) {
         return m_finder->part_of_side(s) == m_finder->part_of_side(cut.sides[s].opposite);
       }))
      m_finder.emplace(surface);
    choose(surface);
  }

  const Part_finder& finder() const { return *m_finder; }

  // of a piece of a curve of the arrangement
  const Labels_beside_arc<Index>& beside(std::size_t arc) const { return m_beside[arc]; }

  const std::vector<Index>& labels_of_parts() const { return m_label_of_part; }
  const std::vector<Index>& labels_of_faces() const { return m_label_of_face; }
  const std::vector<std::size_t>& parts_of_faces() const { return m_part_of_face; }

private:
  typedef std::map<Index, double> Weights; // of labels

  // Whether anything was.
  template <class IsNoBorder>
  static bool mend(Cut_surface& surface, const IsNoBorder& is_no_border)
  {
    std::vector<std::size_t> mended;
    for(std::size_t s = 0; s < surface.sides.size(); ++s)
      if(surface.is_on_curve(s) && is_no_border(s, surface))
        mended.push_back(s);
    for(std::size_t s : mended)
    {
      const Cut_surface::Side& side = surface.sides[s];
      const bool is_on_rim = surface.is_ghost(side.cell) != surface.is_ghost(surface.sides[side.opposite].cell);
      surface.sides[s].arc = is_on_rim ? Cut_surface::border : none;
    }
    return !mended.empty();
  }

  // the one with the greatest weight, the first of equal ones
  static Index heaviest(const Weights& weights)
  {
    auto result = weights.begin();
    for(auto i = weights.begin(); i != weights.end(); ++i)
      if(i->second > result->second)
        result = i;
    return result->first;
  }

  void choose(const Cut_surface& surface)
  {
    std::vector<Weights> areas(m_finder->size());
    for(std::size_t cell = 0; cell < surface.face_of_cell.size(); ++cell)
    {
      const std::size_t part = m_finder->part_of_cell(cell);
      if(part == none)
        continue;
      const Index old = m_old_labels[surface.face_of_cell[cell]];
      areas[part][m_named[part].empty() ? old : label_in(part, old)] += surface.area_of_cell[cell];
    }
    for(const Weights& w : areas)
      m_label_of_part.push_back(heaviest(w));
    m_part_of_face = m_finder->parts_of_faces();
    for(std::size_t f = 0; f < m_part_of_face.size(); ++f)
    {
      const std::size_t part = m_part_of_face[f];
      m_label_of_face.push_back(m_named[part].size() > 1 ? label_in(part, m_old_labels[f]) : m_label_of_part[part]);
    }
  }

  // Of what had this label, in a part for which labels are named.
  Index label_in(std::size_t part, Index old) const
  {
    return m_named[part].count(old) != 0 ? old : heaviest(m_named[part]);
  }

  std::vector<Labels_beside_arc<Index>> m_beside; // by arc
  const std::vector<Index>& m_old_labels;
  std::optional<Part_finder> m_finder;
  std::vector<Weights> m_named; // by part: for how much of its length its border names a label
  std::vector<Index> m_label_of_part, m_label_of_face;
  std::vector<std::size_t> m_part_of_face;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABEL_CHOOSER_H
