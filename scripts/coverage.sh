#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests and prints which share of the lines of include/ they execute, and which lines they do not.
#
#   scripts/coverage.sh [PERCENT]      fails below this share; 95 if it is not given
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$project/build/coverage"

"$project/scripts/setup.sh" gcovr
find "$build" -name '*.gcda' -delete 2> /dev/null || true # what earlier runs executed
"$project/scripts/test.sh" coverage

cd "$project"
gcovr --root . --filter include/ --object-directory "$build" "$build" \
  --exclude-unreachable-branches --exclude-throw-branches --fail-under-line "${1:-95}" \
  --txt --print-summary --html-details "$build/coverage.html"
echo "Line by line: $build/coverage.html"
