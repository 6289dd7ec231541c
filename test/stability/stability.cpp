// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the prominent constrictions of a mesh are found again after it has been subdivided, decimated, moved by
// noise, and rotated and relabelled.
//
//   stability [--lost N] [--change NAME]... MESH...
//
// Prints a row of a table for each mesh: faces, all curves, those of a prominence of 0.3 and more, and for each change
// how many of these are the same, have a stand-in, and are lost, see `Fate`; and where the surface is kept how many
// have the same length to 1e-6. Prints each lost curve, and what became of it. The exit code is 1 if more than N are
// lost.

#include "include/decimated.h"
#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
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
using test_meshes::Mesh;
using test_meshes::Position;
using test_meshes::Soup;
using test_meshes::Triangle;
typedef SMC::Constriction<Mesh> Constriction;
typedef std::vector<Constriction> Constrictions;
typedef Mesh::Vertex_index Vertex;

const double least_prominence = 0.3;

// A curve is found again by one of at least this prominence, a third less. No more is asked for: the prominence of a
// curve that cannot become shorter depends on where it lies, and may change by more.
const double least_prominence_again = 0.2;

// What becomes of a curve. The same: a curve of its length, to 5 percent, no point of which is further from it than a
// sixteenth of that, nor the other way round. A stand-in: to 15 percent, and an eighth.
enum class Fate
{
  SAME,
  STAND_IN,
  LOST
};

double distance(const Position& p, const Position& q)
{
  return std::sqrt(std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2));
}

struct Curve
{
  double length, prominence, band_width;
  std::vector<Position> samples; // at equal distances
};

const std::size_t number_of_samples = 192;

std::vector<Position> samples(const std::vector<Position>& points)
{
  std::vector<Position> result;
  double length = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    length += distance(points[i], points[(i + 1) % points.size()]);
  double passed = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Position &p = points[i], &q = points[(i + 1) % points.size()];
    const double l = distance(p, q);
    for(;;)
    {
      const double at = length * static_cast<double>(result.size()) / number_of_samples;
      if(result.size() == number_of_samples || at > passed + l || l == 0)
        break;
      const double t = (at - passed) / l;
      result.push_back({{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}});
    }
    passed += l;
  }
  return result;
}

// The greatest distance of a sample of the one from the other.
double one_sided_distance(const std::vector<Position>& from, const std::vector<Position>& to)
{
  double result = 0;
  for(const Position& p : from)
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(const Position& q : to)
      least = (std::min)(least, distance(p, q));
    result = (std::max)(result, least);
  }
  return result;
}

// Whether two curves have the same length and place, to the given shares of the length. In a flat band all places are
// one.
bool is_beside(const Curve& c, const Curve& d, double length, double place)
{
  const double room = place * c.length + c.band_width + d.band_width;
  return std::abs(c.length - d.length) <= length * c.length && one_sided_distance(c.samples, d.samples) <= room &&
         one_sided_distance(d.samples, c.samples) <= room;
}

typedef std::array<Position, 3> Rotation; // by rows

// By the inverse rotation.
Position turned_back(const Rotation& r, const Position& p)
{
  Position result;
  for(std::size_t i = 0; i < 3; ++i)
    result[i] = r[0][i] * p[0] + r[1][i] * p[1] + r[2][i] * p[2];
  return result;
}

const Rotation identity = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};

Curve make_curve(const Mesh& mesh, const Constriction& c, const Rotation& rotation)
{
  std::vector<Mesh::Point> points;
  c.points(mesh, std::back_inserter(points));
  std::vector<Position> positions;
  for(const Mesh::Point& p : points)
    positions.push_back(turned_back(rotation, {{p.x(), p.y(), p.z()}}));
  return {c.length(), c.prominence(), c.flat_band_width(), samples(positions)};
}

Constrictions all_constrictions(const Mesh& mesh)
{
  Constrictions result;
  SMC::detect_constrictions(mesh, std::back_inserter(result), params::certify(false).all_constrictions(true));
  return result;
}

Soup make_soup(const Mesh& mesh)
{
  Soup soup;
  for(Vertex v : mesh.vertices())
    soup.points.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  for(auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    soup.faces.push_back({{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}});
  }
  return soup;
}

// Each triangle divided into four.
Soup subdivided(const Soup& soup)
{
  Soup result;
  result.points = soup.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  for(const Triangle& t : soup.faces)
  {
    Triangle m;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t v = t[i], w = t[(i + 1) % 3];
      const auto it = middles.emplace(std::minmax(v, w), result.points.size());
      if(it.second)
      {
        const Position &p = soup.points[v], &q = soup.points[w];
        result.points.push_back({{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}});
      }
      m[i] = it.first->second;
    }
    result.faces.push_back({{t[0], m[0], m[2]}});
    result.faces.push_back({{t[1], m[1], m[0]}});
    result.faces.push_back({{t[2], m[2], m[1]}});
    result.faces.push_back(m);
  }
  return result;
}

// Each coordinate moved by up to two percent of the mean length of the edges.
Soup with_noise(Soup soup)
{
  double length = 0;
  for(const Triangle& t : soup.faces)
    for(std::size_t i = 0; i < 3; ++i)
      length += distance(soup.points[t[i]], soup.points[t[(i + 1) % 3]]);
  const double size = 0.02 * length / (3 * static_cast<double>(soup.faces.size()));
  Random random(1);
  for(Position& p : soup.points)
    for(double& x : p)
      x += random.real(-size, size);
  return soup;
}

// Rotated, with vertices and faces in another order.
Soup rotated(const Soup& soup, const Rotation& rotation)
{
  Random random(2);
  std::vector<std::size_t> place(soup.points.size());
  for(std::size_t v = 0; v < place.size(); ++v)
    place[v] = v;
  random.shuffle(place);
  Soup result;
  result.points.resize(soup.points.size());
  for(std::size_t v = 0; v < place.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Position &p = soup.points[v], &r = rotation[i];
      result.points[place[v]][i] = r[0] * p[0] + r[1] * p[1] + r[2] * p[2];
    }
  for(const Triangle& t : soup.faces)
  {
    Triangle u = {{place[t[0]], place[t[1]], place[t[2]]}};
    std::rotate(u.begin(), u.begin() + random.integer(3), u.end());
    result.faces.push_back(u);
  }
  random.shuffle(result.faces);
  return result;
}

struct Change
{
  const char* name;
  std::function<Mesh(const Mesh&)> apply;
  Rotation rotation;
  bool keeps_surface;
};

std::vector<Change> changes()
{
  // by 2 atan2(sqrt(2^2 + 3^2 + 6^2), 10), about (2, 3, 6)
  Rotation r;
  const Position axis = {{2, 3, 6}};
  const double w = 10, norm = w * w + 49;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t k = 3 - i - j;
      const double sign = (j + 3 - i) % 3 == 1 ? -1 : 1;
      r[i][j] = (2 * axis[i] * axis[j] + (i == j ? w * w - 49 : 2 * sign * w * axis[k])) / norm;
    }
  return {
      {"subdivided", [](const Mesh& m) { return test_meshes::make_mesh(subdivided(make_soup(m))); }, identity, true},
      {"decimated", [](const Mesh& m) { return decimated::decimated(m, num_faces(m) * 3 / 10); }, identity, false},
      {"noise", [](const Mesh& m) { return test_meshes::make_mesh(with_noise(make_soup(m))); }, identity, false},
      {"rotated", [r](const Mesh& m) { return test_meshes::make_mesh(rotated(make_soup(m), r)); }, r, true}};
}

// A closed path of edges through the vertices that are next to the samples of a curve.
std::vector<Vertex> path_beside(const Mesh& mesh, const Curve& c, const Rotation& rotation)
{
  std::vector<Position> points;
  for(Vertex v : mesh.vertices())
    points.push_back(turned_back(rotation, {{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}}));
  std::vector<Vertex> through;
  for(const Position& p : c.samples)
  {
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Position& q, const Position& r) {
      return distance(p, q) < distance(p, r);
    });
    const Vertex v(static_cast<Mesh::size_type>(nearest - points.begin()));
    if(through.empty() || through.back() != v)
      through.push_back(v);
  }
  if(through.size() > 1 && through.back() == through.front())
    through.pop_back();
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < through.size(); ++i)
  {
    const Vertex from = through[i], to = through[(i + 1) % through.size()];
    std::map<Vertex, double> reached = {{to, 0}};
    std::map<Vertex, Vertex> next;
    typedef std::pair<double, Vertex> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.emplace(0, to);
    while(!queue.empty() && queue.top().second != from)
    {
      const Entry e = queue.top();
      queue.pop();
      if(e.first > reached.at(e.second))
        continue;
      for(auto h : CGAL::halfedges_around_target(e.second, mesh))
      {
        const Vertex v = mesh.source(h);
        const double d = e.first + distance(points[v], points[e.second]);
        const auto it = reached.emplace(v, d);
        if(!it.second && it.first->second <= d)
          continue;
        it.first->second = d;
        next[v] = e.second;
        queue.emplace(d, v);
      }
    }
    if(queue.empty())
      return {};
    for(Vertex v = from; v != to; v = next.at(v))
      result.push_back(v);
  }
  return result;
}

std::string figures(const Curve& c)
{
  return "length " + std::to_string(c.length) + ", prominence " + std::to_string(c.prominence);
}

// What becomes of a curve on the changed mesh, of which the other curves were found: what it is tightened to there, and
// the most prominent one that has been found beside it.
std::string whereabouts(const Curve& c, const std::vector<Curve>& others, const Mesh& mesh, const Rotation& rotation)
{
  std::string result;
  const std::vector<Vertex> path = path_beside(mesh, c, rotation);
  const bool has_path = path.size() > 2;
  SMC::Tightened_curve<Mesh> tightened;
  if(has_path)
    tightened = SMC::tighten_closed_curve(mesh, path, params::certify(false));
  if(!has_path || tightened.verdict != SMC::Tightening_verdict::CLOSED_GEODESIC)
    result = "no constriction there";
  else
  {
    Constrictions measured;
    SMC::compute_prominences(mesh, Constrictions{tightened.curve}, std::back_inserter(measured));
    const Curve d = make_curve(mesh, measured.front(), rotation);
    const bool is_found =
        std::any_of(others.begin(), others.end(), [&](const Curve& o) { return is_beside(o, d, 1e-6, 1e-2); });
    result = std::string(is_beside(c, d, 0.15, 0.125) ? "there: " : "what it becomes there: ") + figures(d) +
             (is_found ? ", found" : ", not found");
  }
  const Curve* near = nullptr;
  for(const Curve& d : others)
    if(is_beside(c, d, 0.15, 0.125) && (near == nullptr || d.prominence > near->prominence))
      near = &d;
  return result + "; beside it " + (near == nullptr ? "nothing found" : "found: " + figures(*near));
}

struct Counts
{
  std::size_t same = 0, stand_in = 0, lost = 0;
  std::size_t equal = 0; // of the same length, to 1e-6
};

Counts compare(const std::string& name, const Mesh& mesh, const Change& change, const std::vector<Curve>& prominent)
{
  const Mesh changed = change.apply(mesh);
  std::vector<Curve> others;
  for(const Constriction& c : all_constrictions(changed))
    others.push_back(make_curve(changed, c, change.rotation));
  Counts result;
  for(const Curve& c : prominent)
  {
    Fate fate = Fate::LOST;
    bool is_equal = false;
    double difference = (std::numeric_limits<double>::infinity)(); // of the prominences
    for(const Curve& d : others)
    {
      const bool is_prominent = d.prominence >= least_prominence_again;
      if(is_prominent && is_beside(c, d, 0.05, 1.0 / 16))
        fate = Fate::SAME;
      else if(is_prominent && fate == Fate::LOST && is_beside(c, d, 0.15, 0.125))
        fate = Fate::STAND_IN;
      if(is_beside(c, d, 1e-6, 1.0 / 16))
      {
        is_equal = true;
        difference = (std::min)(difference, std::abs(d.prominence - c.prominence));
      }
    }
    ++(fate == Fate::SAME ? result.same : fate == Fate::STAND_IN ? result.stand_in : result.lost);
    result.equal += is_equal;
    if(change.keeps_surface && fate != Fate::LOST && !(difference <= 0.1 * c.prominence))
      std::cout << name << ", " << change.name << (is_equal ? ", another prominence: " : ", not of the same length: ")
                << figures(c) << "; " << whereabouts(c, others, changed, change.rotation) << std::endl;
    if(fate == Fate::LOST)
      std::cout << name << ", " << change.name << ", lost: " << figures(c) << "; "
                << whereabouts(c, others, changed, change.rotation) << std::endl;
  }
  return result;
}

// Returns how many curves are lost.
std::size_t check(const std::string& file, const std::vector<std::string>& names)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("cannot use " + file);
  const std::string name = file.substr(file.rfind('/') + 1);
  const Constrictions all = all_constrictions(mesh);
  std::vector<Curve> prominent;
  for(const Constriction& c : all)
    if(c.prominence() >= least_prominence && !c.is_rim())
      prominent.push_back(make_curve(mesh, c, identity));
  std::string row = "| " + name + " | " + std::to_string(num_faces(mesh)) + " | " + std::to_string(all.size()) + " | " +
                    std::to_string(prominent.size());
  std::size_t lost = 0;
  for(const Change& change : changes())
  {
    if(!names.empty() && std::find(names.begin(), names.end(), change.name) == names.end())
      continue;
    const Counts counts = compare(name, mesh, change, prominent);
    row += " | " + std::to_string(counts.same) + " + " + std::to_string(counts.stand_in) + " + " +
           std::to_string(counts.lost);
    if(change.keeps_surface)
      row += " (" + std::to_string(counts.equal) + ")";
    lost += counts.lost;
  }
  std::cout << row << " |" << std::endl;
  return lost;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    std::size_t most_lost = 0, lost = 0;
    std::vector<std::string> names, files, arguments(argv + 1, argv + argc);
    for(std::size_t i = 0; i < arguments.size(); ++i)
      if(arguments[i] == "--lost")
        most_lost = std::stoul(arguments.at(++i));
      else if(arguments[i] == "--change")
        names.push_back(arguments.at(++i));
      else
        files.push_back(arguments[i]);
    for(const std::string& f : files)
      lost += check(f, names);
    std::cout << lost << " lost" << std::endl;
    return files.empty() || lost > most_lost ? 1 : 0;
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << std::endl;
    return 1;
  }
}
