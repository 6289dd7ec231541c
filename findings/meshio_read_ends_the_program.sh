#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshio as packaged by Debian 12 (python3-meshio 7.0.0-3): read() of OFF with a quadrilateral, and of PLY.
#
# Guess: the OFF file is read, as the OBJ file of the same surface is; PLY is read under both names that are in use for
# the list of a face, vertex_index and vertex_indices.
# What happens: read() prints that it reads triangles only and calls sys.exit(1): SystemExit passes through "except
# Exception", and a program that goes through a folder of meshes is over. A PLY file with "vertex_index", which is what
# three.js writes and what the first description of the format says, raises KeyError ('uchar', 'int').
#
# Why it matters: whoever runs a search over many files in Python must catch SystemExit. The batch command here gives
# each file a process (test Batch.crash_of_a_process).
. "$(dirname "$0")/lib/packages.sh"
debian python3-meshio=7.0.0-3

cd "$work"
cat > read.py << 'END'
import contextlib
import io
import meshio
import meshes

points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)]
faces = [(3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
meshes.write_off("pyramid.off", points, faces)
meshes.write_obj("pyramid.obj", points, faces)
for name, indices in (("vertex_index.ply", "vertex_index"), ("vertex_indices.ply", "vertex_indices")):
    with open(name, "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                  "element face 5\nproperty list uchar int %s\nend_header\n" % indices)
        out.writelines("%g %g %g\n" % p for p in points)
        out.writelines("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)
for name in ("pyramid.obj", "pyramid.off", "vertex_index.ply", "vertex_indices.ply"):
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            outcome = "%d faces" % sum(len(c.data) for c in meshio.read(name).cells)
        except Exception as error:
            outcome = "exception %s %s" % (type(error).__name__, error)
        except SystemExit as end:
            outcome = "SystemExit %s" % end
    print("%s: %s" % (name, outcome))
END
verdict "$(python3 read.py 2> /dev/null)" "pyramid.obj: 5 faces
pyramid.off: SystemExit 1
vertex_index.ply: exception KeyError ('uchar', 'int')
vertex_indices.ply: 5 faces"
