#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Netgen 6.2.1905 (python3-netgen 6.2.2006+really6.2.1905+dfsg-5.1+b1), netgen.stl.LoadSTLGeometry() and GenerateMesh().
#
# Guess: STL is read as text and as binary, or what is not read is an error.
# What happens: of a torus in binary STL no triangle is read, and there is no exception. GenerateMesh() goes through all
# of its steps, writes "Success !!!!", and returns a mesh without points. The same torus as text is read and meshed. A
# file that is not there is the same as a binary one. The names .stl and .stlb make no difference.
#
# Why it matters: most files in STL are binary. A surface that is meshed here before its necks are looked for has none,
# as it has nothing, and the log says that all went well.
. "$(dirname "$0")/lib/packages.sh"
debian python3-netgen=6.2.2006+really6.2.1905+dfsg-5.1+b1 python3-tk
export LD_LIBRARY_PATH="$LD_LIBRARY_PATH:$work/root/usr/lib/$triplet/netgen:$work/root/usr/lib"
export PYTHONPATH="$PYTHONPATH:$work/root/usr/lib/python3.11:$work/root/usr/lib/python3.11/lib-dynload"

cd "$work"
cat > read.py << 'END'
import meshes
from netgen.stl import LoadSTLGeometry

points, faces = meshes.torus()
triangles = [[points[i] for i in f] for f in faces]
meshes.write_stl("binary.stl", triangles)
meshes.write_stl("binary.stlb", triangles)
with open("text.stl", "w") as out:
    out.write("solid torus\n")
    for t in triangles:
        out.write("facet normal 0 0 0\nouter loop\n")
        out.writelines("vertex %.9g %.9g %.9g\n" % p for p in t)
        out.write("endloop\nendfacet\n")
    out.write("endsolid torus\n")
for name in ("text.stl", "binary.stl", "binary.stlb", "nothing.stl"):
    mesh = LoadSTLGeometry(name).GenerateMesh(maxh=0.5)
    out = [tuple(v.nr for v in e.vertices) for e in mesh.Elements2D()]
    print("\n> %s: meshed %s; %s" % (name, len(mesh.Points()) > 0, ", ".join(meshes.describe(out).split(", ")[2:])))
END
python3 read.py > seen.txt
verdict "$(grep -E '^>|loaded|Success' seen.txt)" \
" 576 triangles loaded
 Success !!!!
 Success !
> text.stl: meshed True; components 1, Euler characteristic 0, border edges 0, non-manifold edges 0
 0 triangles loaded
 Success !!!!
> binary.stl: meshed False; components 0, Euler characteristic 0, border edges 0, non-manifold edges 0
 0 triangles loaded
 Success !!!!
> binary.stlb: meshed False; components 0, Euler characteristic 0, border edges 0, non-manifold edges 0
 0 triangles loaded
 Success !!!!
> nothing.stl: meshed False; components 0, Euler characteristic 0, border edges 0, non-manifold edges 0"
