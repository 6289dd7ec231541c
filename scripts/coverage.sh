#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the test programs and prints which share of the lines of include/ they execute, and which lines they do not.
#
#   scripts/coverage.sh [PERCENT]      fails below this share; 95 if it is not given
#
# Neither the program nor the examples are built: what only they execute counts as not executed.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$project/build/coverage"
jobs=$(nproc)
compilers=$("$project/scripts/number_of_jobs.sh" 3900)

"$project/scripts/setup.sh" gcovr
"$project/scripts/fetch_meshes.sh" "$project/data/meshes"

cd "$project"
cmake --preset coverage -DWITH_QUICK_COMPILATION=ON -DWITH_TOOLS=OFF -DWITH_PYTHON=OFF -DWITH_EXAMPLES=OFF \
  -DWITH_HEADER_CHECK=OFF
cmake --build --preset coverage --parallel "$compilers"
find "$build" -name '*.gcda' -delete # what earlier runs executed
ctest --test-dir "$build/test/Surface_mesh_constrictions" --output-on-failure --no-tests=error --parallel "$jobs"

mkdir -p "$build/report"
gcovr --root . --filter include/ --object-directory "$build" "$build/test" \
  --fail-under-line "${1:-95}" \
  --txt --print-summary --html-details "$build/report/index.html"
echo "Line by line: $build/report/index.html"
