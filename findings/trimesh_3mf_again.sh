#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# trimesh 4.5.1 (python3-trimesh 4.5.1-3 of Debian 13), 3MF and PLY.
#
# Guess: a 3MF file that trimesh has written is read by it and written again as the same body; a binary PLY file of
# doubles is written as it was read.
# What happens: written once, the body is object 1, and the build names object 1. Read and written again, it is still
# object 1, but the build names object 2, which does not exist. trimesh logs "id 2 included but not defined!" and reads
# the body all the same; a reader that builds what is to be built finds nothing. PLY of doubles is read as doubles and
# written as floats, while OFF has ten decimals.
#
# Why it matters: parts for printing go as 3MF through scripts like this. The program here says that there is no object 2.
# And the same body has other coordinates in PLY and in OFF.
. "$(dirname "$0")/lib/packages.sh"
debian python3-numpy=1:1.24.2-1+deb12u1 python3-networkx=2.8.8-1 python3-lxml=4.9.2-1+b1
debian_13 python3-trimesh=4.5.1-3

cd "$work"
cat > again.py << 'END'
import re
import zipfile
import trimesh

print("version:", trimesh.__version__)
box = trimesh.creation.box((1 / 3, 1, 1))
box.export("once.3mf")
trimesh.load("once.3mf").export("again.3mf")
for name in "once", "again":
    text = zipfile.ZipFile(name + ".3mf").read("3D/3dmodel.model").decode()
    print("%s.3mf: objects %s, the build names %s, read: %d faces" % (
        name, re.findall(r'<object id="(\d+)"', text), re.findall(r'objectid="(\d+)"', text),
        sum(len(g.faces) for g in trimesh.load(name + ".3mf").geometry.values())))
with open("doubles.ply", "wb") as out:
    out.write(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
              b"property double z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n" % (
                  len(box.vertices), len(box.faces)) + box.vertices.astype("<f8").tobytes() +
              b"".join(b"\3" + f.astype("<i4").tobytes() for f in box.faces))
read = trimesh.load("doubles.ply", process=False)
print("PLY read:", read.vertices[:, 0].max())
read.export("floats.ply")
print("PLY written:", [w.decode() for w in open("floats.ply", "rb").read().split(b"\n") if w.endswith(b" x")])
print("OFF written:", read.export(file_type="off").split("\n")[2])
END
verdict "$(python3 again.py 2> trimesh.log)" "version: 4.5.1
once.3mf: objects ['1'], the build names ['1'], read: 12 faces
again.3mf: objects ['1'], the build names ['2'], read: 12 faces
PLY read: 0.16666666666666666
PLY written: ['property float x']
OFF written: -0.1666666667 -0.5000000000 -0.5000000000"
