#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that the C++ files which differ from a commit are formatted as .clang-format says. The version of clang-format
# is pinned, since each formats a little differently; Debian 12 has it as the package clang-format-14.
#
#   scripts/check_format.sh [COMMIT]       files that differ from COMMIT; from the last commit if it is not given
#   scripts/check_format.sh --all          all files
#
# Prints for each file how many lines would change, and fails if there are any.
set -euo pipefail

version=14
cd "$(dirname "${BASH_SOURCE[0]}")/.."
formatter=
for candidate in clang-format-$version clang-format; do
  if command -v "$candidate" > /dev/null && "$candidate" --version | grep --quiet "version $version\."; then
    formatter=$candidate
    break
  fi
done
if [ -z "$formatter" ]; then
  echo "$0: clang-format $version is not installed" >&2
  exit 2
fi

if [ "${1:-}" = --all ]; then
  mapfile -d '' files < <(git ls-files -z '*.h' '*.cpp')
else
  mapfile -d '' files < <(git diff -z --name-only --diff-filter=d "${1:-HEAD}" -- '*.h' '*.cpp')
fi
lines=0 different=0
for file in "${files[@]}"; do
  n=$(diff "$file" <("$formatter" --style=file "$file") | grep -c '^<' || true)
  if [ "$n" -gt 0 ]; then
    echo "$file: $n"
    lines=$((lines + n))
    different=$((different + 1))
  fi
done
echo "${#files[@]} files, $different of them not formatted: $lines lines"
[ "$different" -eq 0 ]
