#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flips each comparison of the headers that decide, one at a time, and looks whether a test notices.

  scripts/mutation/run.py BUILD_DIR [--group GROUP] [--headers A.h,B.h,...] [--only N,N,...] [--longest SECONDS]
                          [--jobs N]

A copy of the sources in BUILD_DIR is compiled once, with a switch in each comparison (see switched_comparison.h); the
test programs of the group then run once per comparison, with that one flipped, until a test fails. A crash counts as
noticed, and so does a run that takes much more time or memory than the tests need. Prints the survivors; the exit code
is 1 if there are any that equivalent.txt does not list.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
HEADERS = "include/CGAL/Surface_mesh_constrictions"
GROUPS = {
    "certificate": {
        "headers": ["Certifier.h", "Side_angle.h", "Exact_simplicity.h", "Exact_settler.h", "Sign_prover.h",
                    "Exact_flat_band.h", "Flat_closed_strip.h", "Exact_string_puller.h", "Exact_arc.h",
                    "floating_point_defect.h"],
        "programs": ["test_certificates"],
    },
    "tightening": {
        "headers": ["Tightener.h", "String_puller.h", "Closed_strip.h", "Flat_band.h"],
        "programs": ["test_detection", "test_certificates"],
    },
    "verification": {
        "headers": ["Arc_verifier.h"],
        "programs": ["test_verification"],
    },
    "prominence": {
        "headers": ["Barrier_search.h", "Boundary_tightener.h", "Descents.h", "Detected_hierarchy.h", "Distance_front.h",
                    "Distance_sweep.h", "Front_start.h", "Level_lengths.h", "pinches.h", "vertex_passes.h"],
        "programs": ["test_detection"],
    },
    "selection": {
        "headers": ["select_constrictions.h", "composed_constrictions.h", "ranks_before.h", "remove_beside_others.h",
                    "rivals.h"],
        "programs": ["test_detection"],
    },
}
# Binary operators have a space on both sides; `> >` closes template arguments.
COMPARISON = re.compile(r"(?<!>)(?<!operator) (<=|>=|==|!=|<|>) (?![>{])")
MEMORY_LIMIT = 4 << 30  # bytes, of a test program
STEPS = [0.02, 0.1, 0.5, 2]  # seconds: tests that take less are run before those that take more


class Comparison:
    """A place in a header. `name` does not change when lines are put before it; it is what equivalent.txt lists."""

    def __init__(self, number, header, line, column, operator, text):
        indentation = len(text) - len(text.lstrip())
        before, after = text[indentation:column], text[column + len(operator):].rstrip()
        self.number = number
        self.place = f"{header}:{line}:{column + 1}"
        self.name = f"{header}: {before}[{operator}]{after}"

    def __str__(self):
        return f"{self.number:4} {self.place}  {self.name}"


def path_of(header):
    """The path of a header: a public one, or an internal one, whichever stage it belongs to."""
    found = [path for pattern in (header, f"internal/*/{header}") for path in (PROJECT / HEADERS).glob(pattern)]
    if len(found) != 1:
        raise SystemExit(f"{len(found)} headers {header} in {HEADERS} and its folders")
    return str(found[0].relative_to(PROJECT))


def instrument(text, comparisons, header):
    """Puts a switch into each comparison, and appends it to `comparisons`."""
    lines = []
    for line_number, line in enumerate(text.split("\n"), 1):
        code = line.split("//")[0]
        if code.lstrip().startswith(("#", "template", "static_assert")):
            lines.append(line)
            continue

        def switched(match, line_number=line_number, line=line):
            number, operator = len(comparisons) + 1, match.group(1)
            comparisons.append(Comparison(number, header, line_number, match.start(1), operator, line))
            return f" {operator} ::switched_comparison::at({number}) {operator} "

        lines.append(COMPARISON.sub(switched, code) + line[len(code):])
    return "\n".join(lines)


def write_if_changed(path, content):
    if path.is_file() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def build(build_dir, headers, programs, jobs):
    """Compiles the instrumented copy; returns the comparisons and the programs."""
    source = build_dir / "source"
    comparisons = []
    instrumented = {path_of(header): instrument((PROJECT / path_of(header)).read_text(), comparisons, header)
                    for header in headers}
    # A chain of comparisons is what compilers warn of.
    instrumented["cmake/constrictions_warnings.cmake"] = "add_library(constrictions_warnings INTERFACE)\n"
    files = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=PROJECT, check=True,
                           capture_output=True, text=True).stdout.splitlines()
    for file in files:
        if file in instrumented:
            write_if_changed(source / file, instrumented[file].encode())
        elif (PROJECT / file).is_file():
            write_if_changed(source / file, (PROJECT / file).read_bytes())
    subprocess.run(["cmake", "-S", source, "-B", build_dir / "build", "-DCMAKE_BUILD_TYPE=Release",
                    f"-DCMAKE_CXX_FLAGS=-include {HERE / 'switched_comparison.h'}",
                    "-DWITH_TOOLS=OFF", "-DWITH_EXAMPLES=OFF", "-DWITH_HEADER_CHECK=OFF", "-DWITH_QUICK_COMPILATION=ON",
                    f"-DCONSTRICTIONS_MESH_DIR={PROJECT / 'data/meshes'}"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build_dir / "build", "--parallel", str(jobs), "--target", *programs],
                   check=True)
    return comparisons, [build_dir / "build/test/Surface_mesh_constrictions" / program for program in programs]


class Run:
    """Some tests of a program."""

    def __init__(self, program, tests, seconds):
        self.command = [program, "--gtest_fail_fast", "--gtest_brief=1", "--gtest_filter=" + ":".join(tests)]
        self.timeout = 10 + 5 * seconds

    def notices(self, number):
        try:
            return subprocess.run(self.command, timeout=self.timeout, env={**os.environ, "MUTANT": str(number)},
                                  preexec_fn=limit_memory, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL).returncode != 0
        except subprocess.TimeoutExpired:
            return True


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def runs_of(program, longest):
    """Runs the tests with nothing flipped; returns what to run, the quick tests first."""
    report = program.with_suffix(".json")
    if not report.exists() or report.stat().st_mtime < program.stat().st_mtime:
        subprocess.run([program, "--gtest_brief=1", f"--gtest_output=json:{report}"], check=True,
                       preexec_fn=limit_memory)
    tests = [(float(test["time"].rstrip("s")), f"{suite['name']}.{test['name']}")
             for suite in json.loads(report.read_text())["testsuites"] for test in suite["testsuite"]]
    result = []
    for low, high in zip([0, *STEPS], [*STEPS, float("inf")]):
        step = [(seconds, name) for seconds, name in tests if low <= seconds < high and seconds <= longest]
        if step:
            result.append(Run(program, [name for _, name in step], sum(seconds for seconds, _ in step)))
    return result


def equivalent_names():
    lines = (HERE / "equivalent.txt").read_text().splitlines()
    return {line for line in lines if line and not line.startswith((" ", "#"))}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build_dir", type=pathlib.Path)
    parser.add_argument("--group", choices=GROUPS, default="certificate")
    parser.add_argument("--headers", help="of the group, separated by commas; all if not given")
    parser.add_argument("--only", help="numbers of comparisons, separated by commas")
    parser.add_argument("--longest", type=float, default=float("inf"),
                        help="leaves out tests that take more seconds than this when nothing is flipped")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the build")
    arguments = parser.parse_args()

    group = GROUPS[arguments.group]
    headers = arguments.headers.split(",") if arguments.headers else group["headers"]
    comparisons, programs = build(arguments.build_dir.resolve() / arguments.group, headers, group["programs"],
                                  arguments.jobs)
    if arguments.only:
        only = {int(number) for number in arguments.only.split(",")}
        comparisons = [c for c in comparisons if c.number in only]
    runs = [run for program in programs for run in runs_of(program, arguments.longest)]
    equivalent = equivalent_names()
    survivors = []
    for comparison in comparisons:
        verdict = "noticed"
        if not any(run.notices(comparison.number) for run in runs):
            verdict = "equivalent" if comparison.name in equivalent else "SURVIVES"
            survivors.append(comparison)
        print(f"{verdict:10} {comparison}", flush=True)
    unlisted = [c for c in survivors if c.name not in equivalent]
    print(f"{len(comparisons)} flipped, {len(comparisons) - len(survivors)} noticed, "
          f"{len(survivors) - len(unlisted)} equivalent, {len(unlisted)} survive")
    for comparison in unlisted:
        print(comparison)
    sys.exit(1 if unlisted else 0)


if __name__ == "__main__":
    main()
