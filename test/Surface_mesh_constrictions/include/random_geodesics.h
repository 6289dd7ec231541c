// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef RANDOM_GEODESICS_H
#define RANDOM_GEODESICS_H

#include "random_loops.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <iterator>
#include <random>
#include <vector>

namespace random_geodesics {

namespace SMC = CGAL::Surface_mesh_constrictions;

// Closed geodesics that loops of edges are tightened to. Some are the same, touch or cross.
template <class Graph>
std::vector<SMC::Constriction<Graph>> random_geodesics(const Graph& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<random_loops::Loop<Graph>> loops;
  for(int i = 0; i < 8; ++i)
    loops.push_back(random_loops::random_loop(mesh, random));
  std::vector<SMC::Tightened_curve<Graph>> tightened;
  SMC::tighten_closed_curves(mesh, loops, std::back_inserter(tightened), SMC::parameters::certify(false));
  std::vector<SMC::Constriction<Graph>> result;
  for(const auto& t : tightened)
    if(t.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC)
      result.push_back(t.curve);
  return result;
}

} // namespace random_geodesics

#endif // RANDOM_GEODESICS_H
