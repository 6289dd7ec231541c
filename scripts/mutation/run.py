#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flips each comparison of the headers that decide, one at a time, and looks whether a test notices.

  scripts/mutation/run.py BUILD_DIR [--group certificate|tightening] [--only N,N,...] [--timeout SECONDS]

A copy of the sources in BUILD_DIR is compiled once, with a switch in each comparison (see switched_comparison.h); the
test programs of the group then run once per comparison, with that one flipped, until a test fails. A crash and a run that
takes longer than the timeout count as noticed. Prints the survivors; the exit code is 1 if there are any.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = "include/CGAL/Surface_mesh_constrictions/internal"
GROUPS = {
    "certificate": {
        "headers": ["Sign_prover.h", "Side_angle.h", "Certifier.h", "Exact_arc.h", "Exact_flat_band.h",
                    "Exact_settler.h", "Exact_simplicity.h", "Exact_string_puller.h"],
        "programs": ["test_certificates"],
    },
    "tightening": {
        "headers": ["Tightener.h", "String_puller.h"],
        "programs": ["test_detection"],
    },
}
# Binary operators have a space on both sides; `> >` closes template arguments.
COMPARISON = re.compile(r"(?<!>)(?<!operator) (<=|>=|==|!=|<|>) (?![>{])")


def instrument(text, first, places, name):
    """Puts a switch into each comparison, numbered from `first`; appends (number, header, line, column, text)."""
    lines = []
    for line_number, line in enumerate(text.split("\n"), 1):
        code = line.split("//")[0]
        if code.lstrip().startswith(("#", "template", "static_assert")):
            lines.append(line)
            continue

        def switched(match):
            number = first + len(places)
            places.append((number, name, line_number, match.start(1) + 1, line.strip()))
            operator = match.group(1)
            return f" {operator} ::switched_comparison::at({number}) {operator} "

        lines.append(COMPARISON.sub(switched, code) + line[len(code):])
    return "\n".join(lines)


def build(build_dir, group):
    """Compiles the instrumented copy; returns the places and the programs."""
    source = build_dir / "source"
    shutil.rmtree(source, ignore_errors=True)
    files = subprocess.run(["git", "ls-files"], cwd=PROJECT, check=True, capture_output=True, text=True).stdout.split("\n")
    for file in filter(None, files):
        if (PROJECT / file).is_file():
            (source / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(PROJECT / file, source / file)
    places = []
    for header in GROUPS[group]["headers"]:
        path = source / HEADERS / header
        path.write_text(instrument(path.read_text(), 1, places, header))
    # A chain of comparisons is what compilers warn of.
    (source / "cmake/constrictions_warnings.cmake").write_text("add_library(constrictions_warnings INTERFACE)\n")
    switch = PROJECT / "scripts/mutation/switched_comparison.h"
    programs = GROUPS[group]["programs"]
    subprocess.run(["cmake", "-S", source, "-B", build_dir / group, "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", f"-DCMAKE_CXX_FLAGS=-include {switch}",
                    "-DWITH_TOOLS=OFF", "-DWITH_EXAMPLES=OFF", "-DWITH_HEADER_CHECK=OFF", "-DWITH_UNITY_TESTS=ON",
                    f"-DCONSTRICTIONS_MESH_DIR={PROJECT / 'data/meshes'}"], check=True)
    subprocess.run(["cmake", "--build", build_dir / group, "--parallel", str(os.cpu_count()), "--target", *programs],
                   check=True)
    return places, [build_dir / group / "test/Surface_mesh_constrictions" / p for p in programs]


def is_noticed(programs, number, timeout):
    for program in programs:
        try:
            run = subprocess.run([program, "--gtest_fail_fast", "--gtest_brief=1"], timeout=timeout,
                                 env={**os.environ, "MUTANT": str(number)},
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return True
        if run.returncode != 0:
            return True
    return False


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build_dir", type=pathlib.Path)
    parser.add_argument("--group", choices=GROUPS, default="certificate")
    parser.add_argument("--only", help="numbers of comparisons, separated by commas")
    parser.add_argument("--timeout", type=float, default=300, help="seconds per program and comparison")
    arguments = parser.parse_args()

    places, programs = build(arguments.build_dir.resolve(), arguments.group)
    if is_noticed(programs, 0, arguments.timeout):
        sys.exit("the tests fail without a flipped comparison")
    only = {int(n) for n in arguments.only.split(",")} if arguments.only else {p[0] for p in places}
    survivors = []
    for place in (p for p in places if p[0] in only):
        noticed = is_noticed(programs, place[0], arguments.timeout)
        print(f"{place[0]:4} {'noticed ' if noticed else 'SURVIVES'} {place[1]}:{place[2]}:{place[3]}: {place[4]}",
              flush=True)
        if not noticed:
            survivors.append(place)
    print(f"{len(survivors)} of {len(only)} flipped comparisons are not noticed")
    for number, header, line, column, text in survivors:
        print(f"{HEADERS}/{header}:{line}:{column}: {text}")
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    main()
