#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# PCL 1.13.0 (pcl-tools 1.13.0+dfsg-3): pcl_ply2obj and pcl_ply2raw of PLY files with "property double x".
#
# Guess: doubles are read, at worst as floats, and the exit code says whether the file was converted.
# What happens: the tools warn that the properties are "not handled", and write the mesh all the same, with every vertex
# at the origin: all faces are there, and the body is a point. With "property float" the same file is converted. The
# exit code is 1 in both cases. pcl_ply2ply copies the doubles, with six digits, and also ends with 1.
#
# Why it matters: CGAL, and the program here, write the points of a mesh as doubles. A script that looks at exit codes
# drops the good files too, and one that does not goes on with a point.
. "$(dirname "$0")/lib/packages.sh"
debian pcl-tools=1.13.0+dfsg-3

cd "$work"
cat > convert.py << 'END'
import subprocess
import meshes

points, faces = meshes.tetrahedron(1 / 3)
for kind in ("float", "double"):
    with open("in.ply", "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex 4\nproperty {0} x\nproperty {0} y\nproperty {0} z\n"
                  "element face 4\nproperty list uchar int vertex_indices\nend_header\n".format(kind))
        out.writelines("%r %r %r\n" % tuple(map(float, p)) for p in points)
        out.writelines("3 %d %d %d\n" % f for f in faces)
    for tool in ("obj", "ply", "raw"):
        run = subprocess.run(["pcl_ply2" + tool, "in.ply", "out." + tool], capture_output=True, text=True)
        if tool == "obj":
            result, triangles = meshes.read_obj("out.obj")
            seen = "faces %d, greatest coordinate %g" % (len(triangles), max(map(max, result)))
        elif tool == "ply":
            body = open("out.ply").read().split("end_header\n")[1].split("\n")
            seen = "second vertex at %s" % body[1].strip()
        else:
            seen = "greatest coordinate %g" % max(float(w) for w in open("out.raw").read().split())
        print("%s, pcl_ply2%s: %s; warnings %d, exit code %d" % (
            kind, tool, seen, run.stderr.count("not handled"), run.returncode))
END
verdict "$(python3 convert.py)" \
"float, pcl_ply2obj: faces 4, greatest coordinate 0.333333; warnings 0, exit code 1
float, pcl_ply2ply: second vertex at 0.333333 0 0; warnings 0, exit code 1
float, pcl_ply2raw: greatest coordinate 0.333333; warnings 0, exit code 1
double, pcl_ply2obj: faces 4, greatest coordinate 0; warnings 3, exit code 1
double, pcl_ply2ply: second vertex at 0.333333 0 0; warnings 0, exit code 1
double, pcl_ply2raw: greatest coordinate 0; warnings 3, exit code 1"
