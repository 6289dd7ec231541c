// SPDX-License-Identifier: GPL-3.0-or-later
#include "detect.h"

#include "search_parameters.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/tags.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <iterator>
#include <mutex>

namespace constrictions {

namespace SMC = CGAL::Surface_mesh_constrictions;

namespace {

// Queries at places look for seeds of their own.
struct No_seeds
{
  template <class OutputIterator>
  OutputIterator operator()(const SMC::Progressive_mesh&, const SMC::Seed_level&, OutputIterator out) const
  {
    return out;
  }
};

} // namespace

struct Prepared_mesh::Query
{
  SMC::Constriction_query<Mesh, CGAL::Parallel_if_available_tag> query;

  Query(const Mesh& mesh, Monitor& monitor, SMC::Detection_statistics& statistics)
    : query(mesh, SMC::parameters::seed_sources(No_seeds()).visitor(Monitoring_visitor(monitor, statistics)))
  {}
};

Prepared_mesh::Prepared_mesh(const Mesh& mesh, Monitor& monitor)
{
  SMC::Detection_statistics statistics;
  m_query = std::make_unique<const Query>(mesh, monitor, statistics);
}

Prepared_mesh::~Prepared_mesh() = default;

Detected Prepared_mesh::near(const Mesh::Point& location, const Search& search, Monitor& monitor) const
{
  Detected result;
  m_query->query.constrictions_near(location, std::back_inserter(result.constrictions),
                                    search_parameters(search, monitor, result.statistics));
  return result;
}

std::vector<Geodesic_loop> Prepared_mesh::girth(const Mesh::Point& location, std::size_t maximum_number,
                                                std::optional<double> minimum_angle, bool certify) const
{
  std::vector<Geodesic_loop> result;
  const auto np = SMC::parameters::maximum_number_of_loops(maximum_number).certify(certify);
  if(minimum_angle)
    m_query->query.geodesic_loops(location, std::back_inserter(result),
                                  SMC::parameters::minimum_loop_angle(*minimum_angle, np));
  else
    m_query->query.geodesic_loops(location, std::back_inserter(result), np);
  return result;
}

Plane_section Prepared_mesh::section(const Mesh::Point& location, const Mesh::Point::R::Vector_3& axis,
                                     bool certify) const
{
  return m_query->query.plane_section(location, axis, SMC::parameters::certify(certify));
}

std::vector<Tightened_curve> Prepared_mesh::tighten(const std::vector<std::vector<Mesh::Vertex_index>>& loops,
                                                    bool certify, Monitor& monitor) const
{
  std::vector<Tightened_curve> result;
  monitor.begin(SMC::Detection_stage::TIGHTENING, loops.size());
  const auto take = [&](const Tightened_curve& tightened) {
    result.push_back(tightened);
    monitor.step(result.size());
  };
  m_query->query.tighten(loops, boost::make_function_output_iterator(take), SMC::parameters::certify(certify));
  return result;
}

std::shared_ptr<const Prepared_mesh> prepared(const Surface& surface, Monitor& monitor)
{
  const std::lock_guard<std::mutex> lock(surface.prepared_mutex);
  if(!surface.prepared)
    surface.prepared = std::make_shared<const Prepared_mesh>(surface.mesh, monitor);
  return surface.prepared;
}

SMC::Certificate certify(const Mesh& mesh, const Constriction& curve) { return SMC::certify_constriction(mesh, curve); }

} // namespace constrictions
