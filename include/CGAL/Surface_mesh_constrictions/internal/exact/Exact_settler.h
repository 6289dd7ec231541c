// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SETTLER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SETTLER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_string_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Side_angle.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/exact_arcs.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/foremost_corner.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Certifies curves that were tightened in floating point. Where rounding chose the wrong side of a near tie, the
// combinatorial curve is corrected, as the tightening would have done with exact numbers: an arc that is not straight
// is pulled straight in its strip, and a curve is led around the pivots at which its angle is too small, or out of a
// flat band that leaks.
//
// Near a flat band, or along a strip that is nearly straight, hundreds of pivots may be wrong at a time. One step
// passes all of them: it pulls the curve straight from each right pivot to the next one, or in the closed strip if no
// pivot is right. The curve lies in the closure of these strips and is bent at pivots on their boundary, so the pulled
// curve is shorter. Only the step out of a leaking band leaves the length as it is, and the next step shortens the
// curve. So no curve comes up twice. As finitely many curves are no longer than the first one, the correction ends.
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
  // canonical if it lies in a flat band. If a tie cannot be proved, the curve stays as the steps before have corrected
  // it. Costs as much as Certifier::examine() if no correction is needed; after a step only what it has changed is
  // examined anew.
  Certificate settle(Curve_network& network, Index c)
  {
    m_certifier.prover().begin_curve();
    Exact_curve curve = exact_arcs<Surface>(arcs_of_curve(network, c));
    std::vector<Known_of_arc> known(curve.size());
    Finding<Surface> finding = m_certifier.examine(curve, known);
    Sign_statistics signs = finding.certificate.signs;
    const Sign_statistics before = m_certifier.prover().statistics();
    bool is_changed = false;
    for(int step = 0; step < max_corrections && correct(curve, known, finding); ++step)
    {
      is_changed = true;
      if(curve.empty())
        break;
      renumber(curve);
      finding = m_certifier.examine(curve, known);
    }
    if(is_changed && !curve.empty() && !finding.certificate.is_certified())
    {
      // the step that was not possible may have turned the curve
      renumber(curve);
      known.assign(curve.size(), Known_of_arc());
      finding = m_certifier.examine(curve, known);
    }
    signs = signs + (m_certifier.prover().statistics() - before);
    if(curve.empty())
    {
      std::vector<Arc> none;
      network.set_arcs(c, none);
      Certificate result;
      result.signs = signs;
      return result;
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
      network.set_arcs_in_order(c, arcs);
    }
    Certificate result = finding.certificate;
    result.signs = signs;
    return result;
  }

  // The certificate of a path that is held at its ends, after its correction. The path has no arcs if it shrinks to the
  // one pivot that it is held at. Costs as much as settle().
  Certificate settle_path(std::vector<Arc>& path)
  {
    m_certifier.prover().begin_curve();
    Exact_curve curve = exact_arcs<Surface>(path);
    std::vector<Known_of_arc> known(curve.size());
    Finding<Surface> finding = m_certifier.examine_path(curve, known);
    Sign_statistics signs = finding.certificate.signs;
    const Sign_statistics before = m_certifier.prover().statistics();
    bool is_changed = false;
    for(int step = 0; step < max_corrections && correct_path(curve, known, finding); ++step)
    {
      is_changed = true;
      if(curve.empty())
        break;
      renumber(curve);
      finding = m_certifier.examine_path(curve, known);
    }
    if(is_changed)
      path = measured(curve);
    Certificate result = curve.empty() ? Certificate() : finding.certificate;
    result.signs = signs + (m_certifier.prover().statistics() - before);
    return result;
  }

  // how many curves rounding had led astray, without those that degenerate when they are corrected
  std::size_t number_of_corrections() const { return m_corrected; }

private:
  static constexpr int max_corrections = 100000; // of one curve; far more than any needs

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

  // Of the two ends of the band that holds a curve, the one with the smaller vertex; the other end if this one touches
  // itself, and the curve if both do. A band without an end on one side ends with the curve.
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

  // Does one step of the correction. False if there is nothing to correct, or if this is not possible.
  bool correct(Exact_curve& curve, std::vector<Known_of_arc>& known, const Finding<Surface>& finding)
  {
    switch(finding.certificate.verdict)
    {
    case Certificate_verdict::NOT_STRAIGHT:
      return straighten(curve, known, finding.arc);
    case Certificate_verdict::ANGLE_BELOW_PI:
      return lead_around_pivots(curve, known);
    case Certificate_verdict::LEAKY_BAND:
      curve = finding.band_ends[finding.certificate.side == Curve_side::LEFT ? 0 : 1];
      known.assign(curve.size(), Known_of_arc());
      return true;
    default:
      return false;
    }
  }

  // As correct(), for a path that is held at its ends.
  bool correct_path(Exact_curve& path, std::vector<Known_of_arc>& known, const Finding<Surface>& finding)
  {
    if(finding.certificate.verdict == Certificate_verdict::ANGLE_BELOW_PI)
    {
      // the start is held, whatever its angles
      known[0].has_angles = true;
      known[0].beyond_pi = {{Proved_sign::POSITIVE, Proved_sign::POSITIVE}};
      return lead_around_pivots(path, known, true);
    }
    if(finding.certificate.verdict != Certificate_verdict::NOT_STRAIGHT)
      return false;
    const Exact bent = path[finding.arc];
    Exact_curve pulled;
    if(!pull(bent.from, bent.crossings, bent.to, pulled))
      return false;
    replace(path, known, finding.arc, 1, pulled);
    return true;
  }

  // Numbers the locations of the arcs anew.
  static void renumber(Exact_curve& curve)
  {
    std::size_t location = 0;
    for(Exact& a : curve)
    {
      a.location = location;
      location += 1 + a.crossings.size();
    }
  }

  bool straighten(Exact_curve& curve, std::vector<Known_of_arc>& known, std::size_t arc)
  {
    std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(arc), curve.end());
    std::rotate(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(arc), known.end());
    Exact_curve path;
    if(!pull(curve[0].from, curve[0].crossings, curve[0].to, path))
      return false;
    replace(curve, known, 0, 1, path);
    return true;
  }

  // Replaces arcs by those of a path. The side angles at the pivots at the ends of the new arcs are not known then.
  static void replace(Exact_curve& curve, std::vector<Known_of_arc>& known, std::size_t first, std::size_t count,
                      const Exact_curve& path)
  {
    const auto begin = static_cast<std::ptrdiff_t>(first), end = static_cast<std::ptrdiff_t>(first + count);
    curve.erase(curve.begin() + begin, curve.begin() + end);
    known.erase(known.begin() + begin, known.begin() + end);
    if(first < known.size())
      known[first].has_angles = false;
    curve.insert(curve.begin() + begin, path.begin(), path.end());
    known.insert(known.begin() + begin, path.size(), Known_of_arc());
  }

  // Appends the shortest path in a strip; nothing if the path is a point. The strip is normalised first. False if a tie
  // could not be proved.
  bool pull(Index from, Strip strip, Index to, Exact_curve& path)
  {
    normalize_strip(m_pm, from, strip, to);
    if(!strip.empty())
      return Exact_string_puller<Surface>(m_certifier.prover()).pull(from, strip, to, path);
    if(from != to)
      path.push_back({{from, to, m_pm.halfedge(from, to), {}}, 0});
    return true;
  }

  // The side on which the curve has an angle below pi at the pivot where an arc starts: 0 for the left, 1 for the
  // right, -1 if there is none.
  static int sharp_side(const Known_of_arc& k)
  {
    return k.beyond_pi[0] == Proved_sign::NEGATIVE ? 0 : k.beyond_pi[1] == Proved_sign::NEGATIVE ? 1 : -1;
  }

  // Leads a curve around the pivots where a side angle is below pi. The start of a path that is held at its ends is not
  // passed.
  bool lead_around_pivots(Exact_curve& curve, std::vector<Known_of_arc>& known, bool is_held = false)
  {
    const std::size_t n = curve.size();
    std::size_t right = is_held ? 0 : n;
    for(std::size_t i = is_held ? 1 : 0; i < n; ++i)
    {
      m_certifier.examine_pivot(curve, i, known);
      if(n > 1 && runs_back(curve, i))
      {
        if(!is_held)
          return cut_off_spur(curve, known, i);
        replace(curve, known, i - 1, 2, Exact_curve());
        return true;
      }
      if(right == n && sharp_side(known[i]) < 0)
        right = i;
    }
    if(right == n)
      return lead_loop_around_pivots(curve, known);
    std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(right), curve.end());
    std::rotate(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(right), known.end());

    Exact_curve result;
    std::vector<Known_of_arc> known_of_result;
    bool is_new = false; // whether the arc before is new
    for(std::size_t i = 0, end = 0; i < n; i = end)
    {
      end = i + 1;
      while(end < n && sharp_side(known[end]) >= 0)
        ++end;
      const std::size_t size = result.size();
      if(end == i + 1)
      {
        result.push_back(curve[i]);
        known_of_result.push_back(known[i]);
        if(is_new)
          known_of_result.back().has_angles = false;
        is_new = false;
        continue;
      }
      if(!pull(curve[i].from, strip_past_pivots(curve, known, i, end), curve[end - 1].to, result))
        return false;
      known_of_result.resize(result.size());
      is_new = true;
      if(size == result.size() && size > 0) // the piece has shrunk to its end
        known_of_result.back().has_angles = false;
    }
    if(is_new && !known_of_result.empty())
      known_of_result.front().has_angles = false;
    curve = std::move(result);
    known = std::move(known_of_result);
    return true;
  }

  // The strip of the arcs [begin, end) that passes the pivots between them on their sharp sides. If `is_closed`, the
  // arcs are those of the whole curve, and the pivot where they begin and end is passed, too.
  Strip strip_past_pivots(const Exact_curve& curve, const std::vector<Known_of_arc>& known, std::size_t begin,
                          std::size_t end, bool is_closed = false) const
  {
    const std::size_t n = curve.size();
    Strip strip;
    for(std::size_t i = begin; i < end; ++i)
    {
      const Exact &arc = curve[i], &following = curve[(i + 1) % n];
      const bool passes_start = is_closed || i > begin, passes_end = is_closed || i + 1 < end;
      const int side = sharp_side(known[i]), next_side = sharp_side(known[(i + 1) % n]);
      strip.insert(strip.end(), arc.crossings.begin(), arc.crossings.end());
      if(arc.is_edge() && passes_start && passes_end && side != next_side)
        strip.push_back(side == 0 ? arc.along : m_pm.opposite(arc.along)); // from one side of the edge to the other
      if(passes_end)
        append_fan(m_surface, arc, following, next_side == 0 ? Curve_side::LEFT : Curve_side::RIGHT,
                   known[(i + 1) % n].is_whole_turn[static_cast<std::size_t>(next_side)], strip);
    }
    return strip;
  }

  // Whether the curve runs to the pivot where arc i starts and back along one edge.
  bool runs_back(const Exact_curve& curve, std::size_t i) const
  {
    const Exact &incoming = curve[(i + curve.size() - 1) % curve.size()], &outgoing = curve[i];
    return incoming.is_edge() && outgoing.is_edge() && m_pm.opposite(incoming.along) == outgoing.along;
  }

  static bool cut_off_spur(Exact_curve& curve, std::vector<Known_of_arc>& known, std::size_t tip)
  {
    const std::size_t before = (tip + curve.size() - 1) % curve.size();
    std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(before), curve.end());
    std::rotate(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(before), known.end());
    replace(curve, known, 0, 2, Exact_curve());
    return true;
  }

  // A curve all of whose pivots are wrong is led through a closed strip. The shortest curve of the strip passes through
  // the corner that reaches furthest into the strip. In a strip so wide that it unfolds over its own centre it may pass
  // through another corner: then the corners are tried in the order of the lengths of their loops, the shortest first.
  // The loop through a corner is the shortest curve of the strip if its angle at the corner, on the side of the strip,
  // is not below pi.
  bool lead_loop_around_pivots(Exact_curve& curve, std::vector<Known_of_arc>& known)
  {
    const Closed_strip strip(m_pm, strip_past_pivots(curve, known, 0, curve.size(), true));
    if(strip.is_degenerate())
    {
      curve.clear();
      return true;
    }
    Exact_curve loop;
    if(!pull_from(strip, exactly_foremost_corner(strip), loop) && !pull_from_best_corner(strip, loop))
      return false;
    curve = std::move(loop);
    known.assign(curve.size(), Known_of_arc());
    return true;
  }

  Closed_strip::Corner exactly_foremost_corner(const Closed_strip& strip)
  {
    const double clear_rotation = 1e-3;
    Sign_prover<Surface>& prover = m_certifier.prover();
    Curve_side side = strip.inner_side();
    int rotation = side == Curve_side::LEFT ? 1 : -1;
    if(std::abs(strip.rotation()) < clear_rotation)
    {
      rotation = rotation_sign(prover, strip.crossings());
      side = rotation >= 0 ? Curve_side::LEFT : Curve_side::RIGHT;
    }
    return strip.corner(side, foremost_portal(prover, strip.crossings(), side, rotation != 0));
  }

  // False if the shortest loop through a corner is not the shortest curve of the strip, or is a point, or cannot be
  // found because a tie is not proved.
  bool pull_from(const Closed_strip& strip, const Closed_strip::Corner& corner, Exact_curve& loop)
  {
    loop.clear();
    if(!pull(corner.vertex, strip.rotated(corner), corner.vertex, loop) || loop.empty())
      return false;
    if(loop.size() > 1 && runs_back(loop, 0))
      return true; // the strip closes around an edge, and turns once around its end
    Side_angle<Surface> towards_strip(m_certifier.prover(), loop.back(), loop.front(), other_side(corner.side));
    return towards_strip.sign_beyond_pi() != Proved_sign::NEGATIVE;
  }

  bool pull_from_best_corner(const Closed_strip& strip, Exact_curve& loop)
  {
    String_puller puller(m_pm);
    std::vector<std::pair<double, Closed_strip::Corner>> candidates;
    for(const Closed_strip::Corner& corner : strip.corners())
      candidates.emplace_back(total_length(strip.shortest_loop(corner, puller)), corner);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& candidate : candidates)
      if(pull_from(strip, candidate.second, loop))
        return true;
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
