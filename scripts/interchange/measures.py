# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program has kept of a mesh, of curves, and of parts."""
import json
import math
import pathlib
import re
import struct
import subprocess

import bodies


class Constrictions:
    """The program of this project."""

    def __init__(self, program):
        self.program = str(program)

    def run(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True)

    def made(self, *arguments):
        done = self.run(*arguments)
        if done.returncode:
            raise RuntimeError("constrictions %s: %s" % (" ".join(map(str, arguments)), done.stderr.strip()))
        return done

    def mesh_of(self, name):
        """Points, faces and repairs of a file, or None and what is wrong."""
        canonical = str(name) + ".as_read.off"
        done = self.run("check", name, "-o", canonical, "--json", canonical + ".json")
        if not pathlib.Path(canonical).exists():
            return None, (done.stderr.strip().splitlines() or ["?"])[-1]
        return bodies.read_off(canonical), json.load(open(canonical + ".json"))["mesh"]

    def certified(self, mesh, curves):
        """How many of the curves are certified on the mesh, and of how many."""
        done = self.run("certify", mesh, "--curves", curves, "--quiet")
        lines = [line for line in done.stdout.splitlines() if line.strip()]
        total = len(json.load(open(curves))["constrictions"])
        return sum(not line.split()[1].startswith("not_certified") for line in lines), total


def write_originals(own, folder, mesh):
    """For each format the bodies, each with its file, its curves, and its points and faces as they are in the file."""
    points, faces = bodies.read_off(mesh)
    result = {}
    for body, data in (("round", (bodies.turned(points), faces)), ("flat", bodies.flat_dumbbell())):
        for form, (ending, write) in bodies.FORMATS.items():
            name = folder / ("%s_%s.%s" % (body, form.replace(" ", "_"), ending))
            name.write_bytes(write(*data))
            curves = str(name) + ".curves.json"
            own.made("detect", name, "--json", curves, "--quiet")
            certified, total = own.certified(name, curves)
            if certified != total or total == 0:
                raise RuntimeError("%s: %d of %d curves are certified" % (name, certified, total))
            result.setdefault(form, []).append((name, curves, own.mesh_of(name)[0]))
    return result


def rounded(x):
    try:
        return struct.unpack("<f", struct.pack("<f", x))[0]
    except OverflowError:
        return math.inf


def kind_of_rounding(pairs, body_size):
    """How the second numbers of the pairs come from the first ones."""
    if all(x == y for x, y in pairs):
        return "yes"
    if all(rounded(x) == y for x, y in pairs):
        return "float"
    for before, name in ((float, ""), (rounded, "float, ")):
        for after in (float, rounded):
            for digits in range(4, 18):
                if all(after(float("%.*g" % (digits, before(x)))) == y for x, y in pairs):
                    return "%s%d digits" % (name, digits)
            for digits in range(1, 18):
                if all(after(float("%.*f" % (digits, before(x)))) == y for x, y in pairs):
                    return "%s%d decimals" % (name, digits)
        # Digits enough for a float.
        if all(rounded(x) == rounded(y) for x, y in pairs):
            return "float"
    worst = max(abs(x - y) for x, y in pairs) / body_size
    return "off by %.0e of its size" % worst if worst < 0.5 else "wrong"


def size(points):
    return max(max(p[i] for p in points) - min(p[i] for p in points) for i in range(3))


def nearest(points, others):
    """For each of the other points the number of the nearest one. Points in the same order are recognised."""
    bound = 0.02 * size(points)
    if len(points) == len(others) and all(math.dist(p, q) <= bound for p, q in zip(points, others)):
        return list(range(len(points)))
    known = {}
    for i, p in enumerate(points):
        known.setdefault(p, i)
    for q in others:
        if q not in known:
            known[q] = min(range(len(points)), key=lambda i: math.dist(points[i], q))
    return [known[q] for q in others]


def turned_to_smallest(face):
    at = face.index(min(face))
    return face[at:] + face[:at]


def compare(mesh, other):
    """Coordinates, vertices and faces of the second mesh as words."""
    points, faces = mesh
    others, other_faces = other
    if not others or not other_faces:
        return ["lost", "lost", "lost"]
    if any(not math.isfinite(x) for q in others for x in q):
        return ["wrong", "", ""]
    match, coordinates = list(range(len(points))), "off"
    if len(points) == len(others):
        coordinates = kind_of_rounding([(x, y) for p, q in zip(points, others) for x, y in zip(p, q)], size(points))
    if coordinates.startswith(("off", "wrong")):
        match = nearest(points, others)
        coordinates = kind_of_rounding([(x, y) for i, q in zip(match, others) for x, y in zip(points[i], q)],
                                       size(points))
    if coordinates == "wrong":
        return ["wrong", "", ""]
    if match == list(range(len(points))):
        vertices = "yes"
    elif sorted(match) == list(range(len(points))):
        vertices = "renumbered"
    elif coordinates.startswith("off"):
        vertices = ""
    else:
        vertices = "%d of %d" % (len(others), len(points))
    there = [tuple(match[i] for i in f) for f in other_faces]
    if there == faces:
        kept = "yes"
    elif [turned_to_smallest(f) for f in there] == [turned_to_smallest(f) for f in faces]:
        kept = "other first corner"
    elif sorted(map(turned_to_smallest, there)) == sorted(map(turned_to_smallest, faces)):
        kept = "renumbered"
    elif coordinates.startswith("off"):
        kept = ""
    elif len(there) != len(faces):
        kept = "%d of %d" % (len(there), len(faces))
    else:
        kept = "changed"
    return [coordinates, vertices, kept]


def triangles(held):
    # JSON of JavaScript has null for what is no number.
    return ([tuple(math.nan if x is None else x for x in p) for p in held["points"]],
            [tuple(f) for f in held["faces"]])


def merged(mesh):
    """The mesh with one vertex for each place, numbered as they come first, as a file of STL is read."""
    points, faces = mesh
    number, match = {}, []
    for p in points:
        match.append(number.setdefault(p, len(number)))
    return list(number), [tuple(match[i] for i in f) for f in faces]


def joined(words):
    """One word for the two bodies. What is rounded may keep the numbers of one of them by chance; the flat one may be
    nothing any more when the round one is."""
    words = list(dict.fromkeys(w for w in words if w)) or [""]
    if len(words) == 2 and (words[0] == "yes" or words[1].startswith(words[0])):
        return words[1]
    if len(words) == 2 and (words[1] == "yes" or words[0].startswith(words[1]) or words[1].startswith("off")):
        return words[0]
    return " / ".join(words)


def shortened(message, folder):
    message = re.sub(r"back_\d+", "back", message.replace(str(folder) + "/", "").replace("|", "/"))
    return message if len(message) <= 110 else message[:107] + "..."


def measure(own, program, originals, outputs, folder):
    """The rows of the three tables."""
    def job(source):
        number = len(jobs)
        held, target = folder / ("held_%d.json" % number), source.parent / ("back_%d%s" % (number, source.suffix))
        jobs.append((str(source), str(held), str(target)))
        return number

    jobs = []
    meshes = [[job(source) for source, _, _ in originals[form]] for form in program.meshes]
    others = [[job(outputs[name][0]) for name in names] for names in (program.curves, program.parts)]
    if hasattr(program, "lines"):  # programs of the command line tell what they hold by a PLY file
        for number in others[0] + others[1]:
            jobs[number] = jobs[number][:2] + (jobs[number][2].rsplit(".", 1)[0] + ".ply",)
    for _, held, target in jobs:
        for name in (held, held + ".message", target, target + ".as_read.off"):
            pathlib.Path(name).unlink(missing_ok=True)
    messages = program.run(jobs)
    results = [(pathlib.Path(held), pathlib.Path(target), message) for (_, held, target), message in zip(jobs, messages)]
    return {"meshes": [[form] + mesh_there_and_back(own, form, originals[form], [results[n] for n in numbers], folder)
                       for form, numbers in zip(program.meshes, meshes)],
            "curves": [[name] + curves_read(program, outputs[name], results[n], folder)
                       for name, n in zip(program.curves, others[0])],
            "parts": [[name] + parts_read(program, outputs[name], results[n], folder)
                      for name, n in zip(program.parts, others[1])]}


def mesh_there_and_back(own, form, originals, results, folder):
    columns, remarks = [], []
    for (source, curves, mesh), (held, target, message) in zip(originals, results):
        has_read, has_written = held.exists(), target.exists() and target.stat().st_size > 0
        read = triangles(json.load(open(held))) if has_read else None
        if has_read and any(len(f) != 3 for f in read[1]):
            remarks.append("faces are no triangles")
        if has_written:
            back, repairs = own.mesh_of(target)
            if back is None:
                columns.append(["refused", "", "", ""])
                remarks.append("what is written is no mesh: " + repairs)
                continue
            result = compare(mesh, back)
            certified = own.certified(target, curves)
            if form[:3] != "STL" and repairs["vertices"] != len(mesh[0]):
                result[1] = "one a corner" if repairs["vertices"] == 3 * len(mesh[1]) else "%d of %d" % (
                    repairs["vertices"], len(mesh[0]))
            if has_read:
                as_read = compare(mesh, merged(read) if form[:3] == "STL" else read)
                if as_read[0] != result[0]:
                    remarks.append("reads " + {"yes": "doubles"}.get(as_read[0], as_read[0]))
        elif has_read and read[1]:
            remarks.append("is only read" if message.endswith("no writer") else "not written: " + message)
            as_off = folder / "held.off"
            if form[:3] == "STL":
                read = merged(read)
            as_off.write_bytes(bodies.off(*read))
            result = compare(mesh, read)
            certified = own.certified(as_off, curves)
        else:
            columns.append(["refused", "", "", ""])
            remarks.append(message or ("has no faces" if has_read else "writes nothing"))
            continue
        columns.append(result + ["yes" if certified[0] == certified[1] else "no" if certified[0] == 0 else
                                 "%d of %d" % certified])
    # The certificates on the round and on the flat body are two columns.
    return [joined(list(words)) for words in zip(*(c[:3] for c in columns))] + [c[3] for c in columns] + [
        shortened("; ".join(dict.fromkeys(remarks)), folder)]


def write_outputs(own, folder):
    """The files of curves and parts that this project writes for a body, and what is in them."""
    source = next(folder.glob("round_PLY.ply"))
    own.made("detect", source, "-o", folder / "curves", "--quiet")
    curves = json.load(open(folder / "curves/constrictions.json"))["constrictions"]
    result = {}
    for form, ending in (("OBJ", "obj"), ("PLY", "ply"), ("VTP", "vtp")):
        name = folder / ("curves." + ending)
        (folder / "curves" / ("constrictions." + ending)).rename(name)
        result[form] = (name, curves)
    for form in ("ply", "obj", "stl", "glb", "3mf"):
        place = folder / ("parts_" + form)
        own.made("segment", source, "-o", place, "--format", form, "--quiet")
        for name in ("part_0." + form, "parts.3mf") if form != "ply" else ("parts.ply", "parts.vtp", "part_0.ply"):
            if (place / name).exists():
                result[name] = (place / name, ply_of_parts(folder / "parts_ply" / (
                    "part_0.ply" if name.startswith("part_0") else "parts.ply")))
    return result


def ply_of_parts(name):
    """Points, triangles, colours and numbers of the faces in a PLY file, in text or binary, of any program."""
    sizes = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
             "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
             "double": "d", "float64": "d"}
    data = pathlib.Path(name).read_bytes()
    header, body = data.split(b"end_header\n", 1) if b"end_header\n" in data else data.split(b"end_header\r\n", 1)
    elements, form = [], "ascii"
    for words in (line.split() for line in header.decode("latin1").splitlines()):
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[-1], words[2:4] if words[1] == "list" else words[1]))
    words, at, order = iter(body.split()) if form == "ascii" else None, 0, "<" if "little" in form else ">"

    def value(kind):
        nonlocal at
        if words is not None:
            word = next(words)
            return float(word) if sizes[kind] in "fd" else int(word)
        result = struct.unpack_from(order + sizes[kind], body, at)[0]
        at += struct.calcsize(order + sizes[kind])
        return result

    held = {"points": [], "faces": [], "edges": [], "names": [], "point": {}, "face": {}, "edge": {}}
    for element, count, properties in elements:
        kind = {"vertex": "point"}.get(element, element)
        for _ in range(count):
            row = {}
            for name, types in properties:
                row[name] = [value(types[1]) for _ in range(value(types[0]))] if isinstance(types, list) else value(types)
            if element == "vertex":
                held["points"].append([row.pop(axis) for axis in "xyz"])
            elif element == "face":
                corners = row.pop("vertex_indices" if "vertex_indices" in row else "vertex_index")
                held["faces" if len(corners) > 2 else "edges"].append(corners)
            elif element == "edge":
                held["edges"].append([row.pop("vertex1"), row.pop("vertex2")])
            if {"red", "green", "blue"} <= row.keys():
                row["colours"] = [row.pop(c) for c in ("red", "green", "blue")]
            for key, values in row.items():
                held.setdefault(kind, {}).setdefault(key, []).append(values)
    return held


def as_lists(values):
    return [list(v) if isinstance(v, (list, tuple)) else [v] for v in values]


def same_colours(values, expected):
    """Whether these are the expected colours, in 0 to 255 or in 0 to 1, as they are or in linear light."""
    values = as_lists(values)
    if len(values) != len(expected) or any(len(v) < 3 for v in values):
        return False
    whole = max(x for v in values for x in v[:3]) > 1
    pairs = [(x / 255 if whole else x, y / 255) for v, e in zip(values, expected) for x, y in zip(v, e)]

    def linear(x):
        return x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4

    return all(abs(x - y) < 0.003 for x, y in pairs) or all(abs(x - linear(y)) < 0.003 for x, y in pairs)


def same_numbers(values, expected):
    values = as_lists(values)
    return len(values) == len(expected) and all(len(v) == 1 and v[0] == e for v, e in zip(values, expected))


def read_by(program, result):
    """What a program holds of a file, or None, and its message."""
    held, target, message = result
    if not hasattr(program, "lines"):
        return (json.load(open(held)) if held.exists() else None), message
    try:
        return (ply_of_parts(target) if target.exists() else None), message
    except (KeyError, ValueError, StopIteration, struct.error) as error:
        return None, "PLY not understood: %s" % error


def curves_read(program, output, result, folder):
    source, curves = output
    held, message = read_by(program, result)
    if held is None or not held["points"] or any(x is None for p in held["points"] for x in p):
        return ["refused", "", "", "", shortened(message or "nothing is read", folder)]
    segments, ids, colours = [], [], []
    for curve in curves:
        points = [tuple(p) for p in curve["points"]]
        segments += list(zip(points, points[1:] + points[:1]))
        ids += [curve["id"]] * len(points)
    everything = [p for s in segments for p in s]
    edges = [[tuple(held["points"][i]) for i in e] for e in held["edges"]]
    if not edges:
        return ["lost", "", "", "", "%d points%s" % (len(held["points"]), ", %d faces" % len(held["faces"])
                                                      if held["faces"] else "")]
    extent = size(everything)

    def is_near(s, t):
        return math.dist(s[0], t[0]) < 1e-5 * extent and math.dist(s[1], t[1]) < 1e-5 * extent

    in_order = len(edges) == len(segments) and all(is_near(s, t) or is_near(s, t[::-1]) for s, t in zip(segments, edges))
    if in_order:
        pairs = [(x, y) for s, t in zip(segments, edges) for p, q in zip(s, t if is_near(s, t) else t[::-1])
                 for x, y in zip(p, q)]
        found, coordinates = "yes", kind_of_rounding(pairs, extent)
    else:
        here = sum(any(is_near(s, t) or is_near(s, t[::-1]) for t in edges) for s in segments)
        found, coordinates = "%d of %d" % (here, len(segments)), ""
        if here == len(segments) == len(edges):
            found, pairs = "yes, in another order", []
            for t in edges:
                s = next(s for s in segments if is_near(s, t) or is_near(s, t[::-1]))
                pairs += [(x, y) for p, q in zip(s, t if is_near(s, t) else t[::-1]) for x, y in zip(p, q)]
            coordinates = kind_of_rounding(pairs, extent)
    has_colours = any(len(v[0]) >= 3 and k.lower() not in ("normals", "points") for data in (held["point"], held["edge"])
                      for k, v in ((k, as_lists(v)) for k, v in data.items() if v))
    numbers = any(same_numbers(v, ids) for v in held["edge"].values()) or all(
        "constriction_%d" % c["id"] in held["names"] for c in curves)
    one_each = len(held["names"]) == len(curves) or any(len(set(map(str, v))) == len(curves)
                                                       for v in held["edge"].values())
    return [found, coordinates, "" if source.suffix == ".obj" else "yes" if has_colours else "lost",
            "" if source.suffix == ".ply" else "yes" if numbers else "apart, without numbers" if one_each else "lost", ""]


def parts_read(program, output, result, folder):
    source, expected = output
    held, message = read_by(program, result)
    if held is None or not held["faces"]:
        return ["refused", "", "", shortened(message or "nothing is read", folder)]
    whole = len(held["faces"]) == len(expected["faces"])
    faces = "yes" if whole else "%d of %d" % (len(held["faces"]), len(expected["faces"]))
    name = source.name
    patches = expected["face"]["patch"]
    if name == "parts.3mf":
        numbers = all("part_%d" % i in held["names"] for i in set(patches))
        colours = "%d colours" % len({str(c) for v in held["face"].values() for c in v}) if held["face"] else "lost"
        faces = "yes"
    elif name.startswith("part_0"):
        numbers = any("part_0" in n for n in held["names"])
        colours = "yes" if any(same_colours(v, expected["face"]["colours"][:1] * len(v))
                               for v in held["face"].values() if v) else "lost"
    else:
        numbers = any(same_numbers(v, patches) for v in held["face"].values())
        colours = "yes" if any(same_colours(v, expected["face"]["colours"]) for v in held["face"].values()) else "lost"
    if name == "part_0.obj":
        colours = ""
    return [faces, colours, "yes" if numbers else "lost", ""]
