#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2), read_polygon_mesh() into a mesh with points of the exact kernel (Epeck).
#
# Guess: the same digits give the same exact points, whatever the format: either the double next to them or the fraction
# that they spell.
# What happens: "0.1" in OBJ is exactly 1/10, and in OFF, PLY and STL it is the double 0.1.
#
# Why it matters: an exact certificate is about one surface. That of the OBJ file in the exact kernel is another one than
# that of the OFF file, and than that of the OBJ file in a kernel of doubles: faces may be flat in one and not in the
# other. The program here takes doubles from all formats.
. "$(dirname "$0")/lib/packages.sh"
debian libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cd "$work"
cat > tenth.cpp << 'END'
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <cstdio>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  for(const char* name : {"tenth.off", "tenth.obj", "tenth.ply", "tenth.stl"})
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(name, mesh))
      return 1;
    int fractions = 0, doubles = 0;
    for(auto v : mesh.vertices())
    {
      fractions += mesh.point(v).x() == Kernel::FT(1) / 10;
      doubles += mesh.point(v).x() == Kernel::FT(0.1);
    }
    std::printf("%s: %d vertices, x is 1/10 at %d and the double 0.1 at %d\n", name, int(mesh.number_of_vertices()),
                fractions, doubles);
  }
}
END
compile tenth gmp mpfr
python3 - << 'END'
import meshes

points, faces = meshes.tetrahedron(0.1)
meshes.write_off("tenth.off", points, faces)
meshes.write_obj("tenth.obj", points, faces)
with open("tenth.ply", "w") as out:
    out.write("ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
              "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
    out.writelines("%s %s %s\n" % p for p in points)
    out.writelines("3 %d %d %d\n" % f for f in faces)
with open("tenth.stl", "w") as out:
    out.write("solid\n")
    for f in faces:
        out.write("facet normal 0 0 0\nouter loop\n")
        out.writelines("vertex %s %s %s\n" % points[i] for i in f)
        out.write("endloop\nendfacet\n")
    out.write("endsolid\n")
END
verdict "$(./tenth)" "tenth.off: 4 vertices, x is 1/10 at 0 and the double 0.1 at 1
tenth.obj: 4 vertices, x is 1/10 at 1 and the double 0.1 at 0
tenth.ply: 4 vertices, x is 1/10 at 0 and the double 0.1 at 1
tenth.stl: 4 vertices, x is 1/10 at 0 and the double 0.1 at 1"
