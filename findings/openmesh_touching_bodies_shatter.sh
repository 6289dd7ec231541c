#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenMesh 9.0 (libopenmesh-dev 9.0-4+b1): IO::read_mesh() of two tetrahedra that share an edge.
#
# Guess: the reader refuses the file, or makes a second copy of the edge for the second tetrahedron.
# What happens: it returns true. The first tetrahedron is closed; the four faces of the second, which are in no way at
# fault, become four loose triangles with vertices of their own, and twelve border edges. Which body falls to pieces
# depends on the order of the faces: if they alternate, both do.
#
# Why it matters: segmentations of voxels touch at edges all the time. After this reader the mesh has boundary, and a
# program for closed surfaces refuses it, or treats each loose triangle as a component.
. "$(dirname "$0")/lib/packages.sh"
debian libopenmesh-dev=9.0-4+b1

cd "$work"
cat > touching.cpp << 'END'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <set>

int main()
{
  for(const char* name : {"one_after_the_other.off", "alternating.off"})
  {
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    const bool success = OpenMesh::IO::read_mesh(mesh, name);
    int border = 0;
    for(auto e : mesh.edges())
      border += mesh.is_boundary(e);
    std::set<std::vector<float>> places;
    for(auto v : mesh.vertices())
      places.insert({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
    std::printf("%s: %s, %zu vertices at %zu places, %zu faces, %d border edges\n", name,
                success ? "success" : "failure", mesh.n_vertices(), places.size(), mesh.n_faces(), border);
  }
}
END
compile touching OpenMeshCore
python3 - << 'END'
import meshes

points = [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)]
first = [(0, 3, 2), (0, 2, 1), (2, 3, 1), (3, 0, 1)]
second = [tuple({2: 4, 3: 5}.get(i, i) for i in f) for f in first]
meshes.write_off("one_after_the_other.off", points, first + second)
meshes.write_off("alternating.off", points, [f for pair in zip(first, second) for f in pair])
END
verdict "$(./touching 2> /dev/null)" \
"one_after_the_other.off: success, 18 vertices at 6 places, 8 faces, 12 border edges
alternating.off: success, 12 vertices at 6 places, 8 faces, 10 border edges"
