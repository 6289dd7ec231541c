// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SETTLER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SETTLER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_string_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Certifies curves that were tightened in floating point. Where rounding chose the wrong side of a near tie, the
// combinatorics are corrected as the tightening would have done with exact numbers: an arc that is not straight is
// pulled in its strip, and a curve is led around the pivot that it makes too small an angle at, or out of the flat band
// that leaks.
template <class TriangleMesh, class VertexPointMap>
class Exact_settler
{
  typedef Imported_surface<TriangleMesh, VertexPointMap> Surface;
  typedef Exact_arc<Surface> Exact;
  typedef std::vector<Exact> Exact_curve;

public:
  Exact_settler(const Progressive_mesh& pm, const Imported_mesh<TriangleMesh>& imported, VertexPointMap vpm)
    : m_pm(pm), m_surface(pm, imported, vpm), m_certifier(m_surface)
  {}

  // The certificate of a curve of the network after its correction. The curve has no arcs if it degenerates, and is
  // canonical if it lies in a flat band.
  // Costs what Certifier::examine() does if no correction is needed.
  Certificate settle(Curve_network& network, Index c)
  {
    Exact_curve curve = exact_curve(arcs_of_curve(network, c));
    Finding<Surface> finding = m_certifier.examine(curve);
    Sign_statistics signs = finding.certificate.signs;
    bool is_changed = false;
    for(int step = 0; step < max_corrections && correct(curve, finding); ++step)
    {
      is_changed = true;
      if(curve.empty())
      {
        std::vector<Arc> none;
        network.set_arcs(c, none);
        Certificate result;
        result.signs = signs;
        return result;
      }
      finding = m_certifier.examine(curve);
      signs = signs + finding.certificate.signs;
    }
    m_corrected += is_changed;
    if(finding.certificate.verdict == Certificate_verdict::CONSTRICTION)
    {
      curve = canonical_copy(curve, finding.band_ends);
      is_changed = true;
    }
    if(is_changed)
    {
      std::vector<Arc> arcs = measured(curve);
      network.set_arcs(c, arcs);
    }
    Certificate result = finding.certificate;
    result.signs = signs;
    return result;
  }

  // how many curves rounding had led astray, without those that degenerate when they are corrected
  std::size_t number_of_corrections() const { return m_corrected; }

private:
  static constexpr int max_corrections = 1000; // of one curve

  Exact_curve exact_curve(const std::vector<Arc>& arcs) const
  {
    Exact_curve result;
    std::size_t location = 0;
    for(const Arc& a : arcs)
    {
      result.push_back({a.from, a.to, a.along, {a.crossings.begin(), a.crossings.end()}, location});
      location += 1 + a.crossings.size();
    }
    return result;
  }

  std::vector<Arc> measured(const Exact_curve& curve) const
  {
    std::vector<Arc> result;
    for(const Exact& e : curve)
    {
      Arc a;
      a.from = e.from;
      a.to = e.to;
      a.along = e.is_edge() ? e.along : null_index;
      a.crossings.assign(e.crossings.begin(), e.crossings.end());
      measure(m_pm, a);
      result.push_back(std::move(a));
    }
    return result;
  }

  // Of the two ends of the band that holds a curve, the one with the smaller vertex, unless it touches itself there. A
  // band without an end on one side ends with the curve.
  Exact_curve canonical_copy(const Exact_curve& curve, const std::array<Exact_curve, 2>& band_ends)
  {
    std::array<const Exact_curve*, 2> ends = {{&band_ends[0], &band_ends[1]}};
    for(const Exact_curve*& end : ends)
      if(end->empty())
        end = &curve;
    if(smallest_pivot(*ends[1]) < smallest_pivot(*ends[0]))
      std::swap(ends[0], ends[1]);
    for(const Exact_curve* end : ends)
      if(m_certifier.is_simple(*end))
        return *end;
    return curve;
  }

  // One step. False if there is nothing to correct, or no way.
  bool correct(Exact_curve& curve, const Finding<Surface>& finding)
  {
    switch(finding.certificate.verdict)
    {
    case Certificate_verdict::NOT_STRAIGHT:
      return replace(curve, finding.arc, 1, curve[finding.arc].crossings);
    case Certificate_verdict::ANGLE_BELOW_PI:
      return curve.size() == 1 ? lead_loop_around_pivot(curve, finding) : lead_around_pivot(curve, finding);
    case Certificate_verdict::LEAKY_BAND:
      curve = finding.band_ends[finding.certificate.side == Curve_side::LEFT ? 0 : 1];
      renumber(curve);
      return true;
    default:
      return false;
    }
  }

  // Numbers the arcs' locations anew.
  static void renumber(Exact_curve& curve)
  {
    std::size_t location = 0;
    for(Exact& a : curve)
    {
      a.location = location;
      location += 1 + a.crossings.size();
    }
  }

  // Replaces `count` arcs, cyclically from number `first`, by the shortest path in a strip between their ends.
  bool replace(Exact_curve& curve, std::size_t first, std::size_t count, const Strip& strip)
  {
    Exact_curve path;
    if(!pull(curve[first].from, strip, curve[(first + count - 1) % curve.size()].to, path))
      return false;
    std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(first), curve.end());
    curve.erase(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(count));
    curve.insert(curve.end(), path.begin(), path.end());
    renumber(curve);
    return true;
  }

  // Appends the shortest path in a strip, which is normalised first; nothing if it is a point. False if a tie could not
  // be proved.
  bool pull(Index from, Strip strip, Index to, Exact_curve& path)
  {
    normalize_strip(m_pm, from, strip, to);
    if(!strip.empty())
      return Exact_string_puller<Surface>(m_certifier.prover()).pull(from, strip, to, path);
    if(from != to)
      path.push_back({from, to, m_pm.halfedge(from, to), {}, 0});
    return true;
  }

  bool lead_around_pivot(Exact_curve& curve, const Finding<Surface>& finding)
  {
    const std::size_t before = (finding.arc + curve.size() - 1) % curve.size();
    const Exact &incoming = curve[before], &outgoing = curve[finding.arc];
    Strip strip = incoming.crossings;
    append_fan(m_surface, incoming, outgoing, finding.certificate.side, finding.is_whole_turn, strip);
    strip.insert(strip.end(), outgoing.crossings.begin(), outgoing.crossings.end());
    return replace(curve, before, 2, strip);
  }

  // A curve with one pivot is led through a closed strip. It is shortest through one of the strip's corners; as that
  // may be a near tie, they are tried from the one with the shortest loop on, until the exact angle there is right.
  bool lead_loop_around_pivot(Exact_curve& curve, const Finding<Surface>& finding)
  {
    Strip crossings = curve[0].crossings;
    append_fan(m_surface, curve[0], curve[0], finding.certificate.side, finding.is_whole_turn, crossings);
    const Closed_strip strip(m_pm, crossings);
    if(strip.is_degenerate())
    {
      curve.clear();
      return true;
    }
    String_puller puller(m_pm);
    std::vector<std::pair<double, Closed_strip::Corner> > candidates;
    for(const Closed_strip::Corner& corner : strip.corners())
      candidates.emplace_back(total_length(strip.shortest_loop(corner, puller)), corner);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& candidate : candidates)
    {
      Exact_curve loop;
      const Index v = candidate.second.vertex;
      if(!pull(v, strip.rotated(candidate.second), v, loop) || loop.empty())
        continue;
      renumber(loop);
      const Finding<Surface> found = m_certifier.examine(loop);
      if(found.certificate.verdict == Certificate_verdict::ANGLE_BELOW_PI && found.arc == 0)
        continue;
      curve = std::move(loop);
      return true;
    }
    return false;
  }

  const Progressive_mesh& m_pm;
  Surface m_surface;
  Certifier<Surface> m_certifier;
  std::size_t m_corrected = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SETTLER_H
