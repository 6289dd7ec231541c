#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenMesh 9.0 (libopenmesh-dev 9.0-4+b1): IO::read_mesh() and IO::write_mesh() of a mesh whose Point is Vec3d.
#
# Guess: a mesh of double points reads the doubles of a file, and binary PLY keeps them.
# What happens: in all formats but its own, OM, reader and writer hand points to each other in single precision,
# whatever the type of the mesh and of the file. 1/3 in a binary PLY with "property double" arrives as
# 0.3333333432674408; writing with 17 digits prints that float; a binary PLY is declared as one of floats. OM keeps
# doubles.
#
# Why it matters: OpenMesh's meshes are FaceGraphs, and this package takes them. A body in map coordinates, 1e6, has
# steps of 1/16 after reading; flat faces are no longer flat, and the closed geodesics are others than those of the
# file. CGAL's own readers keep the doubles.
. "$(dirname "$0")/lib/packages.sh"
debian libopenmesh-dev=9.0-4+b1

cd "$work"
cat > through_floats.cpp << 'END'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cstdio>

struct Traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};
typedef OpenMesh::TriMesh_ArrayKernelT<Traits> Mesh;

double greatest_x(const Mesh& mesh)
{
  double x = 0;
  for(auto v : mesh.vertices())
    x = std::max(x, mesh.point(v)[0]);
  return x;
}

int main()
{
  for(const char* name : {"third.off", "third.obj", "third.ply"})
  {
    Mesh mesh;
    OpenMesh::IO::read_mesh(mesh, name);
    std::printf("read %s: %.17g\n", name, greatest_x(mesh));
  }
  Mesh mesh;
  Mesh::VertexHandle v[] = {mesh.add_vertex({0, 0, 0}), mesh.add_vertex({1. / 3, 0, 0}), mesh.add_vertex({0, 1, 0}),
                            mesh.add_vertex({0, 0, 1})};
  for(const auto& f : {std::array<int, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
  std::printf("made in memory: %.17g\n", greatest_x(mesh));
  OpenMesh::IO::write_mesh(mesh, "out.off", OpenMesh::IO::Options::Default, 17);
  OpenMesh::IO::write_mesh(mesh, "out.ply", OpenMesh::IO::Options::Binary);
  OpenMesh::IO::write_mesh(mesh, "out.om", OpenMesh::IO::Options::Binary);
  Mesh again;
  OpenMesh::IO::read_mesh(again, "out.om");
  std::printf("read again from OM: %.17g\n", greatest_x(again));
}
END
compile through_floats OpenMeshCore
cat > files.py << 'END'
import struct
import subprocess
import meshes

points, faces = meshes.tetrahedron(1 / 3)
meshes.write_off("third.off", points, faces)
meshes.write_obj("third.obj", points, faces)
with open("third.ply", "wb") as out:
    out.write(b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
              b"property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n")
    out.write(b"".join(struct.pack("<3d", *p) for p in points))
    out.write(b"".join(struct.pack("<B3i", 3, *f) for f in faces))
print(subprocess.run("./through_floats", capture_output=True, text=True).stdout, end="")
print("out.off:", open("out.off").read().split("\n")[3])
print("out.ply:", [line for line in open("out.ply", "rb").read().split(b"\n") if line.endswith(b" x")][0].decode())
data = open("out.om", "rb").read()
print("out.om holds 1 / 3 as a double: %s, as a float: %s" % (
    struct.pack("<d", 1 / 3) in data, struct.pack("<f", 1 / 3) in data))
END
verdict "$(python3 files.py)" "read third.off: 0.3333333432674408
read third.obj: 0.3333333432674408
read third.ply: 0.3333333432674408
made in memory: 0.33333333333333331
read again from OM: 0.33333333333333331
out.off: 0.3333333432674408 0 0
out.ply: property float x
out.om holds 1 / 3 as a double: True, as a float: False"
