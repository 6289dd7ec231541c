#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# MRtrix 3.0.3 (mrtrix3 3.0.3-3+b1), voxel2mesh and label2mesh, of masks with the values 0 and 1 in NIfTI.
#
# Guess: "an appropriate threshold" that voxel2mesh determines by itself lies between 0 and 1, and the surface passes
# halfway between a voxel inside and a voxel outside, as that of label2mesh does.
# What happens: the threshold is next to 0, and the surface passes through the centres of the voxels outside. One voxel
# becomes a body of the volume 1.33, label2mesh makes one of 0.17. A ball of 4169 voxels has 4687 instead of 4148; the
# girth of a bridge of single voxels between two balls is 5.65 instead of 2.83, a pit one voxel wide through a plate
# closes to 0.002, and so does the gap between two blocks with one voxel between them. With -threshold 0.5 all of this
# is as with label2mesh.
#
# Why it matters: the thinnest neck is what doubles, and the thinnest hole is what is gone. A mask from a segmentation
# is the usual input for a surface, and both commands are from the same package.
. "$(dirname "$0")/lib/packages.sh"
debian mrtrix3=3.0.3-3+b1

cd "$work"
cat > masks.py << 'END'
import math
import struct
import subprocess
import sys
import meshes

n = 31


def write_nifti(name, inside):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, n, n, n, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)  # unsigned bytes
    struct.pack_into("<8f", header, 76, *[1] * 8)
    struct.pack_into("<2f", header, 108, 352, 1)
    struct.pack_into("<h", header, 254, 1)  # the matrix that follows
    struct.pack_into("<12f", header, 280, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)
    header[123], header[344:348] = 2, b"n+1\0"
    with open(name, "wb") as out:
        out.write(header + bytes(inside(x, y, z) for z in range(n) for y in range(n) for x in range(n)))


def ball(x, y, z, at, radius):
    return (x - at) ** 2 + (y - 15) ** 2 + (z - 15) ** 2 <= radius ** 2


def girth(points, faces):
    """The length of the section of the bridge at x = 15, where it has vertices."""
    ring = {p[1:] for p in points if abs(p[0] - 15) < 1e-6}
    around = sorted(ring, key=lambda p: math.atan2(p[1] - 15, p[0] - 15))
    return "girth of the bridge %.2f" % sum(math.dist(p, q) for p, q in zip(around, around[1:] + around[:1]))


def width(points, faces):
    wall = [p for p in points if abs(p[0] - 15) < 2 and p[1] == p[2] == 15]
    return "width of the pit %.3f" % (max(p[0] for p in wall) - min(p[0] for p in wall))


def gap(points, faces):
    return "gap %.3f" % (min(p[0] for p in points if p[0] > 9.9999) - max(p[0] for p in points if p[0] < 10.0001))


masks = [("one voxel", lambda x, y, z: x == y == z == 15, None),
         ("ball", lambda x, y, z: ball(x, y, z, 15, 10), None),
         ("bridge", lambda x, y, z: ball(x, y, z, 7, 6) or ball(x, y, z, 23, 6) or (y == z == 15 and 5 < x < 25), girth),
         ("plate with a pit", lambda x, y, z: abs(z - 15) <= 1 and 1 <= max(abs(x - 15), abs(y - 15)) <= 8, width),
         ("two blocks", lambda x, y, z: 5 <= x < 16 and x != 10 and 5 <= y < 10 and 5 <= z < 10, gap)]
for name, inside, measure in masks:
    write_nifti("mask.nii", inside)
    for command in (["voxel2mesh"], ["voxel2mesh", "-threshold", "0.5"], ["label2mesh"]):
        subprocess.run(command + ["mask.nii", "mask.obj", "-quiet", "-force"], check=True)
        points, faces = meshes.read_obj("mask.obj")
        print("%s, %s: closed %s, volume %.2f%s" % (
            name, " ".join(command), "border edges 0, non-manifold edges 0" in meshes.describe(faces),
            meshes.volume(points, faces), ", " + measure(points, faces) if measure else ""))
END
export LD_LIBRARY_PATH="$LD_LIBRARY_PATH:$work/root/usr/lib/mrtrix3/lib"
verdict "$(python3 masks.py)" \
"one voxel, voxel2mesh: closed True, volume 1.33
one voxel, voxel2mesh -threshold 0.5: closed True, volume 0.17
one voxel, label2mesh: closed True, volume 0.17
ball, voxel2mesh: closed True, volume 4686.88
ball, voxel2mesh -threshold 0.5: closed True, volume 4147.83
ball, label2mesh: closed True, volume 4147.83
bridge, voxel2mesh: closed True, volume 2243.11, girth of the bridge 5.65
bridge, voxel2mesh -threshold 0.5: closed True, volume 1824.83, girth of the bridge 2.83
bridge, label2mesh: closed True, volume 1824.83, girth of the bridge 2.83
plate with a pit, voxel2mesh: closed True, volume 1219.21, width of the pit 0.002
plate with a pit, voxel2mesh -threshold 0.5: closed True, volume 847.00, width of the pit 1.000
plate with a pit, label2mesh: closed True, volume 847.00, width of the pit 1.000
two blocks, voxel2mesh: closed True, volume 370.37, gap 0.002
two blocks, voxel2mesh -threshold 0.5: closed True, volume 236.33, gap 1.000
two blocks, label2mesh: closed True, volume 236.33, gap 1.000"
