#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that nothing in a build folder was compiled with headers of another CGAL than the one that was chosen.

  scripts/check_cgal_dependencies.py BUILD_DIR INCLUDE_DIR...

INCLUDE_DIR is a folder with the other CGAL, such as /usr/include. What was compiled with what is taken from the
dependencies that compilers wrote: from the files *.d, or with Ninja, which keeps them in a file of its own, from Ninja.
Prints the files that depend on the other CGAL, and fails; also if no dependency on any CGAL is found.
"""

import pathlib
import re
import subprocess
import sys


def dependencies(build):
    """Pairs of what was compiled and the names of its headers."""
    if (build / "build.ninja").exists():
        listed = subprocess.run(["ninja", "-C", build, "-t", "deps"], check=True, capture_output=True, text=True).stdout
        for block in listed.split("\n\n"):
            lines = block.split("\n")
            yield lines[0].split(":")[0], [line.strip() for line in lines[1:]]
    for file in build.rglob("*.d"):
        if file.is_file():
            yield str(file), re.split(r"\s+", file.read_text(errors="replace").replace("\\\n", " "))


def main():
    build = pathlib.Path(sys.argv[1])
    others = [folder.rstrip("/") + "/CGAL/" for folder in sys.argv[2:]]
    of_chosen, mixed = 0, 0
    for target, headers in dependencies(build):
        for header in headers:
            if any(header.startswith(other) for other in others):
                print(f"{target}: {header}")
                mixed += 1
                break
        else:
            of_chosen += any("/CGAL/version.h" in header for header in headers)
    print(f"{of_chosen} files were compiled with the chosen CGAL, {mixed} with headers of another one")
    return 1 if mixed > 0 or of_chosen == 0 else 0


sys.exit(main())
