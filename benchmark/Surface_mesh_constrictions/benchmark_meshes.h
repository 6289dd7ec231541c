// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BENCHMARK_MESHES_H
#define BENCHMARK_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>

namespace benchmark_meshes {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// a surface of revolution with a number of necks and about the given number of faces, without two equal edges in it
Mesh chain_of_necks(int faces, int necks);

/// a flat body whose top and bottom are beds of mushrooms, about the given number of them and of faces: each stem is a
/// neck
Mesh bed_of_mushrooms(int faces, int mushrooms);

/// two boxes of 3x3x3 cubes joined by a bar of 2 cubes, about the given number of faces: each square of its surface is
/// a grid, so that most vertices lie in flat faces, all edges have one of two lengths, and coordinates are integers
Mesh flat_boxes(int faces);

/// the mesh of a file after some Loop subdivisions, which make four faces of each; empty if there is no such file
Mesh subdivided(const std::string& file, int subdivisions);

} // namespace benchmark_meshes

#endif // BENCHMARK_MESHES_H
