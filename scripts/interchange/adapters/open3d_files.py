# SPDX-License-Identifier: GPL-3.0-or-later
"""Open3D: reads a file, says what it holds, writes it in the same format: IN HELD OUT ..."""
import sys
import held
import numpy as np
import open3d


def convert(source, report, target):
    open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
    if source.endswith("curves.ply"):
        lines = open3d.io.read_line_set(source)
        held.save(report, np.asarray(lines.points), edges=np.asarray(lines.lines),
                  edge={"colours": np.asarray(lines.colors)} if lines.has_colors() else {})
        open3d.io.write_line_set(target, lines)
    else:
        mesh = open3d.io.read_triangle_mesh(source)
        if len(mesh.vertices) == 0:
            sys.exit("not read")
        held.save(report, np.asarray(mesh.vertices), np.asarray(mesh.triangles),
                  point={"colours": np.asarray(mesh.vertex_colors)} if mesh.has_vertex_colors() else {})
        if source.endswith("stl"):
            mesh.compute_triangle_normals()
        if not open3d.io.write_triangle_mesh(target, mesh):
            sys.exit("not written")


held.each(convert)
