#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Blender 3.4.1 (blender 3.4.1+dfsg-2+b1): File > Import > Wavefront (.obj), lines.
#
# Guess: an element "l 1 2 3 4 1" is a polyline through all of its points, as the format says, and a closed curve
# arrives as one.
# What happens: of each line the edge between its first two points arrives. The points that only the rest of it uses are
# dropped, and no word is said. The same curve as four lines of two points arrives whole. The importer of earlier
# versions, which 3.4 has still, in its menu as "legacy", reads both alike.
#
# Why it matters: curves on a surface are handed on as polylines. A closed geodesic becomes one short edge, somewhere.
. "$(dirname "$0")/lib/blender.sh"

cd "$work"
cat > lines.py << 'END'
import bpy

POINTS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


def report(name, elements, read):
    with open("square.obj", "w") as out:
        out.write("o square\n" + POINTS + elements)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    read(filepath="square.obj")
    mesh, = [thing.data for thing in bpy.data.objects]
    print("> %s: vertices %d, edges %d" % (name, len(mesh.vertices), len(mesh.edges)))


print("> Blender " + bpy.app.version_string)
ONE, FOUR = "l 1 2 3 4 1\n", "l 1 2\nl 2 3\nl 3 4\nl 4 1\n"
report("one line of five points", ONE, bpy.ops.wm.obj_import)
report("four lines of two points", FOUR, bpy.ops.wm.obj_import)
report("one line, legacy", ONE, bpy.ops.import_scene.obj)
report("four lines, legacy", FOUR, bpy.ops.import_scene.obj)
END
verdict "$(HOME="$work" blender --background --factory-startup --python lines.py 2> blender.log | grep '^>')" \
"> Blender 3.4.1
> one line of five points: vertices 2, edges 1
> four lines of two points: vertices 4, edges 4
> one line, legacy: vertices 4, edges 4
> four lines, legacy: vertices 4, edges 4"
