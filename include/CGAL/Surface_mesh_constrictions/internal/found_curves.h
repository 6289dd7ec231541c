// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_FOUND_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_FOUND_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/coincidence.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <algorithm>
#include <cstddef>
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

// Tightens refined curves on T^0, and returns what is left of them, each once. Curves that cross or touch themselves are
// among them if `with_not_simple`.
template <class Progress>
std::vector<Found_curve> tighten_refined(Curve_network& network, Curve_settler& settler,
                                         const std::vector<Refined_curve>& refined, bool with_not_simple,
                                         Detection_statistics& statistics, const Progress& on_step)
{
  std::vector<Found_curve> found;
  Distinct_curves distinct(network);
  for(std::size_t i = 0; i < refined.size(); ++i)
  {
    on_step(i + 1);
    const std::size_t seeds = refined[i].seeds.size();
    if(refined[i].is_discarded)
    {
      statistics.discarded += seeds;
      continue;
    }
    const Index c = network.add_curve(i);
    std::vector<Arc> arcs = arcs_of_curve(network.surface(), refined[i].curve);
    network.set_arcs(c, arcs);
    const Tightening_verdict verdict = settler.settle(c);
    if(verdict == Tightening_verdict::DEGENERATE)
      statistics.degenerate += seeds;
    else if(verdict == Tightening_verdict::NOT_SIMPLE && !with_not_simple)
    {
      statistics.not_simple += seeds;
      network.remove(c);
    }
    else if(distinct.insert(c) == c)
      found.push_back({c, network.length(c), settler.band_width(), Certificate()});
  }
  return found;
}

// Sorts curves by length and merges those that are the same but for rounding.
inline void merge_coinciding(Curve_network& network, std::vector<Found_curve>& found)
{
  const Progressive_mesh& pm = network.surface();
  std::stable_sort(found.begin(), found.end(),
                   [](const Found_curve& a, const Found_curve& b) { return a.length < b.length; });
  const auto trace_of = [&](const Found_curve& f) { return trace(pm, arcs_of_curve(network, f.curve)); };
  std::vector<Found_curve> kept;
  for(const Found_curve& f : found)
  {
    bool is_new = true;
    for(auto it = kept.rbegin(); is_new && it != kept.rend(); ++it)
    {
      if(it->length < f.length * (1 - coincidence_tolerance))
        break;
      if(coincide(pm, trace_of(f), trace_of(*it), f.length) && coincide(pm, trace_of(*it), trace_of(f), f.length))
      {
        network.merge(f.curve, it->curve);
        is_new = false;
      }
    }
    if(is_new)
      kept.push_back(f);
  }
  found.swap(kept);
}

// Certifies curves, drops those that are no constrictions, and merges those that have become the same.
template <class Exact_settler, class Progress>
void certify_found(Curve_network& network, Exact_settler& settler, double unit, const std::vector<Refined_curve>& refined,
                   std::vector<Found_curve>& found, Detection_statistics& statistics, const Progress& on_step)
{
  Distinct_curves distinct(network);
  std::vector<Found_curve> certified;
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    Found_curve f = found[i];
    f.certificate = settler.settle(network, f.curve);
    statistics.signs = statistics.signs + f.certificate.signs;
    on_step(i + 1);
    if(f.certificate.is_certified())
    {
      f.length = network.length(f.curve);
      f.band_width = f.certificate.flat_band_width / unit;
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
  statistics.corrected = settler.number_of_corrections();
  found.swap(certified);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_FOUND_CURVES_H
