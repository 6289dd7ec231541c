#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenSCAD 2021.01 (openscad 2021.01-6): linear_extrude() of two-dimensional shapes, exported as OFF.
#
# Guess: as its solids are computed with exact numbers, a shape in the plane keeps its form whatever the size, and what
# is joined by a bridge stays joined.
# What happens: in the plane all coordinates are rounded to steps of 1/65536. Two squares of side 1 with a bridge are
# one body down to a width of 1.6e-5, and two from 1.5e-5 on, with no word. A disk of 24 corners with radius 0.001 has
# lost 2% of its area, with radius 0.0001 it is a square, and with 0.00002 it is nothing: "top level object is empty". A
# bridge between two cubes, in space, is kept down to 2e-6, where the six digits of the output end.
#
# Why it matters: a body with a known thin neck is quickly drawn this way, and the neck may not be there. The unit is
# the millimetre by habit only; who draws in metres has steps of 15 micrometres.
. "$(dirname "$0")/lib/packages.sh"
debian openscad=2021.01-6
export LD_LIBRARY_PATH="$LD_LIBRARY_PATH:$work/root/usr/lib"

cd "$work"
cat > shapes.py << 'END'
import math
import os
import subprocess
import meshes


def report(name, shape, area=None):
    with open("shape.scad", "w") as out:
        out.write(shape)
    if os.path.exists("shape.off"):
        os.remove("shape.off")
    run = subprocess.run(["openscad", "-o", "shape.off", "shape.scad"], stderr=subprocess.PIPE, text=True)
    if not os.path.exists("shape.off"):
        print("%s: %s" % (name, run.stderr.strip().split("\n")[-1]))
        return
    points, faces = meshes.read_off("shape.off")
    text = "%s: V %d, components %d" % (name, len(points), meshes.components(faces))
    print(text if area is None else text + ", volume %.2f of what it should be" % (meshes.volume(points, faces) / area))


for width in (1e-4, 1.6e-5, 1.5e-5):
    report("squares, bridge %g" % width, "linear_extrude(1) union() { square(1); translate([2, 0]) square(1); "
           "translate([0.5, 0.5]) square([2, %g]); }" % width)
for width in (1.5e-5, 2e-6, 1e-6):
    report("cubes, bridge %g" % width, "union() { cube(1); translate([2, 0, 0]) cube(1); "
           "translate([0.5, 0.5, 0.5]) cube([2, %g, %g]); }" % (width, width))
for radius in (1, 1e-3, 1e-4, 2e-5):
    report("disk of radius %g" % radius, "scale(1 / %g) linear_extrude(%g) offset(delta = 0) circle(%g, $fn = 24);" %
           (radius, radius, radius), 12 * math.sin(math.pi / 12))
END
verdict "$(python3 shapes.py)" \
"squares, bridge 0.0001: V 24, components 1
squares, bridge 1.6e-05: V 24, components 1
squares, bridge 1.5e-05: V 16, components 2
cubes, bridge 1.5e-05: V 24, components 1
cubes, bridge 2e-06: V 24, components 1
cubes, bridge 1e-06: V 16, components 2
disk of radius 1: V 48, components 1, volume 1.00 of what it should be
disk of radius 0.001: V 48, components 1, volume 0.98 of what it should be
disk of radius 0.0001: V 8, components 1, volume 0.54 of what it should be
disk of radius 2e-05: Current top level object is empty."
