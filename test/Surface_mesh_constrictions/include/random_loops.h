// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef RANDOM_LOOPS_H
#define RANDOM_LOOPS_H

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <random>
#include <vector>

namespace random_loops {

template <class Graph>
using Loop = std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>;

// Appends a path of fewest edges, without its end; by breadth-first search.
template <class Graph, class Vertex>
void append_path(const Graph& mesh, Vertex from, Vertex to, std::vector<Vertex>& path)
{
  std::map<Vertex, Vertex> next = {{to, to}};
  for(std::deque<Vertex> queue = {to}; next.count(from) == 0; queue.pop_front())
    for(Vertex w : CGAL::vertices_around_target(halfedge(queue.front(), mesh), mesh))
      if(next.emplace(w, queue.front()).second)
        queue.push_back(w);
  for(Vertex v = from; v != to; v = next.at(v))
    path.push_back(v);
}

// A closed walk through some random vertices; it may cross itself and run to and fro.
template <class Graph>
Loop<Graph> random_loop(const Graph& mesh, std::mt19937& random)
{
  const Loop<Graph> all(vertices(mesh).begin(), vertices(mesh).end());
  Loop<Graph> loop;
  while(loop.size() < 3)
  {
    std::array<typename Loop<Graph>::value_type, 4> corners;
    for(auto& v : corners)
      v = all[random() % all.size()];
    loop.clear();
    for(std::size_t i = 0; i < corners.size(); ++i)
      append_path(mesh, corners[i], corners[(i + 1) % corners.size()], loop);
  }
  return loop;
}

} // namespace random_loops

#endif // RANDOM_LOOPS_H
