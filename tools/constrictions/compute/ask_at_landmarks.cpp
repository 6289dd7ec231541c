// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"
#include "compute/selection_parameters.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef SMC::Constriction_query<Mesh, CGAL::Parallel_if_available_tag> Query;

// Queries at places look for seeds of their own.
struct No_seeds
{
  template <class OutputIterator>
  OutputIterator operator()(const SMC::Progressive_mesh&, const SMC::Seed_level&, OutputIterator out) const
  {
    return out;
  }
};

Query prepared(const Mesh& mesh, Stage_monitor& monitor)
{
  return Query(mesh, SMC::parameters::seed_sources(No_seeds()).visitor(Monitoring_visitor(monitor)));
}

Mesh::Point point(const Landmark& landmark)
{
  return Mesh::Point(landmark.location[0], landmark.location[1], landmark.location[2]);
}

// The ids of the curves of a report from one on.
std::vector<std::size_t> ids_from(const Report& report, std::size_t first)
{
  std::vector<std::size_t> result;
  for(std::size_t id = first; id < report.constrictions.size(); ++id)
    result.push_back(id);
  return result;
}

// A constriction whose places in a sequence are those in a longer one, which has so many before it.
Constriction moved(const Constriction& c, std::size_t before)
{
  Constriction::Data data = c.data();
  if(data.dominated_by)
    *data.dominated_by += before;
  for(std::vector<std::size_t>* places : {&data.crosses, &data.crosses_oddly, &data.rivals})
    for(std::size_t& place : *places)
      place += before;
  return Constriction(std::move(data));
}

void add(SMC::Detection_statistics& sum, const SMC::Detection_statistics& s)
{
  sum.collapses = s.collapses;
  sum.seeds += s.seeds;
  sum.barriers += s.barriers;
  sum.degenerate += s.degenerate;
  sum.discarded += s.discarded;
  sum.not_simple += s.not_simple;
  sum.merged += s.merged;
  sum.not_selected += s.not_selected;
  sum.leaky_bands += s.leaky_bands;
  sum.not_certified += s.not_certified;
  sum.corrected += s.corrected;
  sum.signs = sum.signs + s.signs;
}

// Takes the statistics of one query.
struct Statistics_taker : SMC::Detection_visitor_base
{
  SMC::Detection_statistics* statistics;

  explicit Statistics_taker(SMC::Detection_statistics& statistics) : statistics(&statistics) {}
  void on_end(const SMC::Detection_statistics& s) const { *statistics = s; }
};

} // namespace

std::string near_hint(std::size_t not_selected)
{
  return not_selected == 0
             ? "No loop through this place comes to rest at a constriction."
             : "Nothing is narrow around this place: the constrictions that loops through it lead to are longer than "
               "1.5 times the girth here, or further away than their length, or left out by a threshold. --all shows "
               "them.";
}

void detect_near_landmarks(const std::vector<Landmark>& landmarks, const Selection& selection, bool certifies,
                           Stage_monitor& monitor, Report& report)
{
  const Query query = prepared(report.mesh, monitor);
  monitor.begin(SMC::Detection_stage::SELECTION, landmarks.size());
  for(const Landmark& landmark : landmarks)
  {
    const std::size_t before = report.constrictions.size();
    SMC::Detection_statistics statistics;
    std::vector<Constriction> curves;
    query.constrictions_near(
        point(landmark), std::back_inserter(curves),
        with_selection(selection, SMC::parameters::certify(certifies).visitor(Statistics_taker(statistics))));
    for(const Constriction& c : curves)
      report.constrictions.push_back(moved(c, before));
    add(report.statistics, statistics);
    report.landmarks.push_back(
        {landmark, ids_from(report, before), curves.empty() ? near_hint(statistics.not_selected) : ""});
    monitor.step(report.landmarks.size());
  }
  monitor.end(SMC::Detection_stage::SELECTION);
}

void find_girths(const std::vector<Landmark>& landmarks, const Girth& girth, bool certifies, Stage_monitor& monitor,
                 Report& report)
{
  report.is_girth = true;
  const Query query = prepared(report.mesh, monitor);
  monitor.begin(SMC::Detection_stage::TIGHTENING, landmarks.size());
  for(const Landmark& landmark : landmarks)
  {
    const std::size_t before = report.constrictions.size();
    if(girth.axis)
    {
      const std::string hint =
          add_section(query.plane_section(point(landmark), as_vector(*girth.axis), SMC::parameters::certify(certifies)),
                      certifies, report);
      report.landmarks.push_back({landmark, ids_from(report, before), hint});
      monitor.step(report.landmarks.size());
      continue;
    }
    std::vector<Geodesic_loop> loops;
    query.geodesic_loops(point(landmark), std::back_inserter(loops),
                         SMC::parameters::maximum_number_of_loops(girth.maximum_number)
                             .minimum_loop_angle(girth.minimum_angle)
                             .certify(certifies));
    add_loops(loops, certifies, report);
    std::string hint;
    if(loops.empty())
    {
      query.geodesic_loops(point(landmark), std::back_inserter(loops),
                           SMC::parameters::minimum_loop_angle(0.0).certify(false));
      hint = girth_hint(!loops.empty());
    }
    report.landmarks.push_back({landmark, ids_from(report, before), hint});
    monitor.step(report.landmarks.size());
  }
  monitor.end(SMC::Detection_stage::TIGHTENING);
}

} // namespace constrictions
