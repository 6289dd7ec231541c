#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Slic3r 1.3.0 (slic3r 1.3.0+dfsg1-5+b2) and PrusaSlicer 2.5.0 (prusa-slicer 2.5.0+dfsg-4), --info of cubes in binary
# STL whose normals are 0, as many programs write them for readers that compute them.
#
# Guess: each file is read. Its length is that of the number of its triangles, so that it cannot be text.
# What happens: whether a file is binary is decided by its first bytes after the header: one of them must be greater
# than 127. 0, 2, 3, 10, 12, 15, 40 and 50 have no such byte as floats, and 1, 20, 25 and everything below zero have: a
# cube of 10 mm in a corner of the axes is taken for text, in which no triangle is found, "empty" to the one and
# "Loading of a model file failed" to the other, and a cube of 20 mm is read. The cube of 10 mm around the origin is
# read as well, and so is one with one normal written, or with the two free bytes of the first triangle set.
#
# Why it matters: parts that were cut at constrictions go to a printer as binary STL, and what fails is the simplest
# body, the one that one tests with. Normals other than 0 decide: a unit vector along an axis has a byte of 128. The
# program here writes them.
. "$(dirname "$0")/lib/packages.sh"
debian slic3r=1.3.0+dfsg1-5+b2 prusa-slicer=2.5.0+dfsg-4
PERL5LIB="$(dirname "$(find "$work/root/" -name Slic3r.pm)"):$work/root/usr/lib/$triplet/perl5/5.36"
export PERL5LIB+=":$work/root/usr/share/perl5" HOME="$work"

cd "$work"
cat > write.py << 'END'
import struct
import meshes


def cube(size, low=0):
    points = [(low + size * x, low + size * y, low + size * z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    sides = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return points, [f for a, b, c, d in sides for f in ((a, b, c), (a, c, d))]


def triangles(points, faces):
    return [[points[i] for i in f] for f in faces]


for size in (1, 2, 3, 10, 12, 15, 20, 25, 40, 50):
    meshes.write_stl("cube_of_%02d.stl" % size, triangles(*cube(size)))
meshes.write_stl("cube_around_origin.stl", triangles(*cube(10, -5)))
meshes.write_stl("torus.stl", triangles(*meshes.torus(scale=10)))
with open("cube_of_10.stl", "rb") as file:
    data = bytearray(file.read())
with open("cube_of_10_high_byte.stl", "wb") as out:  # the two free bytes of the first triangle
    out.write(data[:84 + 48] + b"\x00\x80" + data[84 + 50:])
with open("cube_of_10_normals.stl", "wb") as out:
    data[84:96] = struct.pack("<3f", -1, 0, 0)
    out.write(data)
END
python3 write.py

checked() { # PROGRAM COMMAND ...
  local program=$1 code=0
  shift
  "$@" --info "$mesh" > info.out 2> info.log || code=$?
  echo "$program $code, $(sed -n 's/^number_of_facets = */facets /p; s/.*because it.s \(empty\)\./\1/p
    s/.*: \(Loading.*\)\./\1/p' info.out info.log | tail -1)"
}

seen=$(
  for mesh in *.stl; do
    echo "$mesh: $(checked Slic3r perl "$work/root/usr/bin/slic3r"); $(checked PrusaSlicer prusa-slicer)"
  done
)
verdict "$seen" \
"cube_around_origin.stl: Slic3r 0, facets 12; PrusaSlicer 0, facets 12
cube_of_01.stl: Slic3r 0, facets 12; PrusaSlicer 0, facets 12
cube_of_02.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
cube_of_03.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
cube_of_10.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
cube_of_10_high_byte.stl: Slic3r 0, facets 12; PrusaSlicer 0, facets 12
cube_of_10_normals.stl: Slic3r 0, facets 12; PrusaSlicer 0, facets 12
cube_of_12.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
cube_of_15.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
cube_of_20.stl: Slic3r 0, facets 12; PrusaSlicer 0, facets 12
cube_of_25.stl: Slic3r 0, facets 12; PrusaSlicer 0, facets 12
cube_of_40.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
cube_of_50.stl: Slic3r 2, empty; PrusaSlicer 1, Loading of a model file failed
torus.stl: Slic3r 0, facets 576; PrusaSlicer 0, facets 576"
