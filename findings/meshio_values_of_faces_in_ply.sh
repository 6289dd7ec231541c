#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshio as packaged by Debian 12 (python3-meshio 7.0.0-3; meshio.__version__ says 5.0.0), values of faces in PLY.
#
# Guess: a colour or a number of each face becomes cell data, whether the file is text or binary; cell data that are
# written are there when the file is read.
# What happens: in text they become cell data. The same file in binary is an error of Python, without a word about the
# file: "object of type 'numpy.int32' has no len()" with a number, "tuple index out of range" with a colour. Colours of
# vertices are read from both. Written as PLY, cell data are left out: text and binary of a mesh with a number for each
# triangle have none.
#
# Why it matters: binary PLY with coloured faces is what MeshLab, CGAL and the program here ("segment") write for parts.
# A script that converts parts has to take the numbers from JSON.
. "$(dirname "$0")/lib/packages.sh"
debian python3-meshio=7.0.0-3

cd "$work"
cat > values.py << 'END'
import struct
import meshio
import meshes

print("version:", meshio.__version__)
points, faces = meshes.tetrahedron()
colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n"


def file(name, binary, properties, values, vertex_properties="", vertex_values=()):
    head = ("ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n%selement face 4\n"
            "property list uchar int vertex_indices\n%send_header\n" % (
                "binary_little_endian" if binary else "ascii", vertex_properties, properties)).encode()
    with open(name, "wb") as out:
        out.write(head)
        for p in points:
            out.write(struct.pack("<3f", *p) + bytes(vertex_values) if binary else
                      (" ".join(map(str, p + tuple(vertex_values))) + "\n").encode())
        for f in faces:
            code = "<B3i%s" % ("i" if "int" in properties else "B" * len(values))
            out.write(struct.pack(code, 3, *f, *values) if binary else
                      (" ".join(map(str, (3,) + f + tuple(values))) + "\n").encode())


def say(what, name):
    for binary in (False, True):
        try:
            mesh = meshio.ply.read(name % binary)
            print("%s, %s: cell data %s, point data %s" % (what, "binary" if binary else "text", sorted(mesh.cell_data),
                                                           sorted(mesh.point_data)))
        except Exception as error:
            print("%s, %s: %s: %s" % (what, "binary" if binary else "text", type(error).__name__, error))


for binary in (False, True):
    file("vertex_%s.ply" % binary, binary, "", (), colour, (1, 2, 3))
    file("number_%s.ply" % binary, binary, "property int patch\n", (7,))
    file("colour_%s.ply" % binary, binary, colour, (1, 2, 3))
    meshio.Mesh(points, [("triangle", faces)], cell_data={"patch": [[0, 1, 2, 3]]}).write(
        "written_%s.ply" % binary, binary=binary)
say("a colour for each vertex", "vertex_%s.ply")
say("a number for each face", "number_%s.ply")
say("a colour for each face", "colour_%s.ply")
say("a number for each face, written by meshio", "written_%s.ply")
END
verdict "$(python3 values.py 2> warnings.log)" "version: 5.0.0
a colour for each vertex, text: cell data [], point data ['blue', 'green', 'red']
a colour for each vertex, binary: cell data [], point data ['blue', 'green', 'red']
a number for each face, text: cell data ['patch'], point data []
a number for each face, binary: TypeError: object of type 'numpy.int32' has no len()
a colour for each face, text: cell data ['blue', 'green', 'red'], point data []
a colour for each face, binary: IndexError: tuple index out of range
a number for each face, written by meshio, text: cell data [], point data []
a number for each face, written by meshio, binary: cell data [], point data []"
