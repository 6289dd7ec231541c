#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the program and finds the constrictions of the armadillo, one of CGAL's example meshes.
#
#   scripts/demo.sh
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$project/build/demo"
meshes="$project/data/meshes"
results="$build/armadillo"

"$project/scripts/setup.sh" --program
"$project/scripts/fetch_meshes.sh" "$meshes"

cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release -DWITH_TESTS=OFF -DWITH_EXAMPLES=OFF \
  ${CGAL_DIR:+"-DCGAL_DIR=$CGAL_DIR"}
cmake --build "$build" --parallel "$(nproc)" --target constrictions

"$build/tools/constrictions/constrictions" detect "$meshes/armadillo.off" -o "$results"
"$build/tools/constrictions/constrictions" view "$meshes/armadillo.off" -o "$results/armadillo.html" --quiet || true
echo
echo "The constrictions of $meshes/armadillo.off are in"
find "$results" -type f | sort
