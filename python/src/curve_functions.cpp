// SPDX-License-Identifier: GPL-3.0-or-later
#include "detect.h"

#include "search_parameters.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/measure_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/tags.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <istream>
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

  template <class NamedParameters>
  Query(const Mesh& mesh, const NamedParameters& np) : query(mesh, np)
  {}
  Query(const Mesh& mesh, std::istream* in) : query(mesh, *in) {}
};

Prepared_mesh::Prepared_mesh(const Mesh& mesh, bool is_for_detection, Monitor& monitor)
  : m_is_for_detection(is_for_detection)
{
  SMC::Detection_statistics statistics;
  const auto visitor = SMC::parameters::visitor(Monitoring_visitor(monitor, statistics));
  m_query = is_for_detection ? std::make_unique<const Query>(mesh, visitor)
                             : std::make_unique<const Query>(mesh, SMC::parameters::seed_sources(No_seeds(), visitor));
}

Prepared_mesh::Prepared_mesh(const Mesh& mesh, std::string_view file) : m_is_for_detection(true)
{
  boost::iostreams::stream<boost::iostreams::array_source> in(file.data(), file.size());
  m_query = std::make_unique<const Query>(mesh, static_cast<std::istream*>(&in));
}

Prepared_mesh::~Prepared_mesh() = default;

std::string Prepared_mesh::as_file() const
{
  std::string result;
  boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> out(result);
  m_query->query.write(out);
  out.flush();
  return result;
}

Detected Prepared_mesh::detect(const Search& search, Monitor& monitor) const
{
  Detected result;
  m_query->query.constrictions(std::back_inserter(result.constrictions),
                               search_parameters(search, monitor, result.statistics));
  return result;
}

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
    surface.prepared = std::make_shared<const Prepared_mesh>(surface.mesh, false, monitor);
  return surface.prepared;
}

std::shared_ptr<const Prepared_mesh> prepared_for_detection(const Surface& surface, Monitor& monitor)
{
  const std::lock_guard<std::mutex> lock(surface.prepared_mutex);
  if(!surface.prepared || !surface.prepared->is_for_detection())
    surface.prepared = std::make_shared<const Prepared_mesh>(surface.mesh, true, monitor);
  return surface.prepared;
}

void read_prepared(const Surface& surface, std::string_view file)
{
  const auto read = std::make_shared<const Prepared_mesh>(surface.mesh, file);
  const std::lock_guard<std::mutex> lock(surface.prepared_mutex);
  surface.prepared = read;
}

SMC::Certificate certify(const Mesh& mesh, const Constriction& curve) { return SMC::certify_constriction(mesh, curve); }

std::vector<Constriction> measure(const Mesh& mesh, const std::vector<Constriction>& curves)
{
  std::vector<Constriction> result;
  SMC::measure_constrictions(mesh, curves, std::back_inserter(result));
  return result;
}

} // namespace constrictions
