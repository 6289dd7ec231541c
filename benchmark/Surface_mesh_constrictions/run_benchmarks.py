#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the benchmarks, each in a process of its own, and writes tables (Markdown) and a plot (SVG).

    run_benchmarks.py BUILD_DIR MESH_DIR OUT_DIR [--repetitions N] [--only NAME...] [--largest FACES] [--large]

BUILD_DIR is a build with -DWITH_BENCHMARKS=ON, MESH_DIR has CGAL's example meshes. Of several repetitions the median is
taken; what is compared is measured one after the other on the same mesh. A cell is empty where nothing was measured:
the program is not installed, or takes minutes on this mesh, or the mesh has hardly more than the 1,000 faces to which
meshoptimizer simplifies.
OUT_DIR/performance.md and performance.svg, which needs python3-matplotlib, are written anew after each mesh; their
tables and plot are those of the manual, in its order.
"""

import argparse
import importlib.util
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys

# The families of meshes by their number in the benchmark: the name, and of each size the number of faces, about.
FAMILIES = {0: ("one neck", {n: n for n in (1000, 10000, 100000, 1000000)}),
            1: ("many necks", {n: n for n in (1000, 10000, 100000, 1000000)}),
            2: ("armadillo", {0: 52000, 1: 208000, 2: 832000, 3: 3328000, 4: 13312000}),
            3: ("flat", {n: n for n in (1000, 10000, 100000, 820000)})}
LARGEST = 1100000  # faces, without --large
EDGE_COLLAPSE = "edge_collapse_alone"
OPENMESH = "openmesh_decimater"
MESHOPTIMIZER = "meshoptimizer_simplify"
SEQUENTIAL = "whole_detection<CGAL::Sequential_tag>"
PARALLEL = "whole_detection<CGAL::Parallel_if_available_tag>"
PARTS_MESHES = ("cactus", "armadillo", "elephant", "man", "camel", "eight")
OTHER_TABLES = ("tightening", "parts")
STAGES = ("copy", "simplify", "record", "seeds", "refine", "tighten", "certify", "select")


def run(program, name_filter, mesh_dir):
    """The benchmarks of a program whose names match, as Google Benchmark reports them: it prints nothing if none."""
    environment = dict(os.environ, CONSTRICTIONS_MESH_DIR=str(mesh_dir))
    command = [str(program), "--benchmark_format=json", "--benchmark_min_time=0.01",
               f"--benchmark_filter={name_filter}"]
    output = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    found = json.loads(output.stdout)["benchmarks"] if output.stdout else []
    return [b for b in found if not b.get("error_occurred")]


def medians(samples):
    """Of several reports of the same benchmark: the median of each number."""
    return {key: statistics.median(s[key] for s in samples) for key, value in samples[0].items()
            if isinstance(value, (int, float))}


def measure(program, mesh_dir, repetitions, families, largest):
    """A row for each mesh: its family, and the reports of the benchmarks by name."""
    for family, (title, sizes) in FAMILIES.items():
        if title not in families:
            continue
        for size in (s for s, faces in sizes.items() if faces <= largest):
            samples = {}
            for _ in range(repetitions):
                for name in (EDGE_COLLAPSE, MESHOPTIMIZER, SEQUENTIAL, PARALLEL, OPENMESH):
                    found = run(program, f"^{name}/family:{family}/size:{size}/", mesh_dir)
                    if found:
                        samples.setdefault(name, []).append(found[0])
            if samples:
                row = title, {name: medians(s) for name, s in samples.items()}
                print(title, int(row[1][SEQUENTIAL]["faces"]), file=sys.stderr)
                yield row


def seconds(milliseconds):
    return f"{milliseconds / 1000:.2f}" if milliseconds >= 100 else f"{milliseconds / 1000:.4f}"


def table(columns, rows):
    """Rows are pairs of a title and reports, columns of a title and a function from the reports to a cell."""
    lines = ["| mesh | " + " | ".join(title for title, _ in columns) + " |", "| --- |" + " ---: |" * len(columns)]
    for title, reports in rows:
        lines.append(f"| {title} | " + " | ".join(cell(reports) for _, cell in columns) + " |")
    return lines


def time(reports, name):
    return f"{seconds(reports[name]['real_time'])} s" if name in reports else ""


def meshoptimizer_time(reports):
    """With the number of faces where it stops before it has reached the 1,000 that it is asked for."""
    faces = reports.get(MESHOPTIMIZER, {}).get("faces_reached", 0)
    return time(reports, MESHOPTIMIZER) + (f", {faces:.0f} faces" if faces > 1000 else "")


def ratio(reports, name, other, key="real_time"):
    return f"{reports[name][key] / reports[other][key]:.2f}" if other in reports else ""


def detection_table(rows):
    columns = [("faces", lambda r: f"{r[SEQUENTIAL]['faces']:.0f}"),
               ("curves", lambda r: f"{r[SEQUENTIAL]['curves']:.0f}"),
               ("`edge_collapse()`", lambda r: time(r, EDGE_COLLAPSE)),
               ("OpenMesh", lambda r: time(r, OPENMESH)),
               ("meshoptimizer", meshoptimizer_time),
               ("detection", lambda r: time(r, SEQUENTIAL)),
               ("to `edge_collapse()`", lambda r: ratio(r, SEQUENTIAL, EDGE_COLLAPSE)),
               ("to meshoptimizer", lambda r: ratio(r, SEQUENTIAL, MESHOPTIMIZER)),
               ("several threads", lambda r: time(r, PARALLEL)),
               ("to `edge_collapse()`", lambda r: ratio(r, PARALLEL, EDGE_COLLAPSE)),
               ("speedup", lambda r: ratio(r, SEQUENTIAL, PARALLEL))]
    return table(columns, rows)


def memory_table(rows):
    def own_bytes(name):
        return lambda r: f"{r[name]['own_bytes']:.0f}" if name in r else ""

    columns = [("faces", lambda r: f"{r[SEQUENTIAL]['faces']:.0f}"),
               ("peak", lambda r: f"{r[SEQUENTIAL]['peak_MB']:.0f} MB"),
               ("to `edge_collapse()`", lambda r: ratio(r, SEQUENTIAL, EDGE_COLLAPSE, "peak_MB")),
               ("bytes a face", own_bytes(SEQUENTIAL)),
               ("several threads", own_bytes(PARALLEL)),
               ("`edge_collapse()`", own_bytes(EDGE_COLLAPSE)),
               ("meshoptimizer", own_bytes(MESHOPTIMIZER))]
    return table(columns, rows)


def stage_table(rows):
    columns = [("faces", lambda r: f"{r[SEQUENTIAL]['faces']:.0f}")]
    columns += [(s, lambda r, s=s: f"{seconds(r[SEQUENTIAL][s])} s") for s in STAGES]
    return table(columns, rows)


def exponent(points):
    """The slope of the line of least squares through the logarithms."""
    x, y = zip(*((math.log(a), math.log(b)) for a, b in points))
    mx, my = statistics.mean(x), statistics.mean(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def growth_table(rows, least):
    """Exponents of growth between a number of faces and the largest mesh."""
    def growth(name, key="real_time"):
        def cell(family):
            points = [(r[name]["faces"], r[name][key]) for r in family if name in r and r[name][key] >= 0.1]
            return f"{exponent(points):.2f}" if len(points) > 1 else ""
        return cell

    columns = [("`edge_collapse()`", growth(EDGE_COLLAPSE)), ("meshoptimizer", growth(MESHOPTIMIZER)),
               ("detection", growth(SEQUENTIAL)), ("several threads", growth(PARALLEL))]
    columns += [(s, growth(SEQUENTIAL, s)) for s in STAGES]
    families = [(title, [r for t, r in rows if t == title and r[SEQUENTIAL]["faces"] >= 0.9 * least])
                for title, _ in FAMILIES.values()]
    return table(columns, [(title, family) for title, family in families if len(family) > 1])


def tightening_table(program, mesh_dir):
    lines = ["| method | faces | loops | time of a loop | length |", "| --- | ---: | ---: | ---: | ---: |"]
    for b in run(program, ".", mesh_dir):
        lines.append(f"| {b['name'].split('/')[0]} | {b['faces']:.0f} | {b['loops']:.0f} "
                     f"| {b['cpu_time'] / b['loops']:.2f} ms | {b['length_percent']:.2f}% |")
    return lines


def parts_table(program, mesh_dir):
    command = [str(program)] + [f"{name}.off" for name in PARTS_MESHES]
    return subprocess.run(command, cwd=mesh_dir, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def write_tables(rows, others, out):
    tables = [("Detection", detection_table(rows)), ("Memory", memory_table(rows)),
              ("Stages, one thread", stage_table(rows)),
              ("Growth from 10,000 faces on", growth_table(rows, 10000)),
              ("Growth from 100,000 faces on", growth_table(rows, 100000))]
    tables = [(title, lines) for title, lines in tables if len(lines) > 2] + others  # that have rows
    out.write_text("\n".join(f"## {title}\n\n" + "\n".join(lines) + "\n" for title, lines in tables))


def plot(rows, out):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "constrictions"  # the same file from the same numbers
    import matplotlib.pyplot as plt
    colours = {"one neck": "#0072B2", "many necks": "#D55E00", "armadillo": "#009E73", "flat": "#CC79A7"}
    styles = {EDGE_COLLAPSE: (":", "edge_collapse() alone"), MESHOPTIMIZER: ("-.", "meshoptimizer, to 1,000 faces"),
              SEQUENTIAL: ("-", "detection"), PARALLEL: ("--", "detection, several threads")}
    figure, axes = plt.subplots(figsize=(7, 4.5))
    for title, colour in colours.items():
        for name, (style, _) in styles.items():
            points = [(r[name]["faces"], r[name]["real_time"] / 1000) for t, r in rows if t == title and name in r]
            if points:
                axes.plot(*zip(*points), style, marker="o", markersize=3, color=colour)
    titles = {title for title, _ in rows}
    legend = [plt.Line2D([], [], color=colour, label=title) for title, colour in colours.items() if title in titles]
    legend += [plt.Line2D([], [], color="black", linestyle=style, label=label) for style, label in styles.values()]
    axes.set(xscale="log", yscale="log", xlabel="faces", ylabel="seconds")
    axes.grid(True, which="major", alpha=0.3)
    axes.legend(handles=legend, fontsize=7, ncol=2)
    figure.tight_layout()
    figure.savefig(out, metadata={"Date": None})


def main():
    families = [title for title, _ in FAMILIES.values()]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--only", nargs="+", choices=families + list(OTHER_TABLES),
                        help="these families of meshes and other tables, instead of all")
    parser.add_argument("--largest", type=int, help="no meshes of more faces")
    parser.add_argument("--large", action="store_true", help="also the armadillo with 3.3 and 13.3 million faces")
    arguments = parser.parse_args()
    only = arguments.only or families + list(OTHER_TABLES)
    largest = min(math.inf if arguments.large else LARGEST, arguments.largest or math.inf)
    programs = arguments.build.resolve() / "benchmark" / "Surface_mesh_constrictions"
    arguments.out.mkdir(parents=True, exist_ok=True)
    has_matplotlib = importlib.util.find_spec("matplotlib") is not None
    if not has_matplotlib:
        print("There is no plot without python3-matplotlib.", file=sys.stderr)

    others = []
    if "tightening" in only:
        others.append(("Tightening", tightening_table(programs / "tightening_benchmark", arguments.meshes)))
    if "parts" in only:
        others.append(("Parts", parts_table(programs / "parts_comparison", arguments.meshes)))
    rows = []
    write_tables(rows, others, arguments.out / "performance.md")
    for row in measure(programs / "detection_benchmark", arguments.meshes, arguments.repetitions, only, largest):
        rows.append(row)
        write_tables(rows, others, arguments.out / "performance.md")
        if has_matplotlib:
            plot(rows, arguments.out / "performance.svg")


if __name__ == "__main__":
    main()
