#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sends meshes, curves and parts through other programs, and measures what comes back.

    scripts/interchange/run.py build/release/tools/constrictions/constrictions [--only NAME,...] [--cache DIR] [--rows]

Two bodies are written in each format. `constrictions detect` finds their curves, the program reads the body and writes
it in the same format, and `constrictions certify` proves the curves anew on what came back. Coordinates are compared
bit by bit, vertices and faces by their numbers. Curves and parts, as this project writes them, are read by each program.

The programs are packages of Debian 12 and 13 and of npm, of the versions in programs.py. They go to a temporary folder,
or to --cache, where they stay: 12 GB for all of them. Prints the tables of the manual, in which versions and formats
with equal results share a row; with --rows, a row for each. Needs apt-get, dpkg-deb, g++, GMP and MPFR, Boost, node and
npm, and x86-64. Nothing is installed on the machine.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import bodies
import measures
import programs

PROJECT = pathlib.Path(__file__).resolve().parents[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("constrictions", help="the program of this project")
    parser.add_argument("--only", help="names of programs, with commas between them")
    parser.add_argument("--cache", help="a folder for the packages, which stay there")
    parser.add_argument("--rows", action="store_true", help="a row for each program, version and format")
    parser.add_argument("--results", help="a JSON file of rows: those that it has are not measured again")
    parser.add_argument("--mesh", default=str(PROJECT / "data/meshes/cactus.off"), help="the body that is not flat")
    arguments = parser.parse_args()
    chosen = [p for p in programs.PROGRAMS
              if not arguments.only or p.name.lower() in arguments.only.lower().split(",")]
    if not chosen:
        parser.error("there is no such program; there are " + ", ".join(sorted({p.name for p in programs.PROGRAMS})))
    with tempfile.TemporaryDirectory() as folder:
        measure(arguments, chosen, pathlib.Path(folder))


def measure(arguments, chosen, folder):
    cache = pathlib.Path(arguments.cache).resolve() if arguments.cache else folder / "packages"
    results = pathlib.Path(arguments.results) if arguments.results else folder / "results.json"
    tables = json.load(open(results)) if results.exists() else {}
    left = [p for p in chosen if p.full_name not in tables]
    if left:
        own = measures.Constrictions(pathlib.Path(arguments.constrictions).resolve())
        originals = measures.write_originals(own, folder, arguments.mesh)
        outputs = measures.write_outputs(own, folder)
    for program in left:
        print(program.full_name, file=sys.stderr, flush=True)
        try:
            program.install(cache)
        except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
            print("  not installed: %s" % error, file=sys.stderr, flush=True)
            continue
        tables[program.full_name] = measures.measure(own, program, originals, outputs, folder)
        results.write_text(json.dumps(tables, indent=1))
    for kind, head in (("meshes", ["coordinates", "numbering", "round", "flat", "remark"]),
                       ("curves", ["edges", "coordinates", "colours", "numbers", "remark"]),
                       ("parts", ["faces", "colours", "numbers or names", "remark"])):
        rows = [[p.name, p.version] + row for p in chosen for row in tables.get(p.full_name, {}).get(kind, [])]
        if kind == "meshes":
            rows = [row[:4] + [numbering(*row[4:6])] + row[6:] for row in rows]
        print_table(["program", "format"] + head,
                    [["%s %s" % tuple(r[:2])] + r[2:] for r in rows] if arguments.rows else shared(rows))


def numbering(vertices, faces):
    """One word for two columns."""
    if vertices == faces:
        return vertices
    if faces == "yes":
        return "vertices renumbered" if vertices == "renumbered" else (
            "a vertex for each corner" if vertices == "one a corner" else vertices + " vertices")
    return "faces: " + faces if vertices == "yes" else "vertices: %s, faces: %s" % (vertices, faces)


def shared(rows):
    """Formats of a program with equal results in one row, then versions of it with equal formats and results."""
    of_formats = {}
    for name, version, form, *result in rows:
        of_formats.setdefault((name, version, tuple(result)), []).append(form)
    of_versions = {}
    for (name, version, result), forms in of_formats.items():
        of_versions.setdefault((name, tuple(forms), result), []).append(version)
    return [["%s %s" % (name, ", ".join(versions)), ", ".join(forms), *result]
            for (name, forms, result), versions in of_versions.items()]


def print_table(head, rows):
    if not rows:
        return
    lines = [head] + rows
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    lines.insert(1, ["-" * w for w in widths])
    print()
    for line in lines:
        print("| " + " | ".join(c.ljust(w) for c, w in zip(line, widths)).rstrip() + " |")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
