// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that a user may write by mistake. Each has types of its own, because a compiler reports an instantiation once.
// CMakeLists.txt tells what is to be said about them.

#include <CGAL/Surface_mesh_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

namespace misuse {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::parameters;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef SMC::Constriction<Mesh> Constriction;
typedef std::vector<Constriction> Constrictions;

template <int i>
struct Container : std::vector<Constriction>
{};

template <int i>
struct No_graph
{};

void call(Mesh& mesh, const Constrictions& curves, Constrictions& result)
{
  const Mesh& unchanged = mesh;
  const Mesh::Point location(0, 0, 0);
  const auto out = std::back_inserter(result);
  const auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  const auto patches = get(CGAL::dynamic_face_property_t<int>(), mesh);
  std::vector<Mesh> meshes;
  std::vector<SMC::Part_cap<Mesh>> caps;
  std::vector<std::vector<Mesh::Vertex_index>> loops;
  std::vector<SMC::Tightened_curve<Mesh>> tightened;

  // a mesh that is to be changed is const
  SMC::split_along_constrictions(unchanged, curves);
  const CGAL::Surface_mesh<int> triangles;
  SMC::triangulate_with_face_map(mesh, triangles, patches);

  // a container, or an iterator that takes something else
  SMC::detect_constrictions(mesh, Container<1>());
  SMC::detect_constrictions_near(mesh, location, Container<2>());
  SMC::compute_prominences(mesh, curves, Container<3>());
  SMC::select_constrictions(mesh, curves, Container<4>());
  SMC::select_by_prominence(curves, Container<5>());
  SMC::tighten_closed_curves(mesh, loops, out);
  SMC::extract_parts(mesh, marks, meshes);
  SMC::extract_parts(mesh, marks, std::back_inserter(meshes), params::cap_output_iterator(caps));
  SMC::detect_constrictions(mesh, std::back_inserter(meshes));

  // not a mesh
  SMC::detect_constrictions(No_graph<1>(), out);
  SMC::detect_constrictions_near(No_graph<2>(), location, out);
  SMC::compute_prominences(No_graph<3>(), curves, out);
  SMC::select_constrictions(No_graph<4>(), curves, out);
  SMC::tighten_closed_curves(No_graph<5>(), loops, out);
  SMC::make_progressive_mesh(No_graph<6>(), {});
  SMC::segment_by_constrictions(No_graph<7>(), curves, patches);
  SMC::extract_parts(No_graph<8>(), marks, out);
  SMC::triangulate_with_face_map(No_graph<9>(), mesh, patches);
  SMC::detect_constrictions(mesh.points(), out);

  // named parameters of another function
  SMC::detect_constrictions(mesh, out, params::maximum_number(1));
  SMC::detect_constrictions_near(mesh, location, out, params::certify(false).seed_sources(0));
  SMC::select_by_prominence(curves, out, params::certify(false));
  SMC::select_constrictions(mesh, curves, out, params::minimum_prominence(0.1).visitor(0));
  SMC::compute_prominences(mesh, curves, out, params::vertex_point_map(mesh.points()).get_cost(0));
  SMC::split_along_constrictions(mesh, curves, params::with_caps(true).minimum_prominence(0.1));
  SMC::segment_by_constrictions(mesh, curves, patches, params::edge_is_constrained_map(marks));
  SMC::extract_parts(mesh, marks, std::back_inserter(meshes), params::maximum_number_of_parts(2));
  SMC::tighten_closed_curves(mesh, loops, std::back_inserter(tightened), params::certified_only(true));
  SMC::verify_with_shortest_paths(unchanged, curves.front(), params::all_constrictions(true));
  SMC::certify_constriction(mesh, curves.front(), params::vertex_index_map(0));
  SMC::make_progressive_mesh(mesh, {}, params::number_of_iterations(2));
  SMC::triangulate_with_face_map(mesh, mesh, patches, params::choked_side(0));
}

} // namespace misuse
