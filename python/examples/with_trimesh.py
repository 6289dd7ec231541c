# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows the constrictions of a mesh of any format that trimesh reads, as curves in a scene.

python with_trimesh.py MESH OUTPUT
"""

import sys

import numpy as np
import trimesh

import constrictions

mesh = trimesh.load(sys.argv[1], force="mesh")
found = constrictions.Surface(mesh.vertices, mesh.faces).detect()
curves = [trimesh.load_path(np.concatenate([c.points, c.points[:1]])) for c in found]
for part, color in zip(curves, trimesh.visual.interpolate(range(len(curves)))):
    part.colors = [color] * len(part.entities)
mesh.export(sys.argv[2])
scene = trimesh.Scene([mesh, *curves])
print(f"{len(found)} constrictions, {len(scene.geometry)} objects in the scene")
# prints: 3 constrictions, 4 objects in the scene
