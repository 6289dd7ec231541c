#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails unless a compiler reports exactly the given sentences as errors, in any order, and soon.

  check_misuse.py LINES SENTENCE... -- COMMAND...

LINES is how many lines there may be up to an error, from the start or from the one before, and after the last one.
"""
import subprocess
import sys


def main():
    separator = sys.argv.index("--")
    allowed, sentences, command = int(sys.argv[1]), sys.argv[2:separator], sys.argv[separator + 1:]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    lines = run.stdout.splitlines()
    errors = [number for number, line in enumerate(lines) if " error: " in line]
    failures = []
    if run.returncode == 0:
        failures.append("it compiles")
    missing = list(sentences)
    for number in errors:
        sentence = next((s for s in missing if s in lines[number]), None)
        if sentence is None:
            failures.append(f"not expected: {lines[number]}")
        else:
            missing.remove(sentence)
    failures += [f"not said: {sentence}" for sentence in missing]
    ends = [-1, *errors, len(lines)]
    longest = max(end - start for start, end in zip(ends, ends[1:]))
    if longest > allowed:
        failures.append(f"{longest} lines up to an error, or after the last one; {allowed} are allowed")
    print("\n".join(failures) or f"{len(errors)} errors in {len(lines)} lines, at most {longest} for each.")
    if failures:
        print(run.stdout)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
