# SPDX-License-Identifier: GPL-3.0-or-later
"""trimesh: reads a file, says what it holds, writes it in the same format: IN HELD OUT ..."""
import sys
import held
import trimesh


def convert(source, report, target):
    mesh = trimesh.load(source)
    names, points, faces, edges, face, point = [], [], [], [], {}, {}
    parts = mesh.geometry.items() if isinstance(mesh, trimesh.Scene) else [("", mesh)]
    for name, part in parts:
        first = len(points)
        names.append(name)
        points += part.vertices.tolist()
        if isinstance(part, trimesh.Trimesh):
            faces += (part.faces + first).tolist()
            if part.visual.kind == "face":
                face.setdefault("colours", []).extend(part.visual.face_colors[:, :3].tolist())
            elif part.visual.kind == "texture":
                face.setdefault("colours", []).extend([part.visual.material.main_color[:3].tolist()] * len(part.faces))
            for key, values in part.face_attributes.items():
                face.setdefault(key, []).extend(held.plain(values))
            # What it knows no use for it keeps with the metadata.
            raw = part.metadata.get("_ply_raw", {}).get("face", {}).get("data")
            for key in (getattr(raw, "dtype", None) and raw.dtype.names) or ():
                if raw[key].ndim == 1 and raw[key].dtype.kind in "iuf":
                    face.setdefault(key, []).extend(raw[key].tolist())
        elif hasattr(part, "entities"):
            for entity in part.entities:
                edges += held.edges_of([first + int(i) for i in entity.points])
    held.save(report, points, faces, edges, names, face=face, point=point)
    mesh.export(target)


held.each(convert)
