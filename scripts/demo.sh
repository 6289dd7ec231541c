#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the program and finds the constrictions of the armadillo, one of CGAL's example meshes. A compiler takes up to
# 2 GB of memory.
#
#   scripts/demo.sh
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$project/build/demo"
meshes="$project/data/meshes"
results="$build/armadillo"
program="$build/tools/constrictions/constrictions"

"$project/scripts/setup.sh" --program
"$project/scripts/fetch_meshes.sh" "$meshes"

cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release -DWITH_TESTS=OFF -DWITH_EXAMPLES=OFF \
  ${CGAL_DIR:+"-DCGAL_DIR=$CGAL_DIR"}
cmake --build "$build" --parallel "$("$project/scripts/number_of_jobs.sh" 2000)" --target constrictions

"$program" detect "$meshes/armadillo.off" -o "$results" --quiet
page="$results/armadillo.html"
rm -f "$page"
# Without its viewer the program says so.
"$program" view "$meshes/armadillo.off" -o "$page" --quiet || true
echo
echo "The constrictions of the armadillo:"
"$program" detect "$meshes/armadillo.off" --quiet
echo
if [ -e "$page" ]; then
  echo "Open $page in a browser to see them. As files they are beside it."
else
  echo "Open $results/constrictions.ply in a program that shows meshes to see them."
fi
