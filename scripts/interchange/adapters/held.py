# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program holds after it has read a file, as JSON: points, faces, edges, and what it has for each of them."""
import json
import sys
import traceback


def plain(value):
    if hasattr(value, "tolist"):
        value = value.tolist()
    return list(map(plain, value)) if isinstance(value, (list, tuple)) else value


def save(name, points, faces=(), edges=(), names=(), **data):
    """data: point, face and edge, each a dictionary from the name of an array to its values."""
    held = {"points": plain(points), "faces": plain(faces), "edges": plain(edges), "names": plain(names)}
    for kind in ("point", "face", "edge"):
        held[kind] = {key: plain(values) for key, values in data.get(kind, {}).items()}
    with open(name, "w") as out:
        json.dump(held, out)


def edges_of(polyline):
    """The edges between neighbours in a list of vertices."""
    return [list(pair) for pair in zip(polyline, polyline[1:])]


def each(convert):
    """Calls convert(IN, HELD, OUT) for each three arguments, and writes to HELD.message why it fails, or nothing. One
    process for many files, since these programs take long to start."""
    for i in range(1, len(sys.argv), 3):
        try:
            convert(*sys.argv[i:i + 3])
            message = ""
        except (Exception, SystemExit) as error:
            message = error.code if isinstance(error, SystemExit) else "".join(
                traceback.format_exception_only(type(error), error)).strip().splitlines()[-1]
        with open(sys.argv[i + 1] + ".message", "w") as out:
            out.write(str(message))
