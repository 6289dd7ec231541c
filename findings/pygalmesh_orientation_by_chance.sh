#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# pygalmesh 0.10.6 (python3-pygalmesh 0.10.6-1+b3): generate_surface_mesh(), remesh_surface(), generate_mesh().
#
# Guess: the surface of a body faces outwards, or at least one way; what is meshed are all parts of the body; and the
# triangles that come with a mesh of tetrahedra are its surface.
# What happens: of one torus with one seed, meshed eight times, some face outwards and some inwards. A surface that is
# remeshed has its triangles oriented at random, one by one: about every second edge is run through twice in one
# direction. Of two balls that lie apart only one is meshed, and one point of the other is left, unused; if they are
# nearer to each other both are there. With tetrahedra the triangles come twice, once for each orientation.
#
# Why it matters: what is measured on one side of a surface, volumes and the side on which a curve chokes, has a sign by
# chance, and no halfedge structure takes a surface without orientation. The program here turns the faces of a file
# (test Mesh_file.faces_of_another_orientation_are_turned), leaves out faces that come twice, and cannot know of the
# second ball.
. "$(dirname "$0")/lib/packages.sh"
debian python3-pygalmesh=0.10.6-1+b3

cd "$work"
cat > bodies.py << 'END'
import meshes
import pygalmesh


def faces_of(mesh):
    return [tuple(int(i) for i in f) for cells in mesh.cells if cells.type == "triangle" for f in cells.data]


def surface(body):
    mesh = pygalmesh.generate_surface_mesh(
        body, bounding_sphere_radius=6, min_facet_angle=30, max_radius_surface_delaunay_ball=0.2,
        max_facet_distance=0.1, verbose=False, seed=0)
    return [tuple(float(c) for c in p) for p in mesh.points], faces_of(mesh)


signs = set()
for _ in range(8):
    signs.add(meshes.volume(*surface(pygalmesh.Torus(1, 0.4))) > 0)
print("torus, eight times:", " and ".join({True: "outwards", False: "inwards"}[s] for s in sorted(signs)))
for place in (4, 2.5):
    balls = pygalmesh.Union([pygalmesh.Ball([0, 0, 0], 1), pygalmesh.Ball([place, 0, 0], 1)])
    points, faces = surface(balls)
    print("balls at 0 and %g: components %d, points without a face %d" % (
        place, meshes.components(faces), len(points) - len({i for f in faces for i in f})))
meshes.write_off("torus.off", *meshes.torus())
faces = faces_of(pygalmesh.remesh_surface(
    "torus.off", max_edge_size_at_feature_edges=0.5, min_facet_angle=25, max_radius_surface_delaunay_ball=0.5,
    max_facet_distance=0.1, verbose=False, seed=0))
directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
share = (len(directed) - len(set(directed))) / (len(directed) / 2)
print("remeshed torus: closed %s, oriented %s, edges run through twice in one direction: between 0.3 and 0.7 of all %s" %
      ("border edges 0, non-manifold edges 0" in meshes.describe(faces), len(directed) == len(set(directed)),
       0.3 < share < 0.7))
faces = faces_of(pygalmesh.generate_mesh(pygalmesh.Ball([0, 0, 0], 1), max_cell_circumradius=0.4, verbose=False, seed=0))
print("triangles of a ball of tetrahedra, for each three corners:",
      sorted({sum(sorted(f) == sorted(g) for g in faces) for f in faces}))
END
verdict "$(/usr/bin/python3 bodies.py)" \
"torus, eight times: inwards and outwards
balls at 0 and 4: components 1, points without a face 1
balls at 0 and 2.5: components 2, points without a face 0
remeshed torus: closed True, oriented False, edges run through twice in one direction: between 0.3 and 0.7 of all True
triangles of a ball of tetrahedra, for each three corners: [2]"
