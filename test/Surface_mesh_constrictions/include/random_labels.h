// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef RANDOM_LABELS_H
#define RANDOM_LABELS_H

#include "seeded_random.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace random_labels {

// Labels of the faces of a Surface_mesh, by index: those of the nearest of some random faces, where each step to a
// neighbour is made longer by a random factor, and then some faces at borders get the label of a neighbour.
template <class Mesh>
std::vector<int> ragged_voronoi(const Mesh& mesh, int number, seeded_random::Random& random)
{
  typedef typename boost::graph_traits<Mesh>::face_descriptor Face;
  typedef std::pair<double, Face> Entry;
  const auto centre = [&](Face f) {
    const auto h = mesh.halfedge(f);
    return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                          mesh.point(mesh.target(mesh.next(h))));
  };
  const auto for_each_neighbour = [&](Face f, const auto& visit) {
    for(auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      if(const Face g = mesh.face(mesh.opposite(h)); g != Mesh::null_face())
        visit(g);
  };
  std::vector<double> distance(mesh.num_faces(), -1);
  std::vector<int> label(mesh.num_faces(), 0);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for(int i = 0; i < number; ++i)
  {
    const Face f(static_cast<typename Mesh::size_type>(random.integer(static_cast<int>(mesh.num_faces()))));
    distance[f] = 0;
    label[f] = i;
    queue.emplace(0, f);
  }
  while(!queue.empty())
  {
    const auto [d, f] = queue.top();
    queue.pop();
    if(d > distance[f])
      continue;
    for_each_neighbour(f, [&, d = d, f = f](Face g) {
      const double step = std::sqrt(CGAL::squared_distance(centre(f), centre(g))) * random.real(0.7, 1.9);
      if(distance[g] < 0 || d + step < distance[g])
      {
        distance[g] = d + step;
        label[g] = label[f];
        queue.emplace(distance[g], g);
      }
    });
  }
  std::vector<int> result = label;
  for(Face f : mesh.faces())
    for_each_neighbour(f, [&](Face g) {
      if(label[g] != label[f] && random.integer(4) == 0)
        result[f] = label[g];
    });
  return result;
}

} // namespace random_labels

#endif // RANDOM_LABELS_H
