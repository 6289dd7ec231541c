// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CURVE_TO_SETTLE_H
#define CURVE_TO_SETTLE_H

#include "include/exact_models.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <cstddef>
#include <vector>

namespace curve_to_settle {

using namespace CGAL::Surface_mesh_constrictions;
using exact_models::Position;
using exact_models::Soup;
using test_meshes::Mesh;

typedef Mesh::Property_map<Mesh::Vertex_index, Mesh::Point> Point_map;

// A curve on a mesh, of edges at first, and the exact correction alone.
struct Curve
{
  Mesh mesh;
  internal::Imported_mesh<Mesh> imported;
  Progressive_mesh pm;
  internal::Curve_network network;
  internal::Exact_settler<Mesh, Point_map> settler;
  Index id;

  Curve(const Soup& soup, const std::vector<Index>& loop)
    : mesh(test_meshes::make_mesh(soup)), imported(mesh, mesh.points(), get(boost::vertex_index, mesh)),
      pm(imported.table, imported.points), network(pm, false), settler(pm, imported, mesh.points()),
      id(network.add_curve(0, loop))
  {}

  Certificate_verdict settle() { return settler.settle(network, id).verdict; }
  double length() const { return network.length(id); }
  bool is_degenerate() const { return network.is_empty(id); }
};

// Numbers of the vertices at the given positions.
inline std::vector<Index> loop_of(const Soup& soup, const std::vector<Position>& positions)
{
  std::vector<Index> result;
  for(std::size_t v : exact_models::vertices_at(soup, positions))
    result.push_back(static_cast<Index>(v));
  return result;
}

} // namespace curve_to_settle

#endif // CURVE_TO_SETTLE_H
