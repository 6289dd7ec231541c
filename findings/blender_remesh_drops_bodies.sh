#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Blender 3.4.1 (blender 3.4.1+dfsg-2+b1), the modifier Remesh with its defaults but for the fineness.
#
# Guess: what is smaller than a cell of the grid is lost, so that two balls on a thin neck come back as two bodies; two
# bodies apart come back as two.
# What happens: of two tori side by side only the larger one comes back by the modes Sharp, Smooth and Blocks. "Remove
# Disconnected" is on, with a threshold that leaves the largest body only. These three never cut a neck, whatever its
# width, but the length around it is a third more by Sharp, a third less by Smooth, and always that of a cell by Blocks,
# 0.28 for 0.0031. By the mode Voxel a neck of a tenth of a cell is cut, and a third closed body is left between the
# two.
#
# Why it matters: scans are remeshed to be clean before necks are looked for. The result is closed and smooth in each
# case; whole bodies are gone, or there is a body that nobody put there, and the length of a neck is that of the mode.
. "$(dirname "$0")/lib/blender.sh"
modules="$(realpath "$(dirname "$0")/lib")"

cd "$work"
cat > remesh.py << 'END'
import math
import sys

sys.path.insert(0, sys.argv[-1])
import bpy
import meshes


def length_around(points, faces, z):
    """The length of the section at the height z."""
    total = 0
    for f in faces:
        cut = []
        for a, b in zip(f, f[1:] + f[:1]):
            p, q = points[a], points[b]
            if (p[2] < z) != (q[2] < z):
                t = (z - p[2]) / (q[2] - p[2])
                cut.append([x + t * (y - x) for x, y in zip(p, q)])
        total += math.dist(*cut) if len(cut) == 2 else 0
    return total


def remeshed(mesh, mode):
    data = bpy.data.meshes.new("body")
    data.from_pydata(mesh[0], [], mesh[1])
    body = bpy.data.objects.new("body", data)
    bpy.context.collection.objects.link(body)
    modifier = body.modifiers.new("remesh", "REMESH")
    modifier.mode = mode
    modifier.octree_depth = 5
    modifier.voxel_size = 0.05
    out = body.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    return [tuple(v.co) for v in out.vertices], [tuple(p.vertices) for p in out.polygons]


torus, ring = meshes.torus(), meshes.torus(scale=0.5)
two = torus[0] + [(x + 8, y, z) for x, y, z in ring[0]], torus[1] + [tuple(len(torus[0]) + i for i in f)
                                                                     for f in ring[1]]
for mode in ("SHARP", "SMOOTH", "BLOCKS", "VOXEL"):
    for neck in (0.05, 0.005, 0.0005):
        points, faces = remeshed(meshes.dumbbell(neck), mode)
        print("\n> %s, neck of %g, around it %.2g: bodies %d, around it %.2g" % (
            mode, neck, length_around(*meshes.dumbbell(neck), 0.01), meshes.components(faces),
            length_around(points, faces, 0.01)))
    print("\n> %s, two tori: bodies %d" % (mode, meshes.components(remeshed(two, mode)[1])))
END
verdict "$(HOME="$work" blender --background --factory-startup --python remesh.py -- "$modules" 2> blender.log |
  grep '^>')" \
"> SHARP, neck of 0.05, around it 0.31: bodies 1, around it 0.41
> SHARP, neck of 0.005, around it 0.031: bodies 1, around it 0.041
> SHARP, neck of 0.0005, around it 0.0031: bodies 1, around it 0.0041
> SHARP, two tori: bodies 1
> SMOOTH, neck of 0.05, around it 0.31: bodies 1, around it 0.2
> SMOOTH, neck of 0.005, around it 0.031: bodies 1, around it 0.02
> SMOOTH, neck of 0.0005, around it 0.0031: bodies 1, around it 0.002
> SMOOTH, two tori: bodies 1
> BLOCKS, neck of 0.05, around it 0.31: bodies 1, around it 0.28
> BLOCKS, neck of 0.005, around it 0.031: bodies 1, around it 0.28
> BLOCKS, neck of 0.0005, around it 0.0031: bodies 1, around it 0.28
> BLOCKS, two tori: bodies 1
> VOXEL, neck of 0.05, around it 0.31: bodies 1, around it 0.28
> VOXEL, neck of 0.005, around it 0.031: bodies 3, around it 0.02
> VOXEL, neck of 0.0005, around it 0.0031: bodies 3, around it 0.002
> VOXEL, two tori: bodies 2"
