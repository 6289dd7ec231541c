#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# scikit-image 0.19.3 (python3-skimage 0.19.3-8), measure.marching_cubes().
#
# Guess: the default method, made to be topologically correct, gives a closed manifold around ones in a volume of zeros,
# with its triangles facing outwards; the older method "lorensen" is the one to be wary of.
# What happens: around four voxels that touch at edges the default method makes three edges with four triangles, and
# "lorensen" none: there each voxel is a body of its own. By either the triangles face inwards, and the volume is negative,
# unless gradient_direction="ascent" is passed: by default the body is where the values are low.
#
# Why it matters: so does a segmented image become a mesh. A halfedge structure refuses edges with four triangles, and what
# goes by the orientation takes a neck of the body for one of the space around it. The program here pairs the triangles at
# such edges so that bodies stay apart (test Repair.bodies_that_share_an_edge_stay_apart), and goes by the sign of the
# volume.
. "$(dirname "$0")/lib/packages.sh"
debian python3-skimage=0.19.3-8

cat > "$work/surfaces.py" << 'END'
import numpy
import meshes
from skimage import measure

volume = numpy.zeros((5, 4, 4))
for voxel in ((1, 1, 1), (2, 1, 2), (2, 2, 1), (3, 1, 1)):
    volume[voxel] = 1
for options in ({}, {"method": "lorensen"}, {"gradient_direction": "ascent"}):
    points, faces, _, _ = measure.marching_cubes(volume, 0.5, **options)
    faces = [tuple(int(i) for i in f) for f in faces]
    print("%s: %s, volume %.2f" % (" ".join(options.values()) or "default", meshes.describe(faces), meshes.volume(points.tolist(), faces)))
END
verdict "$(/usr/bin/python3 "$work/surfaces.py")" \
"default: V 24, F 52, components 1, Euler characteristic 1, border edges 0, non-manifold edges 3, volume -1.33
lorensen: V 24, F 32, components 4, Euler characteristic 8, border edges 0, non-manifold edges 0, volume -0.67
ascent: V 24, F 52, components 1, Euler characteristic 1, border edges 0, non-manifold edges 3, volume 1.33"
