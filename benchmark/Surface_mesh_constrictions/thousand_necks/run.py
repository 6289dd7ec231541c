#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand necks: makes bodies with 1000 known narrow places, lets a program look for them, and counts what it finds.

    run.py --command 'constrictions detect {mesh} --json {out} --quiet' [--json FILE]
    run.py --command 'PROGRAM {mesh} {out}' --quick
    run.py --write FOLDER                           only the meshes, with the places beside them
    run.py --compare NAME=FILE[,FILE]...            one table of several programs, of files written by --json

The command gets the name of an OFF file for {mesh}, and writes closed polylines to {out}: the JSON of constrictions/1,
or lines `n x1 y1 z1 ...` as in CGAL's .polylines.txt. {here} is the folder of this script. A command that fails, or
does not end in time, finds nothing.

The table has a line for each family: places; found, by a curve around the place that is not longer than a loop that is
known there; near, by one that is longer, by half at most; extras, curves that belong to no place; duplicates, further
curves of a place; processor seconds of the command, of all its threads. score.py says it in full. Needs numpy.
"""
import argparse
import json
import os
import resource
import shlex
import subprocess
import sys
import tempfile

from bodies import FAMILIES, SEED, body, known_length, quick_numbers
from score import read_curves, score
from surfaces import positions

COLUMNS = ("places", "found", "near", "extras", "duplicates")


def write_off(mesh, path):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(mesh.points)} {len(mesh.faces)} 0\n")
        file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in mesh.points.tolist())
        file.writelines("3 %d %d %d\n" % tuple(f) for f in mesh.faces.tolist())


def truth(one):
    """What is known of a body, as JSON."""
    return {
        "format": "thousand_necks/1",
        "family": one.family, "treatment": one.treatment, "faces": len(one.mesh.faces), **one.topology._asdict(),
        "places": [{"axis": place.axis.tolist(), "side": place.side, "length": known_length(one.mesh, place),
                    "loops": [positions(one.mesh, loop).tolist() for loop in place.loops]} for place in one.places],
    }


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def answer(command, one, folder, time_limit):
    """Runs the command on a body: the curves, or None, processor seconds, and what went wrong."""
    mesh, out = os.path.join(folder, one.name + ".off"), os.path.join(folder, one.name + ".curves")
    write_off(one.mesh, mesh)
    names = {"mesh": mesh, "out": out, "here": os.path.dirname(os.path.abspath(__file__))}
    words = [word.format(**names) for word in shlex.split(command)]
    curves, error, start = None, None, children_seconds()
    try:
        done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              timeout=time_limit, check=False)
        if done.returncode == 0:
            curves = read_curves(out)
        else:
            error = f"exit code {done.returncode}: {done.stderr.decode(errors='replace').strip()[-200:]}"
    except subprocess.TimeoutExpired:
        error = f"no answer in {time_limit:g} seconds"
    except (OSError, ValueError, KeyError) as failure:
        error = f"no answer that can be read: {failure}"
    seconds = children_seconds() - start
    for name in (mesh, out):
        if os.path.exists(name):
            os.remove(name)
    return curves, seconds, error


def percent(total):
    return f"{100 * total['found'] / total['places']:.1f}" if total["places"] else ""


def aligned(head, rows):
    """Lines of a table, its first column to the left."""
    widths = [max(len(str(row[i])) for row in (head, *rows)) for i in range(len(head))]
    rule = ["-" * widths[0], *("-" * (width - 1) + ":" for width in widths[1:])]
    return ["| " + " | ".join([str(row[0]).ljust(widths[0]), *(str(c).rjust(w) for c, w in zip(row[1:], widths[1:]))])
            + " |" for row in (head, rule, *rows)]


def table(results):
    """Lines of a table by family, and the same sums as dictionaries."""
    sums = {}
    for one in results:
        total = sums.setdefault(one["family"], dict.fromkeys(("bodies", "failed", *COLUMNS, "seconds"), 0))
        total["bodies"] += 1
        total["failed"] += one["error"] is not None
        total["seconds"] += one["seconds"]
        for column in COLUMNS:
            total[column] += one[column]
    together = {key: sum(total[key] for total in sums.values()) for key in next(iter(sums.values()))}
    rows = []
    for family, t in [*sums.items(), ("together", together)]:
        rows.append((family, t["bodies"], t["failed"], t["places"], t["found"], percent(t), t["near"], t["extras"],
                     t["duplicates"], f"{t['seconds']:.1f}"))
    lines = aligned(("family", "bodies", "failed", "places", "found", "%", "near", "extras", "duplicates", "seconds"),
                    rows)
    return lines, {**sums, "together": together}


def compare(programs):
    """Lines of a table of several programs, by family; each is given as NAME=FILE,FILE... It counts the bodies that are
    in the results of all of them."""
    names, answers = [], []
    for program in programs:
        name, _, paths = program.partition("=")
        names.append(name)
        answers.append({})
        for path in paths.split(","):
            with open(path, encoding="utf-8") as file:
                answers[-1].update((one["body"], one) for one in json.load(file)["bodies"])
    order = list(FAMILIES)
    common = sorted((body for body in answers[0] if all(body in answer for answer in answers)),
                    key=lambda body: (order.index(answers[0][body]["family"]), body))
    columns = [table([answer[body] for body in common])[1] for answer in answers]
    head = ["family", "bodies", "places"]
    for name in names:
        head += [f"{name}: found", "near", "extras", "seconds"]
    rows = []
    for family, first in columns[0].items():
        row = [family, first["bodies"], first["places"]]
        for sums in columns:
            total = sums[family]
            row += [total["found"], total["near"], total["extras"], f"{total['seconds']:.1f}"]
        rows.append(row)
    return aligned(head, rows)


def chosen(arguments):
    for family, (_, count, _) in FAMILIES.items():
        if not arguments.family or family in arguments.family:
            for number in quick_numbers(family) if arguments.quick else range(count):
                yield family, number


def write_set(arguments):
    os.makedirs(arguments.write, exist_ok=True)
    for family, number in chosen(arguments):
        one = body(family, number, arguments.seed)
        write_off(one.mesh, os.path.join(arguments.write, one.name + ".off"))
        with open(os.path.join(arguments.write, one.name + ".truth.json"), "w", encoding="ascii") as file:
            json.dump(truth(one), file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", help="what to run, with {mesh} and {out}")
    parser.add_argument("--json", metavar="FILE", help="writes the results of each body, and the sums")
    parser.add_argument("--quick", action="store_true", help="a small part of the set")
    parser.add_argument("--family", action="append", choices=FAMILIES, help="only these families")
    parser.add_argument("--seed", type=int, default=SEED, help="another one makes another set of the same kinds")
    parser.add_argument("--time-limit", type=float, default=600, metavar="SECONDS", help="for each body")
    parser.add_argument("--write", metavar="FOLDER", help="writes meshes and places, runs nothing")
    parser.add_argument("--compare", nargs="+", metavar="NAME=FILE", help="prints files of --json side by side")
    parser.add_argument("--verbose", action="store_true", help="a line for each body")
    arguments = parser.parse_args()
    if sum(map(bool, (arguments.command, arguments.write, arguments.compare))) != 1:
        parser.error("one of --command, --write and --compare is needed")
    if arguments.compare:
        print("\n".join(compare(arguments.compare)))
        return 0
    if arguments.write:
        write_set(arguments)
        return 0
    if "{mesh}" not in arguments.command or "{out}" not in arguments.command:
        parser.error("the command has to have {mesh} and {out}")

    results = []
    with tempfile.TemporaryDirectory() as folder:
        for family, number in chosen(arguments):
            one = body(family, number, arguments.seed)
            curves, seconds, error = answer(arguments.command, one, folder, arguments.time_limit)
            r = {"body": one.name, "family": family, "treatment": one.treatment, "faces": len(one.mesh.faces),
                 "seconds": round(seconds, 3), "error": error, **score(one, curves or [])}
            results.append(r)
            if arguments.verbose or error:
                print("%-24s %-20s %7d faces, %3d of %3d places, %3d near, %3d extras, %6.2f s %s" % (
                    one.name, one.treatment, r["faces"], r["found"], r["places"], r["near"], r["extras"], seconds,
                    error or ""), file=sys.stderr, flush=True)
    lines, sums = table(results)
    print("\n".join(lines))
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump({"format": "thousand_necks_results/1", "command": arguments.command, "seed": arguments.seed,
                       "quick": arguments.quick, "families": sums, "bodies": results}, file, indent=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
