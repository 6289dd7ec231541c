// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SAME_CURVES_H
#define SAME_CURVES_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <vector>

namespace same_curves {

// Of a constriction what does not depend on the data structure: pivots are numbered in the order of vertices(graph).
struct Summary
{
  double length;
  std::vector<std::size_t> pivots;
  std::vector<double> parameters;

  friend bool operator==(const Summary& a, const Summary& b)
  {
    return a.length == b.length && a.pivots == b.pivots && a.parameters == b.parameters;
  }
};

template <class ConcurrencyTag = CGAL::Sequential_tag, class Graph, class NamedParameters>
std::vector<Summary> detect(const Graph& graph, const NamedParameters& np)
{
  typedef CGAL::Surface_mesh_constrictions::Constriction<Graph> Constriction;
  std::map<typename boost::graph_traits<Graph>::vertex_descriptor, std::size_t> number;
  for(auto v : vertices(graph))
    number.emplace(v, number.size());
  std::vector<Constriction> curves;
  CGAL::Surface_mesh_constrictions::detect_constrictions<ConcurrencyTag>(graph, std::back_inserter(curves), np);
  std::vector<Summary> result;
  for(const Constriction& c : curves)
  {
    Summary s = {c.length(), {}, {}};
    for(const auto& pivot : c.pivots())
      s.pivots.push_back(number.at(pivot.vertex));
    for(const auto& l : c.locations())
      s.parameters.push_back(l.parameter);
    result.push_back(s);
  }
  return result;
}

inline std::vector<test_meshes::Soup> soups()
{
  return {test_meshes::torus(0.1, 3), test_meshes::dumbbell(0.1, 4),
          test_meshes::joined(test_meshes::boxes_with_tube(2), test_meshes::torus(0.1, 5), 30)};
}

// Expects the same curves on another type of graph as on a Surface_mesh.
template <class Graph>
void expect_same_curves()
{
  for(const test_meshes::Soup& soup : soups())
  {
    const auto expected = detect(test_meshes::make_mesh(soup), CGAL::parameters::default_values());
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(detect(test_meshes::make_graph<Graph>(soup), CGAL::parameters::default_values()), expected);
  }
}

} // namespace same_curves

#endif // SAME_CURVES_H
