// SPDX-License-Identifier: GPL-3.0-or-later

// What becomes of the borders between labels when they are tightened: a row of a table for each mesh file that is named
// on the command line, after
//
//   sdf       labels of CGAL's segmentation by the shape diameter function, with default parameters
//   voronoi   20 ragged random labels
//   quarters  the same, with each face cut into four
//   many      3, 8 and 20 ragged random labels, five times each; one row for all meshes

#include "include/random_labels.h"
#include "include/seeded_random.h"

#include <CGAL/Surface_mesh_constrictions/tighten_label_borders.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/property_map.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Certificate_verdict;
using SMC::Label_border_outcome;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

Mesh in_quarters(const Mesh& mesh)
{
  Mesh result;
  for(Mesh::Vertex_index v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  std::map<Mesh::Edge_index, Mesh::Vertex_index> middle;
  for(Mesh::Edge_index e : mesh.edges())
    middle[e] = result.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index a = mesh.halfedge(f), b = mesh.next(a), c = mesh.next(b);
    const Mesh::Vertex_index x = middle[mesh.edge(a)], y = middle[mesh.edge(b)], z = middle[mesh.edge(c)];
    result.add_face(mesh.source(a), x, z);
    result.add_face(mesh.source(b), y, x);
    result.add_face(mesh.source(c), z, y);
    result.add_face(x, y, z);
  }
  return result;
}

struct Row
{
  std::size_t runs = 0, faces = 0, labels_before = 0, labels_after = 0, borders = 0;
  std::map<Label_border_outcome, std::size_t> outcomes;
  std::size_t not_proved = 0, gone = 0;
  double length_before = 0, length_after = 0, seconds = 0;

  void add(const Mesh& mesh, const std::vector<int>& labels)
  {
    std::vector<int> new_labels(labels.size());
    const auto begin = std::chrono::steady_clock::now();
    const auto result =
        SMC::tighten_label_borders(mesh, CGAL::make_property_map(labels), CGAL::make_property_map(new_labels));
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    ++runs;
    faces += mesh.number_of_faces();
    labels_before += std::set<int>(labels.begin(), labels.end()).size();
    labels_after += std::set<int>(new_labels.begin(), new_labels.end()).size();
    borders += result.borders.size();
    for(const auto& b : result.borders)
    {
      ++outcomes[b.outcome];
      not_proved +=
          b.outcome == Label_border_outcome::GEODESIC_ARC && b.certificate.verdict != Certificate_verdict::GEODESIC_ARC;
      gone += b.outcome != Label_border_outcome::DEGENERATE && b.locations.empty();
      length_before += b.old_length;
      length_after += b.length;
    }
  }

  void print(const std::string& name)
  {
    std::cout << "| " << name << " | " << runs << " | " << faces << " | " << labels_before << " | " << labels_after
              << " | " << borders;
    for(const Label_border_outcome o :
        {Label_border_outcome::CLOSED_GEODESIC, Label_border_outcome::GEODESIC_ARC, Label_border_outcome::DEGENERATE,
         Label_border_outcome::CROSSING, Label_border_outcome::NOT_SIMPLE, Label_border_outcome::NOT_CERTIFIED})
      std::cout << " | " << outcomes[o];
    std::cout << " | " << not_proved << " | " << gone << " | " << length_before << " | " << length_after << " | "
              << seconds << " |" << std::endl;
  }
};

std::vector<int> labels_by_shape_diameter(const Mesh& mesh)
{
  std::vector<double> diameters(mesh.number_of_faces());
  std::vector<std::size_t> segments(mesh.number_of_faces());
  CGAL::sdf_values(mesh, CGAL::make_property_map(diameters));
  CGAL::segmentation_from_sdf_values(mesh, CGAL::make_property_map(diameters), CGAL::make_property_map(segments));
  return {segments.begin(), segments.end()};
}

std::vector<int> ragged_labels(const Mesh& mesh, int number, std::size_t seed)
{
  seeded_random::Random random(seed);
  return random_labels::ragged_voronoi(mesh, number, random);
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string kind = argc > 1 ? argv[1] : "";
  std::cout
      << "| mesh | runs | faces | labels | new labels | borders | closed geodesics | geodesic arcs | degenerate "
      << "| crossing | not simple | not certified | arcs not proved | gone | length | new length | seconds |\n"
      << "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: "
      << "| ---: | ---: |" << std::endl;
  Row many;
  for(int i = 2; i < argc; ++i)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh))
    {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return EXIT_FAILURE;
    }
    Row row;
    if(kind == "many")
      for(const int number : {3, 8, 20})
        for(std::size_t seed = 0; seed < 5; ++seed)
          many.add(mesh, ragged_labels(mesh, number, seed));
    else if(kind == "sdf")
      row.add(mesh, labels_by_shape_diameter(mesh));
    else if(kind == "quarters")
    {
      const Mesh fine = in_quarters(mesh);
      row.add(fine, ragged_labels(fine, 20, 0));
    }
    else
      row.add(mesh, ragged_labels(mesh, 20, 0));
    if(kind != "many")
      row.print(argv[i]);
  }
  if(kind == "many")
    many.print("all");
  return EXIT_SUCCESS;
}
