// SPDX-License-Identifier: GPL-3.0-or-later

// The default call against the selection from all constrictions, and what must hold of the hierarchy of all.
//
//   selection_of_all [--most-faces N] [--wrong W] MESH...
//
// Prints a row of a table for each mesh of triangles, of no more than N faces if that is given, and what is wrong. The
// exit code is 1 if more than W things are, or any if that is not given: for the thresholds 0.05 and 0.2 both must select the same curves with the same
// prominences, but for those of less than 1.2 times the threshold; and the hierarchy of all must be closed. For 0.01
// the differences are counted.

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef SMC::Constriction<Mesh> Constriction;
typedef std::vector<Constriction> Constrictions;

// Selections of one threshold.
struct Comparison
{
  std::size_t by_default = 0, of_all = 0, near = 0; // near the threshold, in one of them only
  std::vector<std::string> different;
};

bool are_equal(const Constriction& c, const Constriction& d)
{
  return std::abs(c.length() - d.length()) <= 1e-9 * c.length() &&
         std::abs(c.prominence() - d.prominence()) <= 1e-6 * (1 + c.prominence());
}

std::string figures(const Constriction& c)
{
  std::ostringstream text;
  text.precision(10);
  text << "length " << c.length() << ", prominence " << c.prominence();
  return text.str();
}

// Notes what is in the one selection only.
void subtract(const Constrictions& one, const Constrictions& other, const char* which, double threshold,
              Comparison& result)
{
  std::vector<bool> is_taken(other.size(), false);
  for(const Constriction& c : one)
  {
    std::size_t j = 0;
    while(j < other.size() && (is_taken[j] || !are_equal(c, other[j])))
      ++j;
    if(j < other.size())
      is_taken[j] = true;
    else if(c.prominence() < 1.2 * threshold)
      ++result.near;
    else
      result.different.push_back(which + (": " + figures(c)));
  }
}

Comparison compare(const Mesh& mesh, const Constrictions& all, double threshold)
{
  Constrictions by_default, of_all;
  SMC::detect_constrictions(mesh, std::back_inserter(by_default), params::certify(false).minimum_prominence(threshold));
  SMC::select_by_prominence(all, std::back_inserter(of_all), params::minimum_prominence(threshold));
  Comparison result;
  result.by_default = by_default.size();
  result.of_all = of_all.size();
  subtract(of_all, by_default, "selected from all only", threshold, result);
  subtract(by_default, of_all, "selected by default only", threshold, result);
  return result;
}

typedef std::vector<std::size_t> Homology_class; // numbers of a basis, ascending

// The sum of two classes modulo 2.
Homology_class sum(const Homology_class& a, const Homology_class& b)
{
  Homology_class result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

// What does not hold of the hierarchy of all. A rim has come off where it is. A curve whose class is the sum of those
// of shorter ones can fall apart into these.
std::vector<std::string> faults(const Constrictions& all)
{
  std::vector<std::string> result;
  for(const Constriction& c : all)
  {
    if(c.dominated_by() && all[*c.dominated_by()].length() > c.length() * (1 + 1e-9))
      result.push_back("dominated by a longer one: " + figures(c));
    if(c.prominence() < SMC::default_minimum_prominence && !c.is_rim() && !c.dominated_by() && !c.slides_off())
      result.push_back("slides to nothing: " + figures(c));
  }
  std::vector<const Constriction*> by_length;
  for(const Constriction& c : all)
    if(!c.is_separating() && !c.is_rim())
      by_length.push_back(&c);
  std::stable_sort(by_length.begin(), by_length.end(),
                   [](const Constriction* c, const Constriction* d) { return c->length() < d->length(); });
  std::map<std::size_t, Homology_class> basis; // by least number
  for(const Constriction* c : by_length)
  {
    Homology_class h = c->homology_class();
    for(auto b = basis.begin(); !h.empty() && b != basis.end(); ++b)
      if(std::binary_search(h.begin(), h.end(), b->first))
        h = sum(h, b->second);
    if(h.empty())
      continue;
    if(c->prominence() < SMC::default_minimum_prominence)
      result.push_back("the shortest of its class: " + figures(*c));
    basis.emplace(h.front(), h);
  }
  return result;
}

// Prints the row of a mesh, and what is wrong. Returns how many things are.
std::size_t check(const std::string& file, std::size_t most_faces)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || num_faces(mesh) > most_faces)
  {
    std::cout << "left out: " << file << '\n';
    return 0;
  }
  Constrictions all;
  try
  {
    SMC::detect_constrictions(mesh, std::back_inserter(all), params::certify(false).all_constrictions(true));
  }
  catch(const SMC::Invalid_input& e)
  {
    std::cout << "refused: " << file << ": " << e.what() << '\n';
    return 0;
  }
  const std::string name = file.substr(file.rfind('/') + 1);
  std::cout << "| " << name << " | " << num_faces(mesh) << " | " << all.size();
  std::vector<std::string> wrong = faults(all);
  for(const double threshold : {0.01, 0.05, 0.2})
  {
    const Comparison c = compare(mesh, all, threshold);
    std::cout << " | " << c.by_default << " | " << c.of_all << " | " << c.different.size() << " + " << c.near;
    if(threshold >= SMC::default_minimum_prominence)
      wrong.insert(wrong.end(), c.different.begin(), c.different.end());
  }
  std::cout << " |" << std::endl;
  for(const std::string& w : wrong)
    std::cout << name << ": " << w << '\n';
  return wrong.size();
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t most_faces = (std::numeric_limits<std::size_t>::max)(), most_wrong = 0, wrong = 0;
  try
  {
    int first = 1;
    for(; first + 1 < argc; first += 2)
      if(std::string(argv[first]) == "--most-faces")
        most_faces = std::stoul(argv[first + 1]);
      else if(std::string(argv[first]) == "--wrong")
        most_wrong = std::stoul(argv[first + 1]);
      else
        break;
    if(first >= argc)
      return 1;
    for(int i = first; i < argc; ++i)
      wrong += check(argv[i], most_faces);
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  std::cout << wrong << " wrong" << std::endl;
  return wrong > most_wrong ? 1 : 0;
}
