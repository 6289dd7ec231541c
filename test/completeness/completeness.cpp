// SPDX-License-Identifier: GPL-3.0-or-later

// What detect_constrictions() misses on small meshes: random closed walks are tightened there, and the strict
// constrictions among what they become are looked for in its list of all.
//
//   completeness [--bodies N] [--walks LEAST MOST] [--missed M] [--separating S] [--write DIRECTORY] [MESH...]
//
// Searches N random bodies of each family, and the given meshes that are closed, decimated to 300 faces; with between
// LEAST and MOST walks on each. Prints each curve that is missed, and writes its mesh and its points into the directory
// if one is given. Prints a row of a table for each family; see `Counts`. The exit code is 1 if more than M are missed,
// or more than S that separate, or any that is the first of its class.

#include "level_set_prominence.h"
#include "small_meshes.h"

#include "include/decimated.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using seeded_random::Random;
using small_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;
typedef std::vector<Constriction> Constrictions;
typedef Mesh::Vertex_index Vertex;
typedef std::vector<Vertex> Walk;

const double least_prominence = 0.3;

struct Options
{
  int bodies = 4, least_walks = 60, most_walks = 60;
  std::size_t missed = 0, separating = 0;
  std::string directory;
  std::vector<std::string> files;
};

struct Counts
{
  std::size_t meshes = 0, walks = 0;
  std::size_t listed = 0;     // curves of the detection
  std::size_t not_listed = 0; // strict constrictions of a length that is not listed
  // Those of them that have a prominence above 0.3 by the sweep of level_set_prominence.h, and by
  // compute_prominences(). Both are upper bounds, so that what is above by both is missed.
  std::size_t by_sweep = 0, by_package = 0, missed = 0;
  std::size_t separating = 0; // missed
  std::size_t first = 0;  // missed: the first of its class, that is, the homology class is no sum of classes of shorter
                          // curves that are listed
  std::size_t merged = 0; // missed, but found if seeds are not merged early
  std::size_t selected = 0; // missed: select_by_prominence() would select them

  void add(const Counts& c)
  {
    meshes += c.meshes;
    walks += c.walks;
    listed += c.listed;
    not_listed += c.not_listed;
    by_sweep += c.by_sweep;
    by_package += c.by_package;
    missed += c.missed;
    separating += c.separating;
    first += c.first;
    merged += c.merged;
    selected += c.selected;
  }

  void print(const std::string& name) const
  {
    std::cout << "| " << name;
    for(std::size_t n :
        {meshes, walks, listed, not_listed, by_sweep, by_package, missed, separating, first, merged, selected})
      std::cout << " | " << n;
    std::cout << " |" << std::endl;
  }
};

// Appends the shortest path from one vertex to another, without its end, for lengths of edges that are wrong by up to a
// half, differently for each path. False if there is none.
bool append_path(const Mesh& mesh, Vertex from, Vertex to, Random& random, Walk& walk)
{
  std::vector<double> lengths, distance(num_vertices(mesh), (std::numeric_limits<double>::infinity)());
  for(auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e);
    const double l = std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    lengths.push_back(l * random.real(1, 1.5));
  }
  std::vector<Vertex> next(num_vertices(mesh));
  typedef std::pair<double, Vertex> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distance[to] = 0;
  queue.emplace(0, to);
  while(!queue.empty())
  {
    const Entry e = queue.top();
    queue.pop();
    if(e.first > distance[e.second])
      continue;
    for(auto h : CGAL::halfedges_around_target(e.second, mesh))
    {
      const Vertex v = mesh.source(h);
      const double d = e.first + lengths[mesh.edge(h)];
      if(d < distance[v])
      {
        distance[v] = d;
        next[v] = e.second;
        queue.emplace(d, v);
      }
    }
  }
  if(distance[from] == (std::numeric_limits<double>::infinity)())
    return false;
  for(Vertex v = from; v != to; v = next[v])
    walk.push_back(v);
  return true;
}

// Through two to five random vertices. It may cross itself.
Walk random_walk(const Mesh& mesh, Random& random)
{
  const int n = static_cast<int>(num_vertices(mesh));
  Walk walk;
  while(walk.size() < 3)
  {
    walk.clear();
    std::vector<Vertex> corners;
    for(int i = 2 + random.integer(4); i > 0; --i)
      corners.emplace_back(static_cast<Mesh::size_type>(random.integer(n)));
    for(std::size_t i = 0; i < corners.size(); ++i)
      if(!append_path(mesh, corners[i], corners[(i + 1) % corners.size()], random, walk))
      {
        walk.clear();
        break;
      }
  }
  return walk;
}

// Lengths, to be looked for.
class Known_lengths
{
public:
  explicit Known_lengths(const Constrictions& curves)
  {
    for(const Constriction& c : curves)
      add(c.length());
  }

  void add(double length) { m_lengths.push_back(length); }
  bool has(double length) const
  {
    return std::any_of(m_lengths.begin(), m_lengths.end(),
                       [length](double l) { return std::abs(l - length) <= 1e-7 * length; });
  }

private:
  std::vector<double> m_lengths;
};

// The strict constrictions of new lengths that walks become, each length once. It is added to the known ones.
Constrictions strict_curves(const Mesh& mesh, const std::vector<Walk>& walks, Known_lengths& known)
{
  std::vector<SMC::Tightened_curve<Mesh>> tightened;
  SMC::tighten_closed_curves(mesh, walks, std::back_inserter(tightened), params::certify(false));
  Constrictions result;
  for(std::size_t i = 0; i < walks.size(); ++i)
  {
    if(tightened[i].verdict != SMC::Tightening_verdict::CLOSED_GEODESIC || known.has(tightened[i].curve.length()))
      continue;
    known.add(tightened[i].curve.length());
    const SMC::Tightened_curve<Mesh> exact = SMC::tighten_closed_curve(mesh, walks[i]);
    if(exact.verdict != SMC::Tightening_verdict::CLOSED_GEODESIC ||
       exact.curve.certificate().verdict != SMC::Certificate_verdict::STRICT_CONSTRICTION)
      continue;
    if(std::abs(exact.curve.length() - tightened[i].curve.length()) > 1e-7 * exact.curve.length())
    {
      if(known.has(exact.curve.length()))
        continue;
      known.add(exact.curve.length());
    }
    result.push_back(exact.curve);
  }
  return result;
}

void write(const std::string& name, const Mesh& mesh, const Constriction& curve)
{
  std::ofstream off(name + ".off"), points(name + ".polylines.txt");
  off.precision(17);
  points.precision(17);
  CGAL::IO::write_OFF(off, mesh, CGAL::parameters::stream_precision(17));
  std::vector<Mesh::Point> p;
  curve.points(mesh, std::back_inserter(p));
  points << p.size() + 1;
  for(const Mesh::Point& q : p)
    points << ' ' << q;
  points << ' ' << p.front() << '\n';
  if(!off || !points)
    throw std::runtime_error("cannot write " + name);
}

typedef std::vector<std::size_t> Homology_class; // numbers of a basis, ascending

// Whether the class of a curve that does not separate is no sum modulo 2 of classes of shorter ones of a mesh.
bool is_first_of_class(const Constriction& curve, Constrictions others)
{
  std::sort(others.begin(), others.end(),
            [](const Constriction& c, const Constriction& d) { return c.length() < d.length(); });
  std::map<std::size_t, Homology_class> basis; // by least number
  const auto reduced = [&](Homology_class h) {
    for(auto b = basis.begin(); !h.empty() && b != basis.end(); ++b)
      if(std::binary_search(h.begin(), h.end(), b->first))
      {
        Homology_class sum;
        std::set_symmetric_difference(h.begin(), h.end(), b->second.begin(), b->second.end(), std::back_inserter(sum));
        h.swap(sum);
      }
    return h;
  };
  for(const Constriction& c : others)
  {
    if(c.length() >= curve.length())
      break;
    const Homology_class h = reduced(c.homology_class());
    if(!h.empty())
      basis.emplace(h.front(), h);
  }
  return !reduced(curve.homology_class()).empty();
}

Counts search(const std::string& name, const Mesh& mesh, const Options& options, Random& random)
{
  Counts counts;
  counts.meshes = 1;
  Constrictions all;
  SMC::detect_constrictions(mesh, std::back_inserter(all), params::all_constrictions(true));
  counts.listed = all.size();
  std::vector<Walk> walks(
      static_cast<std::size_t>(options.least_walks + random.integer(options.most_walks - options.least_walks + 1)));
  for(Walk& w : walks)
    w = random_walk(mesh, random);
  counts.walks = walks.size();
  Known_lengths known(all);
  const Constrictions strict = strict_curves(mesh, walks, known);
  counts.not_listed = strict.size();
  Constrictions measured;
  SMC::compute_prominences(mesh, strict, std::back_inserter(measured));
  Constrictions missed;
  std::vector<double> by_sweep;
  for(const Constriction& c : measured)
  {
    const double p = level_set_prominence::prominence(mesh, c);
    counts.by_sweep += p > least_prominence;
    counts.by_package += c.prominence() > least_prominence;
    if(!(p > least_prominence && c.prominence() > least_prominence))
      continue;
    missed.push_back(c);
    by_sweep.push_back(p);
  }
  counts.missed = missed.size();
  if(missed.empty())
    return counts;
  Constrictions without_merging;
  SMC::detect_constrictions(
      mesh, std::back_inserter(without_merging),
      params::all_constrictions(true, params::tightening_schedule(SMC::Tightening_schedule::AT_THE_END)));
  const Known_lengths seeded(without_merging);
  Constrictions with_missed(all), selected;
  with_missed.insert(with_missed.end(), missed.begin(), missed.end());
  measured.clear();
  SMC::compute_prominences(mesh, with_missed, std::back_inserter(measured));
  SMC::select_by_prominence(measured, std::back_inserter(selected));
  const Known_lengths known_selected(selected);
  for(std::size_t i = 0; i < missed.size(); ++i)
  {
    const Constriction& c = measured[all.size() + i];
    const bool is_selected = known_selected.has(c.length());
    counts.selected += is_selected;
    const bool is_first = is_first_of_class(c, all);
    counts.separating += c.is_separating();
    counts.first += is_first;
    const bool is_merged = seeded.has(c.length());
    counts.merged += is_merged;
    std::cout << "missed: " << name << ", length " << c.length() << ", prominence " << by_sweep[i] << " by the sweep, "
              << c.prominence() << " by the package, " << (c.is_separating() ? "separates" : "does not separate")
              << ", ratio " << c.isoperimetric_ratio() << ", crosses " << c.crosses().size() << " and oddly "
              << c.crosses_oddly().size() << (is_first ? ", first of its class" : "")
              << (is_selected ? ", would be selected" : "") << (is_merged ? ", found without early merging" : "")
              << std::endl;
    if(!options.directory.empty())
      write(options.directory + "/" + name + "_" + std::to_string(i), mesh, c);
  }
  return counts;
}

// The given mesh, decimated; empty if it is of no use here.
Mesh read_decimated(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh) ||
     !CGAL::is_closed(mesh))
    return Mesh();
  mesh = decimated::decimated(mesh, small_meshes::most_faces);
  return num_faces(mesh) <= small_meshes::most_faces ? mesh : Mesh();
}

bool run(const Options& options)
{
  Counts total;
  const std::pair<const char*, std::function<Mesh(Random&)>> families[] = {
      {"noisy spheres", small_meshes::noisy_sphere},
      {"dented hulls", small_meshes::dented_hull},
      {"glued boxes", small_meshes::glued_boxes},
      {"plates with up to 2 holes", small_meshes::plate_with_few_holes},
      {"tori", small_meshes::torus},
      {"surfaces of revolution", small_meshes::revolution},
      {"plates with up to 6 holes", small_meshes::plate_with_many_holes}};
  std::size_t seed = 0;
  for(const auto& f : families)
  {
    Counts counts;
    for(int i = 0; i < options.bodies; ++i)
    {
      Random random(++seed);
      std::string name = f.first + (" " + std::to_string(i));
      std::replace(name.begin(), name.end(), ' ', '_');
      const Mesh mesh = f.second(random);
      counts.add(search(name, mesh, options, random));
    }
    counts.print(f.first);
    total.add(counts);
  }
  Counts counts;
  for(const std::string& file : options.files)
  {
    Random random(++seed);
    const Mesh mesh = read_decimated(file);
    if(mesh.is_empty())
      continue;
    try
    {
      counts.add(search(file.substr(file.rfind('/') + 1), mesh, options, random));
    }
    catch(const SMC::Invalid_input& e)
    {
      std::cout << "refused: " << file << ": " << e.what() << '\n';
    }
  }
  counts.print("decimated meshes");
  total.add(counts);
  total.print("together");
  return total.missed > options.missed || total.separating > options.separating || total.first > 0;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  try
  {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    for(std::size_t i = 0; i < arguments.size(); ++i)
    {
      const std::string a = arguments[i];
      const auto next = [&]() -> const std::string& { return arguments.at(++i); };
      if(a == "--bodies")
        options.bodies = std::stoi(next());
      else if(a == "--walks")
      {
        options.least_walks = std::stoi(next());
        options.most_walks = std::stoi(next());
      }
      else if(a == "--missed")
        options.missed = std::stoul(next());
      else if(a == "--separating")
        options.separating = std::stoul(next());
      else if(a == "--write")
        options.directory = next();
      else
        options.files.push_back(a);
    }
    return run(options) ? 1 : 0;
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << std::endl;
    return 1;
  }
}
