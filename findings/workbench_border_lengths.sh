#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Connectome Workbench 1.5.0 (connectome-workbench 1.5.0-2+b1): wb_command -border-length.
#
# Guess: the length of a border, "along the surface", is that of the polyline through its points, which lie on edges
# and are joined within triangles.
# What happens: a straight border across a flat grid has its length, 20. The border of half of a body, drawn around
# its neck by -metric-rois-to-border, is a closed polyline of length 0.312 in one plane, and is said to have 0.765.
# With four times as many vertices around the neck the polyline has length 0.314, and is said to have 1.81: a finer
# mesh makes it worse. With twice as many rings along the neck 0.765 becomes 0.541. The two circles around a torus are
# too long, too.
#
# Why it matters: for surfaces of the brain this is how the length of a loop is measured. What it gives for a neck is
# up to nearly six times the length, and says more about the triangles than about the curve.
. "$(dirname "$0")/lib/packages.sh"
debian connectome-workbench=1.5.0-2+b1 python3-nibabel=5.0.0-2

cd "$work"
cat > lengths.py << 'END'
import math
import re
import subprocess
import meshes
import nibabel.gifti as gifti
import numpy


def write(name, *arrays):
    of = gifti.GiftiMetaData({"AnatomicalStructurePrimary": "CortexLeft"})
    image = gifti.GiftiImage(meta=of)
    for intent, array in arrays:
        kind = "NIFTI_TYPE_INT32" if array.dtype == numpy.int32 else "NIFTI_TYPE_FLOAT32"
        image.add_gifti_data_array(gifti.GiftiDataArray(array, "NIFTI_INTENT_" + intent, kind, meta=of))
    image.to_filename(name)


def workbench(*arguments):
    return subprocess.run(["wb_command", *arguments], check=True, capture_output=True, text=True).stdout


def compare(name, points, faces, is_inside):
    write("mesh.surf.gii", ("POINTSET", numpy.array(points, numpy.float32)),
          ("TRIANGLE", numpy.array(faces, numpy.int32)))
    write("part.func.gii", ("SHAPE", numpy.array([is_inside(*p) for p in points], numpy.float32)))
    workbench("-metric-rois-to-border", "mesh.surf.gii", "part.func.gii", "name", "part.border")
    with open("part.border") as file:
        text = file.read()
    total = number = 0
    for vertices, weights in re.findall("<Vertices>(.*?)</Vertices>.*?<Weights>(.*?)</Weights>", text, re.DOTALL):
        corners = numpy.array(points)[numpy.array(vertices.split(), int)]
        curve = (corners * numpy.array(weights.split(), float)[:, None]).reshape(-1, 3, 3).sum(axis=1)
        total += sum(map(math.dist, curve, curve[1:]))
        number += len(curve)
        if 'Closed="True"' in text:
            total += math.dist(curve[-1], curve[0])
    said = float(workbench("-border-length", "part.border", "mesh.surf.gii", "-hide-border-name"))
    print("%s: %d points, length of the polyline %.3f, -border-length %.3f" % (name, number, total, said))


print("version:", re.findall("Version: (.*)", workbench("-version"))[0])
grid = [(i, j, 0) for i in range(21) for j in range(21)]
cells = [i * 21 + j for i in range(20) for j in range(20)]
faces = [f for a in cells for f in ((a, a + 21, a + 22), (a, a + 22, a + 1))]
compare("straight line", grid, faces, lambda x, y, z: x < 10)
for around, rings in ((16, 60), (64, 60), (16, 120)):
    compare("neck, %d vertices around, %d rings" % (around, rings), *meshes.dumbbell(0.05, around, rings),
            lambda x, y, z: z > 0.01)
compare("torus", *meshes.torus(), lambda x, y, z: z > 0.01)
END
verdict "$(/usr/bin/python3 lengths.py)" \
"version: 1.5.0
straight line: 41 points, length of the polyline 20.000, -border-length 20.000
neck, 16 vertices around, 60 rings: 32 points, length of the polyline 0.312, -border-length 0.765
neck, 64 vertices around, 60 rings: 128 points, length of the polyline 0.314, -border-length 1.810
neck, 16 vertices around, 120 rings: 32 points, length of the polyline 0.312, -border-length 0.541
torus: 96 points, length of the polyline 25.061, -border-length 42.155"
