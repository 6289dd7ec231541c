// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"
#include "compute/note_loops.h"
#include "compute/selection_parameters.h"

#include "input/input_file.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_query_file.h>
#include <CGAL/Surface_mesh_constrictions/bound_prominences.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/tags.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef SMC::Constriction_query<Mesh, CGAL::Parallel_if_available_tag> Query;

std::unique_ptr<Query> read_prepared(const std::string& name, const Mesh& mesh, Stage_monitor& monitor)
{
  const Input_file file = read_input_file(name);
  boost::iostreams::stream<boost::iostreams::array_source> in(file.content.data(), file.content.size());
  try
  {
    monitor.begin(SMC::Detection_stage::SIMPLIFICATION, 1);
    std::unique_ptr<Query> query = std::make_unique<Query>(mesh, in);
    monitor.end(SMC::Detection_stage::SIMPLIFICATION);
    return query;
  }
  catch(const SMC::Invalid_query_file& e)
  {
    file.fail(e.what());
  }
}

// Queries at places look for seeds of their own.
struct No_seeds
{
  template <class OutputIterator>
  OutputIterator operator()(const SMC::Progressive_mesh&, const SMC::Seed_level&, OutputIterator out) const
  {
    return out;
  }
};

std::unique_ptr<Query> prepared_for_places(const std::string& file, const Mesh& mesh, Stage_monitor& monitor)
{
  if(!file.empty())
    return read_prepared(file, mesh, monitor);
  return std::make_unique<Query>(mesh, SMC::parameters::seed_sources(No_seeds()).visitor(Monitoring_visitor(monitor)));
}

Mesh::Point point(const std::array<double, 3>& location) { return {location[0], location[1], location[2]}; }

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

std::string girth_hint(bool has_folded)
{
  return has_folded ? "The closed curves through this place that hold are folded there: their angles are less than "
                      "--min-angle. With --min-angle 0 the shortest one is reported."
                    : "No closed curve through this place holds: there is no handle, and no limb that is steep enough.";
}

// Appends the loops at a place to the report. Returns why there are none, or an empty text.
std::string add_girth(const Query& query, const Mesh::Point& place, const Girth& girth, bool certifies, Report& report)
{
  if(girth.axis)
  {
    const std::array<double, 3>& a = *girth.axis;
    return add_section(
        query.plane_section(place, Mesh::Point::R::Vector_3(a[0], a[1], a[2]), SMC::parameters::certify(certifies)),
        certifies, report);
  }
  std::vector<Geodesic_loop> loops;
  query.geodesic_loops(place, std::back_inserter(loops),
                       SMC::parameters::maximum_number_of_loops(girth.maximum_number)
                           .minimum_loop_angle(girth.minimum_angle)
                           .certify(certifies));
  add_loops(loops, certifies, report);
  if(!loops.empty())
    return "";
  query.geodesic_loops(place, std::back_inserter(loops), SMC::parameters::minimum_loop_angle(0.0).certify(false));
  return girth_hint(!loops.empty());
}

} // namespace

std::string near_hint(std::size_t not_selected)
{
  return not_selected == 0
             ? "No loop through this place comes to rest at a constriction."
             : "Nothing is narrow around this place: the constrictions that loops through it lead to are longer than "
               "1.5 times the girth here, or further away than their length, or left out by a threshold. --all shows "
               "them.";
}

std::string prepare_mesh(const Mesh& mesh, Stage_monitor& monitor)
{
  const Query query(mesh, SMC::parameters::visitor(Monitoring_visitor(monitor)));
  std::string result;
  boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> out(result);
  query.write(out);
  out.flush();
  return result;
}

void detect_prepared(const std::string& prepared, const Selection& selection, const Search& search,
                     Stage_monitor& monitor, Report& report)
{
  const std::unique_ptr<Query> query = read_prepared(prepared, report.mesh, monitor);
  const auto selected =
      with_selection(selection, SMC::parameters::certify(search.certifies).visitor(Monitoring_visitor(monitor)));
  std::vector<Constriction> found;
  if(search.location)
    query->constrictions_near(point(*search.location), std::back_inserter(found), selected);
  else
    query->constrictions(std::back_inserter(found), selected);
  report.statistics = monitor.statistics;
  if(search.proves_prominence)
    SMC::bound_prominences(report.mesh, found, std::back_inserter(report.constrictions));
  else
    report.constrictions = std::move(found);
}

void detect_near_landmarks(const std::string& prepared, const std::vector<Landmark>& landmarks,
                           const Selection& selection, bool certifies, Stage_monitor& monitor, Report& report)
{
  const std::unique_ptr<Query> query = prepared_for_places(prepared, report.mesh, monitor);
  monitor.begin(SMC::Detection_stage::SELECTION, landmarks.size());
  for(const Landmark& landmark : landmarks)
  {
    const std::size_t before = report.constrictions.size();
    SMC::Detection_statistics statistics;
    std::vector<Constriction> curves;
    query->constrictions_near(
        point(landmark.location), std::back_inserter(curves),
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

void find_girth(const std::string& prepared, const Girth& girth, bool certifies, Stage_monitor& monitor, Report& report)
{
  report.is_girth = true;
  const std::unique_ptr<Query> query = prepared_for_places(prepared, report.mesh, monitor);
  monitor.begin(SMC::Detection_stage::TIGHTENING, 1);
  report.hint = add_girth(*query, point(*girth.location), girth, certifies, report);
  monitor.step(1);
  monitor.end(SMC::Detection_stage::TIGHTENING);
}

void find_girths(const std::string& prepared, const std::vector<Landmark>& landmarks, const Girth& girth,
                 bool certifies, Stage_monitor& monitor, Report& report)
{
  report.is_girth = true;
  const std::unique_ptr<Query> query = prepared_for_places(prepared, report.mesh, monitor);
  monitor.begin(SMC::Detection_stage::TIGHTENING, landmarks.size());
  for(const Landmark& landmark : landmarks)
  {
    const std::size_t before = report.constrictions.size();
    const std::string hint = add_girth(*query, point(landmark.location), girth, certifies, report);
    report.landmarks.push_back({landmark, ids_from(report, before), hint});
    monitor.step(report.landmarks.size());
  }
  monitor.end(SMC::Detection_stage::TIGHTENING);
}

} // namespace constrictions
