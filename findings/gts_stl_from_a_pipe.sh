#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# GTS 0.7.6 (libgts-bin 0.7.6+darcs121130-5+b1): stl2gts and gtscheck.
#
# Guess: stl2gts, which reads standard input, gives the same surface from a file as from a pipe, or an error; and
# gtscheck says of a surface without faces that there is nothing to check.
# What happens: binary STL from a pipe, as gunzip makes one, gives a surface with no vertex, and exit code 0; from a
# file, or as text from a pipe, the torus is there. Without merging of vertices (--nomerge) nothing is said, with it
# GLib complains of an assertion of another function. gtscheck answers 0 for the empty surface, "a closed, orientable
# non self-intersecting manifold".
#
# Why it matters: large meshes are kept compressed, and unpacked into a pipe. A script that asks gtscheck before it
# searches for loops is told that all is well, and finds a body without a neck.
. "$(dirname "$0")/lib/packages.sh"
debian libgts-bin=0.7.6+darcs121130-5+b1

cd "$work"
cat > torus.py << 'END'
import meshes

points, faces = meshes.torus()
triangles = [[points[i] for i in f] for f in faces]
meshes.write_stl("binary.stl", triangles)
with open("text.stl", "w") as out:
    out.write("solid torus\n")
    for t in triangles:
        corners = "".join("vertex %r %r %r\n" % p for p in t)
        out.write("facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet\n")
    out.write("endsolid torus\n")
END
python3 torus.py
gzip -k text.stl binary.stl

checked() { # WHAT; the surface is in out.gts
  local code=0
  gtscheck < out.gts > gtscheck.out 2> gtscheck.log || code=$?
  echo "$1: exit code $2, vertices, edges and faces $(head -1 out.gts | cut -d ' ' -f 1-3); gtscheck $code"
}

seen=$(
  for kind in text binary; do
    stl2gts < "$kind.stl" > out.gts
    checked "$kind STL from a file" $?
    gunzip -c "$kind.stl.gz" | stl2gts > out.gts 2> stl2gts.log
    checked "$kind STL from a pipe" $?
    gunzip -c "$kind.stl.gz" | stl2gts --nomerge > out.gts 2> stl2gts.log
    checked "$kind STL from a pipe, --nomerge, $(wc -l < stl2gts.log) messages" $?
  done
)
verdict "$seen" \
"text STL from a file: exit code 0, vertices, edges and faces 288 864 576; gtscheck 0
text STL from a pipe: exit code 0, vertices, edges and faces 288 864 576; gtscheck 0
text STL from a pipe, --nomerge, 0 messages: exit code 0, vertices, edges and faces 1728 1728 576; gtscheck 3
binary STL from a file: exit code 0, vertices, edges and faces 288 864 576; gtscheck 0
binary STL from a pipe: exit code 0, vertices, edges and faces 0 0 0; gtscheck 0
binary STL from a pipe, --nomerge, 0 messages: exit code 0, vertices, edges and faces 0 0 0; gtscheck 0"
