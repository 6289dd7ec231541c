#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenSceneGraph 3.6.5 (openscenegraph 3.6.5+dfsg1-8+b2), osgconv between OBJ and STL, and --simplify.
#
# Guess: a conversion keeps the coordinates, so that OBJ to OBJ is the same mesh; --simplify 0.5 leaves half of the
# triangles, or an error.
# What happens: what is read from OBJ is turned by 90 degrees around the x-axis, and what is written is not turned back:
# after one conversion to OBJ y has become z, after two the mesh is turned by 180 degrees. STL is not turned when it is
# read, so that one body from an OBJ and an STL file has two positions. "-O noRotation" is said to the reader. With
# --simplify OBJ is simplified and STL is not: each triangle has corners of its own there, nothing is merged, and all
# triangles are written, with success.
#
# Why it matters: curves that were found on the one file are looked at beside the other, and are 90 degrees away, and a
# mesh of a scan in STL stays as large as it was while the program that reduced it reports nothing.
. "$(dirname "$0")/lib/packages.sh"
debian openscenegraph=3.6.5+dfsg1-8+b2

cd "$work"
cat > turned.py << 'END'
import subprocess
import meshes


def converted(what, source, target, *options):
    subprocess.run(["osgconv", *options, source, target], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    points, faces = meshes.read_obj(target)
    sizes = ["%.2f" % (max(p[k] for p in points) - min(p[k] for p in points)) for k in range(3)]
    print("%s: sizes %s, first point %s, triangles %d, volume %.2f" % (
        what, " ".join(sizes), " ".join("%.2f" % c for c in points[0]), len(faces), meshes.volume(points, faces)))


points, faces = meshes.torus()
points = [(x, y, z + 5) for x, y, z in points]
meshes.write_obj("torus.obj", points, faces)
meshes.write_stl("torus.stl", [[points[i] for i in f] for f in faces])
converted("OBJ", "torus.obj", "once.obj")
converted("OBJ twice", "once.obj", "twice.obj")
converted("OBJ, noRotation", "torus.obj", "kept.obj", "-O", "noRotation")
converted("STL", "torus.stl", "stl.obj")
converted("OBJ, simplified", "torus.obj", "fewer.obj", "--simplify", "0.5")
converted("STL, simplified", "torus.stl", "fewer_stl.obj", "--simplify", "0.5")
END
verdict "$(python3 turned.py)" \
"OBJ: sizes 6.00 2.00 6.00, first point 3.00 -5.00 0.00, triangles 576, volume 37.27
OBJ twice: sizes 6.00 6.00 2.00, first point 3.00 0.00 -5.00, triangles 576, volume 37.27
OBJ, noRotation: sizes 6.00 6.00 2.00, first point 3.00 0.00 5.00, triangles 576, volume 37.27
STL: sizes 6.00 6.00 2.00, first point 3.00 0.00 5.00, triangles 576, volume 37.27
OBJ, simplified: sizes 6.00 2.00 6.00, first point -0.78 -5.00 -2.90, triangles 288, volume 36.79
STL, simplified: sizes 6.00 6.00 2.00, first point -3.00 0.00 5.00, triangles 576, volume 37.27"
