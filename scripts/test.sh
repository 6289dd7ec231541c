#!/usr/bin/env bash
# Builds everything and runs all tests. The last line is ctest's summary, the exit code is ctest's.
#
#   scripts/test.sh [PRESET]        one of CMakePresets.json; release if none is given
#
# If CGAL_DIR is set, that CGAL is used instead of the installed one.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-release}
build="$project/build/$preset"
log="$build/ctest.log"

"$project/scripts/setup.sh"
"$project/scripts/fetch_meshes.sh" "$project/data/meshes"

cd "$project"
cmake --preset "$preset" -DWITH_BENCHMARKS=ON ${CGAL_DIR:+"-DCGAL_DIR=$CGAL_DIR"}
cmake --build --preset "$preset" --parallel "$(nproc)"

status=0
ctest --preset "$preset" --parallel "$(nproc)" --output-log "$log" || status=$?
grep -E 'tests passed|No tests were found' "$log" | tail -n 1
exit "$status"
