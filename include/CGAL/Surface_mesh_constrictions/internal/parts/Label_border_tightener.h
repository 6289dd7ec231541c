// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABEL_BORDER_TIGHTENER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABEL_BORDER_TIGHTENER_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Label_border.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Closed_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Held_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Border_arranger.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Cut_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Label_chooser.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/ranks_before.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Label_paths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Tightens the borders between labels of faces, and labels the faces anew.
template <class TriangleMesh, class VertexPointMap, class Label>
class Label_border_tightener
{
  typedef Constriction<TriangleMesh> Curve;
  typedef typename Curve::Location Location;
  typedef Label_border<TriangleMesh, Label> Border;
  typedef Tightened_labels<TriangleMesh, Label> Result;
  typedef Border_arranger<TriangleMesh> Arranger;

public:
  // `label` are the labels in ascending order, `old_labels` the places there of those of the faces. Linear.
  Label_border_tightener(const Imported_mesh<TriangleMesh>& imported, VertexPointMap vpm, bool certifies,
                         const std::vector<Label>& label, std::vector<Index> old_labels)
    : m_imported(imported), m_pm(Corner_table(imported.table), std::vector<Point>(imported.points)),
      m_certifies(certifies), m_label(label), m_old_labels(std::move(old_labels)), m_paths(m_pm, m_old_labels),
      m_length_unit(m_pm), m_sides(m_pm), m_closed_tightener(imported, m_pm, vpm, m_length_unit, m_sides, certifies),
      m_held_tightener(imported, m_pm, vpm, m_length_unit, m_closed_tightener.angles())
  {}

  // prominences(curves) returns closed geodesics with their prominences. To be called once.
  template <class Prominences>
  Result tighten(const Prominences& prominences)
  {
    Result result;
    for(const Label_path& path : m_paths.paths())
      tighten_border(path, result);
    const Arranger arranger(m_imported.mesh(), m_courses,
                            [&](std::vector<std::size_t>& closed) { put_foremost_first(closed, prominences, result); });
    for(std::size_t i = 0; i < result.borders.size(); ++i)
      place(arranger, i, result.borders[i]);

    Cut_surface surface(m_imported, arranger.arrangement());
    const Label_chooser chooser(surface, arranger.arrangement(), m_border_labels, m_old_labels);
    m_new_labels = chooser.labels_of_faces();
    tell_vanishing_labels(arranger, chooser, result);
    tell_parts(chooser, result);
    return result;
  }

  // the places, among the labels, of those of the faces
  const std::vector<Index>& new_labels() const { return m_new_labels; }

private:
  void tighten_border(const Label_path& path, Result& result)
  {
    Border border;
    const Index first = path.halfedges.front();
    m_border_labels.push_back({{m_old_labels[m_pm.face(first)], m_old_labels[m_pm.face(m_pm.opposite(first))]}});
    border.labels = {{m_label[m_border_labels.back()[0]], m_label[m_border_labels.back()[1]]}};
    border.is_closed = path.is_closed;
    Border_courses<TriangleMesh> courses = {path.is_closed, {}, 0, {}};
    std::vector<Index> vertices;
    for(Index h : path.halfedges)
    {
      vertices.push_back(m_pm.source(h));
      border.old_length += m_imported.unit().restored(edge_length(h));
    }
    if(!path.is_closed)
      vertices.push_back(m_pm.target(path.halfedges.back()));
    for(Index v : vertices)
    {
      border.old_vertices.push_back(m_imported.vertex(v));
      courses.old.push_back(pivot(v));
    }
    if(path.is_closed)
      tighten_closed(std::move(vertices), border, courses);
    else
      tighten_held(vertices, border, courses);
    if(border.outcome == Label_border_outcome::DEGENERATE)
      courses.old.clear();
    m_courses.push_back(std::move(courses));
    result.borders.push_back(std::move(border));
  }

  void tighten_closed(std::vector<Index>&& vertices, Border& border, Border_courses<TriangleMesh>& courses)
  {
    Tightened_curve<TriangleMesh> tightened = m_closed_tightener.tighten(std::move(vertices));
    switch(tightened.verdict)
    {
    case Tightening_verdict::CLOSED_GEODESIC:
      border.outcome = Label_border_outcome::CLOSED_GEODESIC;
      border.curve = tightened.curve;
      border.certificate = tightened.curve.certificate();
      courses.tight = tightened.curve.locations();
      courses.length = tightened.curve.length();
      break;
    case Tightening_verdict::DEGENERATE:
      border.outcome = Label_border_outcome::DEGENERATE;
      break;
    case Tightening_verdict::NOT_SIMPLE:
      border.outcome = Label_border_outcome::NOT_SIMPLE;
      break;
    case Tightening_verdict::NOT_CERTIFIED:
      border.outcome = Label_border_outcome::NOT_CERTIFIED;
      border.certificate = tightened.certificate;
      break;
    }
  }

  void tighten_held(const std::vector<Index>& vertices, Border& border, Border_courses<TriangleMesh>& courses)
  {
    std::vector<Arc> arcs = m_held_tightener.tighten(vertices);
    if(m_certifies && !arcs.empty())
      border.certificate = m_held_tightener.settle(arcs);
    if(arcs.empty())
    {
      border.outcome = Label_border_outcome::DEGENERATE;
      return;
    }
    border.outcome = Label_border_outcome::GEODESIC_ARC;
    for(const Trace_point& p : accurate_trace(m_pm, arcs))
      courses.tight.push_back(p.is_pivot() ? pivot(p.pivot) : crossing(p));
    courses.tight.push_back(pivot(vertices.back()));
    courses.length = m_imported.unit().restored(accurate_length(m_pm, arcs));
  }

  double edge_length(Index h) const { return norm(vector(m_pm.point(m_pm.source(h)), m_pm.point(m_pm.target(h)))); }

  Location pivot(Index v) const { return {true, m_imported.vertex(v), typename Curve::halfedge_descriptor(), 0}; }

  Location crossing(const Trace_point& p) const
  {
    return {false, typename Curve::vertex_descriptor(), m_imported.halfedge_of(p.halfedge), p.parameter};
  }

  template <class Prominences>
  void put_foremost_first(std::vector<std::size_t>& closed, const Prominences& prominences, Result& result) const
  {
    std::vector<Curve> curves;
    for(std::size_t i : closed)
      curves.push_back(result.borders[i].curve);
    curves = prominences(curves);
    std::vector<std::size_t> order;
    for(std::size_t i = 0; i < closed.size(); ++i)
    {
      result.borders[closed[i]].prominence = curves[i].prominence();
      order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return ranks_before(curves[i], curves[j]); });
    for(std::size_t& i : order)
      i = closed[i];
    closed = order;
  }

  void place(const Arranger& arranger, std::size_t i, Border& border) const
  {
    if(arranger.crossed(i))
    {
      const bool crosses_itself = *arranger.crossed(i) == i;
      border.outcome = crosses_itself ? Label_border_outcome::NOT_SIMPLE : Label_border_outcome::CROSSING;
      if(!crosses_itself)
        border.crossed_border = arranger.crossed(i);
    }
    switch(arranger.course(i))
    {
    case Arranger::Course::TIGHT:
      border.locations = m_courses[i].tight;
      border.length = m_courses[i].length;
      break;
    case Arranger::Course::OLD:
      border.locations = m_courses[i].old;
      border.length = border.old_length;
      break;
    case Arranger::Course::NONE:
      break;
    }
  }

  // Of the two labels beside a border the one that more of the border has lost; of equal ones that of the smaller
  // region.
  Index vanishing_label(std::size_t i, const std::vector<double>& area_of_region) const
  {
    std::array<double, 2> kept = {{0, 0}};
    const Label_path& path = m_paths.paths()[i];
    for(Index h : path.halfedges)
    {
      const std::array<Index, 2> faces = {{m_pm.face(h), m_pm.face(m_pm.opposite(h))}};
      for(std::size_t side = 0; side < 2; ++side)
        if(m_new_labels[faces[side]] == m_border_labels[i][side])
          kept[side] += edge_length(h);
    }
    if(kept[0] != kept[1])
      return m_border_labels[i][kept[0] < kept[1] ? 0 : 1];
    const Index h = path.halfedges.front();
    return m_border_labels[i][area_of_region[m_pm.face(h)] <= area_of_region[m_pm.face(m_pm.opposite(h))] ? 0 : 1];
  }

  // By face the area of the faces of its label that it hangs together with.
  std::vector<double> areas_of_regions() const
  {
    std::vector<double> result(m_old_labels.size(), -1);
    std::vector<Index> region;
    for(Index first = 0; first < m_old_labels.size(); ++first)
    {
      if(result[first] >= 0)
        continue;
      region.assign(1, first);
      result[first] = 0;
      double area = 0;
      for(std::size_t i = 0; i < region.size(); ++i)
      {
        const Index f = region[i];
        const auto &p = m_pm.point(m_pm.source(3 * f)), &q = m_pm.point(m_pm.source(3 * f + 1)),
                   &r = m_pm.point(m_pm.source(3 * f + 2));
        area += norm(cross(vector(p, q), vector(p, r))) / 2;
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
        {
          const Index g = m_pm.face(m_pm.opposite(h));
          if(!m_pm.is_ghost_face(g) && m_old_labels[g] == m_old_labels[f] && result[g] < 0)
          {
            result[g] = 0;
            region.push_back(g);
          }
        }
      }
      for(Index f : region)
        result[f] = area;
    }
    return result;
  }

  void tell_vanishing_labels(const Arranger& arranger, const Label_chooser& chooser, Result& result) const
  {
    const std::vector<double> areas = areas_of_regions();
    for(std::size_t i = 0; i < result.borders.size(); ++i)
      if(result.borders[i].outcome == Label_border_outcome::DEGENERATE)
        result.borders[i].vanishing_label = m_label[vanishing_label(i, areas)];
    const auto& arrangement = arranger.arrangement();
    for(std::size_t c = 0; c < arrangement.number_of_curves(); ++c)
    {
      const std::size_t i = arrangement.curve_number(c);
      const auto& uses = arrangement.curve(c);
      const bool parts_its_labels = std::any_of(uses.begin(), uses.end(), [&](const auto& use) {
        const std::size_t left = use.is_forward ? 0 : 1;
        return chooser.beside(use.arc).has(m_border_labels[i][left], m_border_labels[i][1 - left]);
      });
      if(!parts_its_labels)
        result.borders[i].vanishing_label = m_label[vanishing_label(i, areas)];
    }
  }

  void tell_parts(const Label_chooser& chooser, Result& result) const
  {
    result.parts = chooser.finder().parts();
    const Coordinate_unit& unit = m_imported.unit();
    for(Surface_part& part : result.parts)
    {
      part.area = unit.restored(part.area, 2);
      part.volume = unit.restored(part.volume, 3);
    }
    for(std::size_t part : chooser.parts_of_faces())
      ++result.parts[part].number_of_faces;
    for(Index l : chooser.labels_of_parts())
      result.labels.push_back(m_label[l]);
  }

  const Imported_mesh<TriangleMesh>& m_imported;
  const Progressive_mesh m_pm;
  const bool m_certifies;
  const std::vector<Label>& m_label;
  const std::vector<Index> m_old_labels;
  const Label_paths m_paths;
  const Length_unit m_length_unit;
  const Surface_sides m_sides;
  Closed_path_tightener<TriangleMesh, VertexPointMap> m_closed_tightener;
  Held_path_tightener<TriangleMesh, VertexPointMap> m_held_tightener;
  std::vector<std::array<Index, 2>> m_border_labels; // on the left and right of each border
  std::vector<Border_courses<TriangleMesh>> m_courses;
  std::vector<Index> m_new_labels;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_LABEL_BORDER_TIGHTENER_H
