# SPDX-License-Identifier: GPL-3.0-or-later
"""meshio: reads a file, says what it holds, writes it in the same format: IN HELD OUT ..."""
import sys
import held
import meshio


def convert(source, report, target):
    # meshio.read() ends the program with a message that does not tell the reason; the reader of the format tells it.
    mesh = getattr(meshio, source.rsplit(".", 1)[1]).read(source)
    faces, edges, face, edge = [], [], {}, {}
    for i, block in enumerate(mesh.cells):
        rows = [list(map(int, row)) for row in block.data]
        of_faces = block.type in ("triangle", "quad", "polygon")
        if of_faces:
            faces += rows
        else:
            rows = [held.edges_of(row) for row in rows]
            edges += [pair for row in rows for pair in row]
        for key, values in mesh.cell_data.items():
            values = values[i].tolist()
            if of_faces:
                face.setdefault(key, []).extend(values)
            else:
                edge.setdefault(key, []).extend(v for v, row in zip(values, rows) for _ in row)
    held.save(report, mesh.points, faces, edges, point=mesh.point_data, face=face, edge=edge)
    meshio.write(target, mesh)


held.each(convert)
