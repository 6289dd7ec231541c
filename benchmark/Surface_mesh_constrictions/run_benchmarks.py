#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the benchmarks, each in a process of its own, and writes a table (Markdown) and plots (SVG).

    run_benchmarks.py BUILD_DIR MESH_DIR OUT_DIR [--repetitions N]

BUILD_DIR is a build with -DWITH_BENCHMARKS=ON, MESH_DIR has CGAL's example meshes. Of several repetitions the median is
taken; what is compared is measured one after the other on the same mesh. Needs python3-matplotlib.
"""

import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys

FAMILIES = {0: ("one neck", (1000, 10000, 100000, 1000000)),
            1: ("many necks", (1000, 10000, 100000, 1000000)),
            2: ("armadillo", (0, 1, 2))}
EDGE_COLLAPSE = "edge_collapse_alone"
OPENMESH = "openmesh_decimater"
SEQUENTIAL = "whole_detection<CGAL::Sequential_tag>"
PARALLEL = "whole_detection<CGAL::Parallel_if_available_tag>"
PARTS_MESHES = ("cactus", "armadillo", "elephant", "man", "camel", "eight")
STAGES = ("copy", "simplify", "record", "seeds", "refine", "tighten", "certify", "select")


def run(program, name_filter, mesh_dir):
    """The benchmarks of a program whose names match, as Google Benchmark reports them."""
    environment = dict(os.environ, CONSTRICTIONS_MESH_DIR=str(mesh_dir))
    command = [str(program), "--benchmark_format=json", "--benchmark_min_time=0.01", f"--benchmark_filter={name_filter}"]
    output = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return [b for b in json.loads(output.stdout)["benchmarks"] if not b.get("error_occurred")]


def medians(samples):
    """Of several reports of the same benchmark: the median of each number."""
    return {key: statistics.median(s[key] for s in samples) for key, value in samples[0].items()
            if isinstance(value, (int, float))}


def measure(program, mesh_dir, repetitions):
    """A row for each mesh: the reports of the benchmarks by name."""
    rows = []
    for family, (title, sizes) in FAMILIES.items():
        for size in sizes:
            samples = {}
            for _ in range(repetitions):
                for name in (EDGE_COLLAPSE, SEQUENTIAL, PARALLEL, OPENMESH):
                    found = run(program, f"^{name}/family:{family}/size:{size}/", mesh_dir)
                    if found:
                        samples.setdefault(name, []).append(found[0])
            if EDGE_COLLAPSE in samples:
                rows.append((title, {name: medians(s) for name, s in samples.items()}))
                print(title, int(rows[-1][1][EDGE_COLLAPSE]["faces"]), file=sys.stderr)
    return rows


def seconds(milliseconds):
    return f"{milliseconds / 1000:.2f}" if milliseconds >= 100 else f"{milliseconds / 1000:.4f}"


def detection_table(rows):
    lines = ["| mesh | faces | curves | `edge_collapse()` | OpenMesh | detection | ratio | several threads | ratio | "
             "peak memory | ratio |",
             "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"]
    for title, r in rows:
        alone, one, several = r[EDGE_COLLAPSE], r[SEQUENTIAL], r[PARALLEL]
        openmesh = f"{seconds(r[OPENMESH]['real_time'])} s" if OPENMESH in r else ""
        lines.append(f"| {title} | {alone['faces']:.0f} | {one['curves']:.0f} | {seconds(alone['real_time'])} s | {openmesh} "
                     f"| {seconds(one['real_time'])} s | {one['real_time'] / alone['real_time']:.2f} "
                     f"| {seconds(several['real_time'])} s | {several['real_time'] / alone['real_time']:.2f} "
                     f"| {one['peak_MB']:.0f} MB | {one['peak_MB'] / alone['peak_MB']:.2f} |")
    return lines


def stage_table(rows):
    lines = ["| mesh | faces | " + " | ".join(STAGES) + " |", "| --- | ---: |" + " ---: |" * len(STAGES)]
    for title, r in rows:
        one = r[SEQUENTIAL]
        lines.append(f"| {title} | {one['faces']:.0f} | " + " | ".join(f"{seconds(one[s])} s" for s in STAGES) + " |")
    return lines


def exponent(points):
    """The slope of the line of least squares through the logarithms."""
    x, y = zip(*((math.log(a), math.log(b)) for a, b in points))
    mx, my = statistics.mean(x), statistics.mean(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def growth_table(rows):
    """Exponents of growth between 10,000 faces and the largest mesh."""
    columns = [("`edge_collapse()`", lambda r: r[EDGE_COLLAPSE]["real_time"]),
               ("detection", lambda r: r[SEQUENTIAL]["real_time"])]
    columns += [(s, lambda r, s=s: r[SEQUENTIAL][s]) for s in STAGES]
    lines = ["| mesh | " + " | ".join(c for c, _ in columns) + " |", "| --- |" + " ---: |" * len(columns)]
    for title, _ in FAMILIES.values():
        family = [r for t, r in rows if t == title and r[EDGE_COLLAPSE]["faces"] >= 9000]
        if len(family) < 2:
            continue
        cells = []
        for _, value in columns:
            points = [(r[EDGE_COLLAPSE]["faces"], value(r)) for r in family if value(r) >= 0.1]
            cells.append(f"{exponent(points):.2f}" if len(points) > 1 else "")
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    return lines


def tightening_table(program, mesh_dir):
    lines = ["| method | faces | loops | time of a loop | length |", "| --- | ---: | ---: | ---: | ---: |"]
    for b in run(program, ".", mesh_dir):
        lines.append(f"| {b['name'].split('/')[0]} | {b['faces']:.0f} | {b['loops']:.0f} "
                     f"| {b['cpu_time'] / b['loops']:.2f} ms | {b['length_percent']:.2f}% |")
    return lines


def parts_table(program, mesh_dir):
    command = [str(program)] + [f"{name}.off" for name in PARTS_MESHES]
    return subprocess.run(command, cwd=mesh_dir, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def plot(rows, out):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "constrictions"  # the same file from the same numbers
    import matplotlib.pyplot as plt
    colours = {"one neck": "#0072B2", "many necks": "#D55E00", "armadillo": "#009E73"}
    figure, axes = plt.subplots(figsize=(7, 4.5))
    for title, _ in FAMILIES.values():
        family = [r for t, r in rows if t == title]
        faces = [r[EDGE_COLLAPSE]["faces"] for r in family]
        for name, style, label in ((EDGE_COLLAPSE, ":", "edge_collapse() alone"), (SEQUENTIAL, "-", "detection"),
                                   (PARALLEL, "--", "detection, several threads")):
            axes.plot(faces, [r[name]["real_time"] / 1000 for r in family], style, marker="o", markersize=3,
                      color=colours[title], label=f"{title}: {label}")
    axes.set(xscale="log", yscale="log", xlabel="faces", ylabel="seconds")
    axes.grid(True, which="major", alpha=0.3)
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(out, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--repetitions", type=int, default=3)
    arguments = parser.parse_args()
    programs = arguments.build.resolve() / "benchmark" / "Surface_mesh_constrictions"
    arguments.out.mkdir(parents=True, exist_ok=True)

    rows = measure(programs / "detection_benchmark", arguments.meshes, arguments.repetitions)
    tables = (("Detection", lambda: detection_table(rows)), ("Stages, one thread", lambda: stage_table(rows)),
              ("Growth", lambda: growth_table(rows)),
              ("Tightening", lambda: tightening_table(programs / "tightening_benchmark", arguments.meshes)),
              ("Parts", lambda: parts_table(programs / "parts_comparison", arguments.meshes)))
    with (arguments.out / "performance.md").open("w") as out:
        for title, table in tables:
            print(f"## {title}\n\n" + "\n".join(table()) + "\n", file=out, flush=True)
    plot(rows, arguments.out / "performance.svg")


if __name__ == "__main__":
    main()
