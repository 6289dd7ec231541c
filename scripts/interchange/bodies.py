# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies with doubles that are no floats, as points and triangles, and their files in each format."""
import base64
import io
import itertools
import json
import math
import struct
import zipfile


def read_off(name):
    """An OFF file with a vertex or a face on each line, perhaps with colours behind it."""
    lines = [words for words in (line.split("#")[0].split() for line in open(name)) if words][1:]
    n, m = int(lines[0][0]), int(lines[0][1])
    return ([tuple(map(float, words[:3])) for words in lines[1:n + 1]],
            [tuple(map(int, words[1:4])) for words in lines[n + 1:n + m + 1]])


def turned(points):
    """Rotated about two axes, so that hardly a coordinate is a float or has few digits."""
    def about(i, j, angle, p):
        p = list(p)
        p[i], p[j] = (math.cos(angle) * p[i] - math.sin(angle) * p[j], math.sin(angle) * p[i] + math.cos(angle) * p[j])
        return tuple(p)
    return [about(1, 2, 0.7, about(0, 1, 0.3, p)) for p in points]


def flat_dumbbell():
    """Two boxes joined by a tube, all faces exactly flat and none parallel to an axis: whole numbers that are no
    floats, as those of a map in millimetres. Around the tube the surface is exactly that of a cylinder."""
    solid = {c for c in itertools.product(range(3), range(3), range(9)) if not 3 <= c[2] < 6 or c[:2] == (1, 1)}
    number, faces = {}, []
    for c in sorted(solid):
        for axis, side in itertools.product(range(3), (0, 1)):
            beside = tuple(x + (2 * side - 1) * (i == axis) for i, x in enumerate(c))
            if beside in solid:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            square = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(c)
                corner[axis] += side
                corner[u] += du
                corner[v] += dv
                square.append(number.setdefault(tuple(corner), len(number)))
            if not side:
                square.reverse()
            faces += [(square[0], square[1], square[2]), (square[0], square[2], square[3])]
    points = [(512345678.0 + 1001 * x + 101 * y - 47 * z, 540012345.0 - 93 * x + 1003 * y + 61 * z,
               2345678.0 + 53 * x - 77 * y + 1007 * z) for x, y, z in number]
    return points, faces


def off(points, faces):
    return ("OFF\n%d %d 0\n" % (len(points), len(faces)) + "".join("%r %r %r\n" % p for p in points) +
            "".join("3 %d %d %d\n" % f for f in faces)).encode()


def obj(points, faces):
    return ("".join("v %r %r %r\n" % p for p in points) +
            "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces)).encode()


def ply_header(form, points, faces):
    return ("ply\nformat %s 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (
                form, len(points), len(faces))).encode()


def ply(points, faces):
    return ply_header("binary_little_endian", points, faces) + b"".join(struct.pack("<3d", *p) for p in points) + b"".join(
        struct.pack("<B3i", 3, *f) for f in faces)


def ply_text(points, faces):
    return ply_header("ascii", points, faces) + ("".join("%r %r %r\n" % p for p in points) + "".join(
        "3 %d %d %d\n" % f for f in faces)).encode()


def ply_16_bit(points, faces):
    header = ply_header("binary_little_endian", points, faces).replace(b"uchar int", b"uchar ushort")
    return header + b"".join(struct.pack("<3d", *p) for p in points) + b"".join(
        struct.pack("<B3H", 3, *f) for f in faces)


def obj_with_line(points, faces):
    return obj(points, faces) + b"l 1 2\n"


def stl(points, faces):
    return bytes(80) + struct.pack("<I", len(faces)) + b"".join(
        struct.pack("<12f", 0, 0, 0, *(x for i in f for x in points[i])) + b"\0\0" for f in faces)


def stl_text(points, faces):
    return ("solid body\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % points[i] for i in f) + "endloop\nendfacet\n"
        for f in faces) + "endsolid body\n").encode()


def vtk(points, faces):
    return (b"# vtk DataFile Version 4.2\nbody\nBINARY\nDATASET POLYDATA\nPOINTS %d double\n" % len(points) +
            b"".join(struct.pack(">3d", *p) for p in points) +
            b"\nPOLYGONS %d %d\n" % (len(faces), 4 * len(faces)) +
            b"".join(struct.pack(">4i", 3, *f) for f in faces) + b"\n")


def vtk_text(points, faces):
    return ("# vtk DataFile Version 4.2\nbody\nASCII\nDATASET POLYDATA\nPOINTS %d double\n" % len(points) +
            "".join("%r %r %r\n" % p for p in points) + "POLYGONS %d %d\n" % (len(faces), 4 * len(faces)) +
            "".join("3 %d %d %d\n" % f for f in faces)).encode()


def vtp(points, faces):
    def array(kind, name, parts, values):
        data = struct.pack("<%d%s" % (len(values), {"Float64": "d", "Int64": "q"}[kind]), *values)
        text = base64.b64encode(struct.pack("<Q", len(data)) + data).decode()
        return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="binary">%s</DataArray>' % (
            kind, name, parts, text)
    return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
            'header_type="UInt64">\n<PolyData><Piece NumberOfPoints="%d" NumberOfVerts="0" NumberOfLines="0" '
            'NumberOfStrips="0" NumberOfPolys="%d">\n<Points>%s</Points>\n<Polys>%s\n%s</Polys>\n</Piece></PolyData>'
            '</VTKFile>\n' % (len(points), len(faces), array("Float64", "Points", 3, [x for p in points for x in p]),
                              array("Int64", "connectivity", 1, [i for f in faces for i in f]),
                              array("Int64", "offsets", 1, [3 * i + 3 for i in range(len(faces))]))).encode()


def glb(points, faces):
    data = b"".join(struct.pack("<3f", *p) for p in points)
    rounded = [struct.unpack("<3f", struct.pack("<3f", *p)) for p in points]
    indices = b"".join(struct.pack("<3I", *f) for f in faces)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data) + len(indices)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(data), "target": 34962},
                        {"buffer": 0, "byteOffset": len(data), "byteLength": len(indices), "target": 34963}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": [min(p[i] for p in rounded) for i in range(3)],
                       "max": [max(p[i] for p in rounded) for i in range(3)]},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(faces), "type": "SCALAR"}]}).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4s5I", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data) + len(indices), len(text), 0x4E4F534A,
                        0)[:20] + text + struct.pack("<2I", len(data) + len(indices), 0x004E4942) + data + indices)


def three_mf(points, faces):
    model = ('<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" xml:lang="en-US" '
             'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
             '<object id="1" type="model"><mesh><vertices>' +
             "".join('<vertex x="%r" y="%r" z="%r"/>' % p for p in points) + "</vertices><triangles>" +
             "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in faces) +
             '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>\n')
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in (
                ("[Content_Types].xml",
                 '<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/'
                 'content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.'
                 'relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.'
                 '3dmanufacturing-3dmodel+xml"/></Types>'),
                ("_rels/.rels",
                 '<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/'
                 'package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.'
                 'microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'),
                ("3D/3dmodel.model", model)):
            archive.writestr(zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0)), text)
    return out.getvalue()


# Name of a format: the ending of its files, the function that writes it.
FORMATS = {"OFF": ("off", off), "OBJ": ("obj", obj), "OBJ with a line": ("obj", obj_with_line),
           "PLY of 16 bits": ("ply", ply_16_bit), "PLY": ("ply", ply), "PLY text": ("ply", ply_text),
           "STL": ("stl", stl), "STL text": ("stl", stl_text), "VTK": ("vtk", vtk), "VTK text": ("vtk", vtk_text),
           "VTP": ("vtp", vtp), "GLB": ("glb", glb), "3MF": ("3mf", three_mf)}
