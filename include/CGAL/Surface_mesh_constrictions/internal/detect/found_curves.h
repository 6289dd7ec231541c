// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_FOUND_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_FOUND_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/boundary_share.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/coincidence.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <CGAL/for_each.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve of T^0 that is going to be returned.
struct Found_curve
{
  Index curve; // of the network
  double length;
  double band_width;
  Certificate certificate;
};

// The result of tightening a refined curve.
struct Settled_curve
{
  Tightening_verdict verdict;
  std::vector<Arc> arcs;
  double band_width;
};

// The results of tightening a group of curves, and how often one of them slipped out of a flat band.
struct Settled_curves
{
  std::vector<Settled_curve> curves;
  std::size_t leaks = 0;
};

// Tightens refined curves on the surface of a network, and writes the closed geodesics into it, each once. Those that
// cross or touch themselves are included if `with_not_simple`. Calls on_step() with the number of curves done.
template <class ConcurrencyTag, class Progress>
std::vector<Found_curve> tighten_refined(Curve_network& network, const std::vector<Refined_curve>& refined,
                                         bool with_not_simple, Detection_statistics& statistics,
                                         const Progress& on_step)
{
  const Progressive_mesh& pm = network.surface();
  const Length_unit unit(pm);
  const Corner_angles angles(pm);
  const std::size_t group_size = 32;
  auto in_groups = make_groups<Settled_curves>(refined.size(), group_size);
  std::mutex mutex;
  std::size_t done = 0;
  CGAL::for_each<ConcurrencyTag>(in_groups, [&](Group<Settled_curves>& group) {
    Curve_network its_network(pm, false);
    Curve_settler settler(its_network, unit, angles);
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      group.result.curves.push_back({Tightening_verdict::DEGENERATE, {}, 0});
      Settled_curve& settled = group.result.curves.back();
      if(refined[i].is_discarded)
        continue;
      const Index c = its_network.add_curve(i);
      std::vector<Arc> arcs = arcs_of_curve(pm, refined[i].curve);
      its_network.set_arcs(c, arcs);
      settled.verdict = settler.settle(c);
      settled.band_width = settler.band_width();
      settled.arcs = arcs_of_curve(its_network, c);
      its_network.remove(c);
    }
    group.result.leaks = settler.number_of_leaks();
    const std::lock_guard<std::mutex> lock(mutex);
    on_step(done += group.end - group.begin);
    return true;
  });

  std::vector<Found_curve> found;
  Distinct_curves distinct(network);
  for(Group<Settled_curves>& group : in_groups)
  {
    statistics.leaky_bands += group.result.leaks;
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      Settled_curve& settled = group.result.curves[i - group.begin];
      const std::size_t seeds = refined[i].seeds.size();
      if(refined[i].is_discarded)
        statistics.discarded += seeds;
      else if(settled.verdict == Tightening_verdict::DEGENERATE)
        statistics.degenerate += seeds;
      else if(settled.verdict == Tightening_verdict::NOT_SIMPLE && !with_not_simple)
        statistics.not_simple += seeds;
      else
      {
        const Index c = network.add_curve(i);
        network.set_arcs(c, settled.arcs);
        if(distinct.insert(c) == c)
          found.push_back({c, network.length(c), settled.band_width, Certificate()});
      }
    }
  }
  return found;
}

// Drops the curves that separate and have a greater isoperimetric ratio, so that they need not be certified. Curves
// that are not simple stay, since they may be corrected, and rims stay if `with_rims` is set. Returns how many were
// dropped. Cost: for each curve that of `Surface_sides::part()`.
template <class ConcurrencyTag>
std::size_t drop_too_long(const Curve_network& network, const Surface_sides& sides, double maximum_isoperimetric_ratio,
                          bool with_rims, std::vector<Found_curve>& found)
{
  const Progressive_mesh& pm = network.surface();
  auto kept = make_groups<std::vector<Found_curve>>(found.size(), 32);
  CGAL::for_each<ConcurrencyTag>(kept, [&](Group<std::vector<Found_curve>>& group) {
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      const std::vector<Arc> arcs = arcs_of_curve(network, found[i].curve);
      const std::vector<Trace_point> points = trace(pm, arcs);
      if(!is_simple(pm, points))
      {
        group.result.push_back(found[i]);
        continue;
      }
      const Parting parting = sides.part(points);
      if(!is_too_long(found[i].length, parting, maximum_isoperimetric_ratio) ||
         (with_rims && boundary_share(pm, arcs, parting) > rim_share))
        group.result.push_back(found[i]);
    }
    return true;
  });
  const std::size_t number = found.size();
  found.clear();
  for(const Group<std::vector<Found_curve>>& group : kept)
    found.insert(found.end(), group.result.begin(), group.result.end());
  return number - found.size();
}

// Sorts curves by length and merges those that are the same but for rounding. The first `number_distinct` of them are
// known to be distinct. Cost: that of sorting, plus for each pair that may coincide that of `coincide()`.
inline void merge_coinciding(Curve_network& network, std::vector<Found_curve>& found, std::size_t number_distinct)
{
  struct Candidate
  {
    Found_curve found;
    bool is_new;
    std::optional<Curve_shape> shape;
  };
  const Progressive_mesh& pm = network.surface();
  const auto shape_of = [&](Candidate& c) -> const Curve_shape& {
    if(!c.shape)
      c.shape.emplace(pm, trace(pm, arcs_of_curve(network, c.found.curve)));
    return *c.shape;
  };
  std::vector<Candidate> candidates;
  // the shapes of equal curves coincide, unless rounding is as great as the curves
  Distinct_curves distinct(network);
  for(std::size_t i = 0; i < found.size(); ++i)
    if(distinct.insert(found[i].curve) == found[i].curve)
      candidates.push_back({found[i], i >= number_distinct, std::nullopt});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.found.length < b.found.length; });
  std::vector<std::size_t> kept;
  for(std::size_t i = 0; i < candidates.size(); ++i)
  {
    Candidate& c = candidates[i];
    bool is_distinct = true;
    for(auto k = kept.rbegin(); is_distinct && k != kept.rend(); ++k)
    {
      Candidate& shorter = candidates[*k];
      if(shorter.found.length < c.found.length * (1 - coincidence_tolerance))
        break;
      if((c.is_new || shorter.is_new) && coincide(shape_of(c), shape_of(shorter), c.found.length))
      {
        network.merge(c.found.curve, shorter.found.curve);
        is_distinct = false;
      }
    }
    if(is_distinct)
      kept.push_back(i);
  }
  found.clear();
  for(std::size_t i : kept)
    found.push_back(candidates[i].found);
}

// The certificates of a group of curves, the corrected curves, and how many were corrected.
struct Certified_curves
{
  std::vector<Certificate> certificates;
  std::vector<std::vector<Arc>> arcs;
  std::size_t corrections = 0;
};

// Whether nothing is proved against a curve that is not certified, because a sign stayed open: either one on which the
// certificate rests, or one that the correction needed at an angle that is too small by less than a rounding error, or
// all, where floating-point arithmetic has a defect. Up to rounding the curve is a simple closed geodesic.
inline bool remains_open(const Progressive_mesh& pm, const std::vector<Arc>& arcs, Certificate_verdict verdict)
{
  if(arcs.empty() ||
     (verdict != Certificate_verdict::TIE_NOT_PROVED && verdict != Certificate_verdict::NOT_STRAIGHT &&
      verdict != Certificate_verdict::ANGLE_BELOW_PI && verdict != Certificate_verdict::NO_DIRECTED_ROUNDING &&
      verdict != Certificate_verdict::SUBNORMALS_FLUSHED))
    return false;
  for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
    if(side_angle_range(pm, arcs, side).first < CGAL_PI - flat_tolerance)
      return false;
  return is_simple(pm, trace(pm, arcs));
}

// Certifies curves, drops those that are proved not to be constrictions, and merges those that have become the same. A
// curve of which a sign stays open is kept if `keeps_open`, with a certificate that says why. make_settler() makes an
// Exact_settler. Calls on_step() with the number of curves done.
template <class ConcurrencyTag, class MakeSettler, class Progress>
void certify_found(Curve_network& network, const MakeSettler& make_settler, const Coordinate_unit& unit,
                   bool keeps_open, const std::vector<Refined_curve>& refined, std::vector<Found_curve>& found,
                   Detection_statistics& statistics, const Progress& on_step)
{
  const std::size_t group_size = 8;
  auto in_groups = make_groups<Certified_curves>(found.size(), group_size);
  std::mutex mutex;
  std::size_t done = 0;
  CGAL::for_each<ConcurrencyTag>(in_groups, [&](Group<Certified_curves>& group) {
    Curve_network its_network(network.surface(), false);
    auto settler = make_settler();
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      const Index c = its_network.add_curve(i);
      std::vector<Arc> arcs = arcs_of_curve(network, found[i].curve);
      its_network.set_arcs_in_order(c, arcs);
      group.result.certificates.push_back(settler.settle(its_network, c));
      group.result.arcs.push_back(arcs_of_curve(its_network, c));
      its_network.remove(c);
    }
    group.result.corrections = settler.number_of_corrections();
    const std::lock_guard<std::mutex> lock(mutex);
    on_step(done += group.end - group.begin);
    return true;
  });

  Distinct_curves distinct(network);
  std::vector<Found_curve> certified;
  for(Group<Certified_curves>& group : in_groups)
  {
    statistics.corrected += group.result.corrections;
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      Found_curve f = found[i];
      f.certificate = group.result.certificates[i - group.begin];
      statistics.signs = statistics.signs + f.certificate.signs;
      network.set_arcs_in_order(f.curve, group.result.arcs[i - group.begin]);
      if(f.certificate.is_certified() ||
         (keeps_open && remains_open(network.surface(), arcs_of_curve(network, f.curve), f.certificate.verdict)))
      {
        f.length = network.length(f.curve);
        f.band_width = unit.divided(f.certificate.flat_band_width);
        if(distinct.insert(f.curve) == f.curve)
          certified.push_back(f);
        continue;
      }
      std::size_t seeds = 0;
      for(std::size_t r : network.curve(f.curve).seeds)
        seeds += refined[r].seeds.size();
      const Certificate_verdict verdict = f.certificate.verdict;
      (network.is_empty(f.curve) ? statistics.degenerate
       : verdict == Certificate_verdict::CROSSES_ITSELF || verdict == Certificate_verdict::TOUCHES_ITSELF
           ? statistics.not_simple
           : statistics.not_certified) += seeds;
      network.remove(f.curve);
    }
  }
  found.swap(certified);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_FOUND_CURVES_H
