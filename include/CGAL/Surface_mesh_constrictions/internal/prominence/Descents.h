// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DESCENTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DESCENTS_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Boundary_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/vertex_passes.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve that is less prominent hardly holds. On a tube most closed geodesics are such.
constexpr double negligible_prominence = 0.01;

// The curve, or the point, that a curve that hardly holds becomes.
struct Descent
{
  Index curve;   // of the tightener; null_index if it shortens to a point
  double height; // the greatest length on the way
  Strip strip;   // the faces of a closed curve that shortens to it
  Index vertex;  // over which it slides off, if it shortens to a point
};

// Follows closed geodesics over single vertices to one that holds, as long as the curve behind the vertex is shorter
// and the way there is hardly longer. Each is followed once. Its end depends on the surface and the curve alone.
//
// On a fine mesh with noise a curve has hundreds of such passes, and as many curves lie behind each of them in turn.
// There it is led in one step over all vertices behind which one of its arcs becomes shorter by itself.
class Descents
{
public:
  // `angles` of the surface of the tightener.
  Descents(Boundary_tightener& tightener, const Corner_angles& angles) : m_tightener(tightener), m_angles(angles) {}

  // The end of a simple curve of the tightener, or null if the curve holds. For each curve on the way the first call
  // costs as much as `vertex_passes()`, plus tightening the curve behind each pass.
  const Descent* descent(Index from)
  {
    std::vector<Index> way;
    const Descent* end = nullptr;
    for(Index c = from; c != null_index;)
    {
      const auto known = m_descents.find(c);
      if(known != m_descents.end())
      {
        end = known->second ? &*known->second : nullptr;
        break;
      }
      std::optional<Descent>& d = m_descents[c];
      d = step(c);
      way.push_back(c);
      c = d ? d->curve : null_index;
    }
    // backwards from the end: each curve gets the end of the next one on the way
    for(auto c = way.rbegin(); c != way.rend(); ++c)
    {
      std::optional<Descent>& d = m_descents[*c];
      if(d && end != nullptr)
        d = Descent{end->curve, (std::max)(d->height, end->height), end->strip, end->vertex};
      end = d ? &*d : nullptr;
    }
    return end;
  }

private:
  // On scans of 50,000 faces, and on these subdivided to 800,000, curves have up to 15 passes.
  static constexpr std::size_t many_passes = 32;

  // Over the lowest vertex behind which the curve becomes shorter, or over many.
  std::optional<Descent> step(Index c)
  {
    const double length = m_tightener.length(c);
    const std::vector<Arc> arcs = m_tightener.arcs(c);
    const std::vector<Vertex_pass> passes = vertex_passes(m_tightener.surface(), m_angles, arcs,
                                                          (1 + negligible_prominence) * length, m_tightener.puller());
    if(passes.size() >= many_passes)
      return step_over_many(length, arcs, passes);
    for(const Vertex_pass& pass : passes)
    {
      const std::vector<Arc> at_vertex = drawn_to_vertex(arcs, pass);
      const Tightened_boundary b = m_tightener.let_go(at_vertex, pass.vertex, pass.far_side);
      if(b.is_simple && b.length < length * (1 - equal_length_tolerance))
        return Descent{b.longest, pass.length, strip_beside(m_tightener.surface(), at_vertex, pass.far_side),
                       b.longest == null_index ? pass.vertex : null_index};
    }
    return std::nullopt;
  }

  // Over all vertices behind which an arc becomes shorter while its two ends are held, the lowest one of each arc. These
  // passes do not depend on each other: one after the other, none is higher than it is alone.
  std::optional<Descent> step_over_many(double length, const std::vector<Arc>& arcs,
                                        const std::vector<Vertex_pass>& passes)
  {
    std::vector<std::vector<Arc>> replaced(arcs.size());
    double height = length;
    Index vertex = null_index; // the last one
    for(const Vertex_pass& pass : passes)
    {
      if(!replaced[pass.arc].empty())
        continue;
      std::vector<Arc> let_go = m_tightener.let_go(pass.before, pass.behind, pass.far_side);
      if(let_go.empty() || !(total_length(let_go) < arcs[pass.arc].length))
        continue;
      replaced[pass.arc] = std::move(let_go);
      height = pass.length;
      vertex = pass.vertex;
    }
    if(vertex == null_index)
      return std::nullopt;
    std::vector<Arc> led_over;
    for(std::size_t i = 0; i < arcs.size(); ++i)
      if(replaced[i].empty())
        led_over.push_back(arcs[i]);
      else
        led_over.insert(led_over.end(), replaced[i].begin(), replaced[i].end());
    Strip strip = strip_beside(m_tightener.surface(), led_over, Curve_side::LEFT);
    const Tightened_boundary b = m_tightener.tighten(std::move(led_over));
    if(!b.is_simple || !(b.length < length * (1 - equal_length_tolerance)))
      return std::nullopt;
    return Descent{b.longest, height, std::move(strip), b.longest == null_index ? vertex : null_index};
  }

  Boundary_tightener& m_tightener;
  const Corner_angles& m_angles;
  std::unordered_map<Index, std::optional<Descent>> m_descents; // by curve
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DESCENTS_H
