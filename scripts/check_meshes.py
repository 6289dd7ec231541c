#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program's default call, with certificates, on the meshes of a folder, the biggest last, and prints what
becomes of them as the tables of the manual: what kinds of meshes there are, and those that were repaired, but for
polygons made triangles.

    scripts/check_meshes.py PROGRAM FOLDER [-j N] [--time-limit SECONDS] [--least N]

The exit code is 0 if at least N meshes are answered, all without --least, no answer has a curve that is not certified,
and no mesh is refused for its holes or polygons.
"""
import argparse
import collections
import json
import os
import subprocess
import sys

EXTENSIONS = (".off", ".obj", ".ply", ".stl", ".vtk", ".vtp", ".glb", ".3mf")
CERTIFIED = ("strict_constriction", "constriction")


def kind(line):
    """What a mesh is, as a row of the first table."""
    mesh = line["mesh"]
    words = ["open" if mesh["holes"] else "closed"]
    if "triangulated" in mesh["repairs"]:
        words.append("polygons")
    if any(repair != "triangulated" for repair in mesh["repairs"]):
        words.append("repaired")
    return ", ".join(words)


def run(program, names, jobs, time_limit):
    command = [program, "batch", "-", "-j", str(jobs), "--time-limit", str(time_limit), "--quiet"]
    done = subprocess.run(command, input="\n".join(names) + "\n", stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{command}: exit code {done.returncode}")
    lines = {}
    for text in done.stdout.splitlines():
        line = json.loads(text)
        lines[line["file"]] = line
    return lines


def print_table(head, rows):
    cells = [head] + [[str(c) for c in row] for row in rows]
    width = [max(len(row[i]) for row in cells) for i in range(len(head))]
    for number, row in enumerate(cells):
        padded = [c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(row, width))]
        print("| " + " | ".join(padded) + " |")
        if number == 0:
            print("| " + " | ".join("-" * w if i == 0 else "-" * (w - 1) + ":" for i, w in enumerate(width)) + " |")
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("-j", type=int, default=1)
    parser.add_argument("--time-limit", type=int, default=120)
    parser.add_argument("--least", type=int)
    arguments = parser.parse_args()

    names = [os.path.join(arguments.folder, n) for n in os.listdir(arguments.folder) if n.lower().endswith(EXTENSIONS)]
    if not names:
        sys.exit(f"no mesh in {arguments.folder}")
    names.sort(key=lambda n: (os.path.getsize(n), n))
    lines = run(arguments.program, names, arguments.j, arguments.time_limit)

    # one without a line has been lost, which must not go unnoticed
    lost = [n for n in names if n not in lines]
    answered = [lines[n] for n in names if n in lines and lines[n]["status"] == "ok"]
    failed = [lines[n] for n in names if n in lines and lines[n]["status"] != "ok"]
    curves = {line["file"]: [c["certificate"] in CERTIFIED for c in line["constrictions"]] for line in answered}

    groups = collections.defaultdict(list)
    for line in answered:
        groups[kind(line)].append(line)
    rows = []
    for name in sorted(groups):
        found = [c for line in groups[name] for c in curves[line["file"]]]
        holes = sum(line["mesh"]["holes"] for line in groups[name])
        rows.append([name, len(groups[name]), holes, len(found), sum(found)])
    total = [sum(row[i] for row in rows) for i in range(1, 5)]
    print_table(["meshes that are", "number", "holes", "curves", "certified"], rows + [["answered"] + total])

    rows = [
        [
            os.path.basename(line["file"]),
            line["mesh"]["faces"],
            line["mesh"]["holes"],
            ", ".join(f"{n} {r}" for r, n in line["mesh"]["repairs"].items()),
            len(curves[line["file"]]),
        ]
        for line in sorted(answered, key=lambda line: os.path.basename(line["file"]).lower())
        if "repaired" in kind(line)
    ]
    print_table(["repaired", "faces", "holes", "repairs", "curves"], rows)

    for line in failed:
        print(f"not answered ({line['kind']}): {line['error']}")
    for name in lost:
        print(f"no line: {name}")
    slow = [line for line in answered if line["seconds"] > arguments.time_limit / 4]
    for line in sorted(slow, key=lambda line: -line["seconds"]):
        print(f"{line['seconds']:.0f} seconds: {line['file']}")

    least = len(names) if arguments.least is None else arguments.least
    is_good = len(answered) >= least and not lost and total[2] == total[3]
    for line in failed:
        is_good = is_good and not any(word in line["error"] for word in ("hole", "not closed", "not a triangle mesh"))
    print(f"{len(answered)} of {len(names)} meshes answered, {total[3]} of {total[2]} curves certified")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
