#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# VisPy 0.6.6 (python3-vispy 0.6.6-3), vispy.geometry.create_sphere(), by its three methods.
#
# Guess: a sphere is a closed surface that faces outwards by each method, as they differ in the pattern of the triangles
# only. At least its triangles are oriented alike.
# What happens: by "latitude" it is as guessed. By "ico" most vertices are there twice, so that the surface has 1920
# border edges and Euler characteristic -328; with equal places joined it is closed. By "cube" it is six pieces, three
# of which face inwards: the volume by the faces is 0, and joining places leaves 48 edges that are run through twice in
# one direction.
#
# Why it matters: a sphere is the first thing one tests a program on. This one is refused as open or not oriented, or is
# taken for six disks, and whatever is found on it is a property of the seams.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vispy=0.6.6-3

cat > "$work/spheres.py" << 'END'
import meshes
from vispy.geometry import create_sphere


def report(name, mesh):
    points = [tuple(map(float, p[:3])) for p in mesh.get_vertices()]
    faces = [tuple(map(int, f)) for f in mesh.get_faces()]
    places = {}
    joined = [places.setdefault(tuple(round(c, 6) + 0.0 for c in p), len(places)) for p in points]
    merged = [tuple(joined[i] for i in f) for f in faces]
    directed = [e for f in merged for e in zip(f, f[1:] + f[:1])]
    print("%s: %s; faces outwards %d, volume %.3f" % (
        name, meshes.describe(faces), sum(meshes.volume(points, [f]) > 0 for f in faces),
        meshes.volume(points, faces) + 0.0))
    print("  with places joined: %s, run through twice in one direction %d" % (
        meshes.describe(merged), len(directed) - len(set(directed))))


report("latitude", create_sphere(rows=20, cols=20, method="latitude"))
report("ico", create_sphere(subdivisions=3, method="ico"))
report("cube", create_sphere(rows=8, cols=8, depth=8, method="cube"))
END
verdict "$(python3 "$work/spheres.py")" \
"latitude: V 382, F 760, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; faces outwards 760, volume 4.112
  with places joined: V 382, F 760, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, run through twice in one direction 0
ico: V 1272, F 1280, components 1, Euler characteristic -328, border edges 1920, non-manifold edges 0; faces outwards 1280, volume 4.153
  with places joined: V 642, F 1280, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, run through twice in one direction 0
cube: V 486, F 768, components 6, Euler characteristic 6, border edges 192, non-manifold edges 0; faces outwards 384, volume 0.000
  with places joined: V 386, F 768, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, run through twice in one direction 48"
