#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if a header includes one of a later stage: includes run with the order of the stages.

  scripts/check_include_order.py

The folders of `internal/` are the stages. A public header belongs to the stage of the last internal header that it
includes, directly or not; it must not be included by a header of an earlier one. Prints each include that runs against
the order, and each header that is in no folder of the list below. And of the program, each file but system/posix.cpp
that includes a header of POSIX.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "include/CGAL/Surface_mesh_constrictions"
PROGRAM = ROOT / "tools/constrictions"
STAGES = ["surface", "curves", "tighten", "exact", "simplify", "seeds", "prominence", "carry", "detect", "parts",
          "verify"]
INCLUDE = re.compile(r"^#include <CGAL/Surface_mesh_constrictions/([^>]+)>", re.MULTILINE)
POSIX = re.compile(r"^#include <((?:sys/.*|aio|csignal|dirent|dlfcn|fcntl|ftw|glob|poll|pthread|pwd|sched|semaphore|signal"
                   r"|spawn|strings|syslog|termios|unistd|utime|wordexp)(?:\.h)?)>", re.MULTILINE)


def main():
    included = {str(path.relative_to(PACKAGE)): INCLUDE.findall(path.read_text())
                for path in sorted(PACKAGE.rglob("*.h"))}
    stages, failures = {}, []

    def stage(header):
        """Number of the stage of a header, and the include that puts a public one there."""
        if header not in stages:
            parts = header.split("/")
            if parts[0] == "internal":
                if len(parts) != 3 or parts[1] not in STAGES:
                    failures.append(f"{header} is in the folder of no stage")
                stages[header] = STAGES.index(parts[1]) if len(parts) == 3 and parts[1] in STAGES else 0
            else:
                stages[header] = 0  # for a public header that includes itself on the way
                stages[header] = max((stage(i) for i in included[header] if i in included), default=0)
        return stages[header]

    for header, includes in included.items():
        for i in includes:
            if i not in included:
                failures.append(f"{header} includes {i}, which is not there")
            elif stage(i) > stage(header):
                failures.append(f"{header} ({STAGES[stage(header)]}) includes {i} ({STAGES[stage(i)]})")
    for path in sorted(PROGRAM.rglob("*.h")) + sorted(PROGRAM.rglob("*.cpp")):
        if path != PROGRAM / "system/posix.cpp":
            failures += [f"{path.relative_to(ROOT)} includes {header}; what needs it belongs to system/posix.cpp"
                         for header in POSIX.findall(path.read_text())]
    print("\n".join(failures) or f"{len(included)} headers include with the order of the stages.")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
