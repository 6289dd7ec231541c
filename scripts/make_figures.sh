#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the README and the manual with the pages of `constrictions view`, in a browser without a screen.
#
#   scripts/make_figures.sh [PROGRAM]      the program; if none is given it is built
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
meshes="$project/data/meshes"
figures="$project/doc/Surface_mesh_constrictions/fig"
program=${1:-}

"$project/scripts/setup.sh" --browser
(cd "$project/tools/viewer" && npm ci --ignore-scripts --no-audit --no-fund --silent)
"$project/scripts/fetch_meshes.sh" "$meshes"
if [ -z "$program" ]; then
  build="$project/build/demo"
  cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release -DWITH_TESTS=OFF -DWITH_EXAMPLES=OFF \
    ${CGAL_DIR:+"-DCGAL_DIR=$CGAL_DIR"}
  cmake --build "$build" --parallel "$("$project/scripts/number_of_jobs.sh" 2000)" --target constrictions
  program="$build/tools/constrictions/constrictions"
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# figure FIGURE MESH SIZE "OPTIONS" ADDRESS...
figure() {
  local name=$1 mesh=$2 size=$3 page="$work/$2.html"
  local options
  read -r -a options <<< "$4"
  shift 4
  "$program" view "$meshes/$mesh.off" -o "$page" --quiet "${options[@]}"
  node "$project/tools/viewer/picture.js" "$page" "$figures/$name.png" "$size" "$@"
  echo "$name.png"
}

figure armadillo armadillo 900x900 "" '#panel=0&theme=light&side=object&parts=0&width=4&view=0.2,0.15,1'
figure cactus cactus 700x700 "" '#panel=0&theme=light&parts=0&width=4'
figure elephant elephant 800x800 "" '#panel=0&theme=light&parts=0&width=4&view=0.35,0.2,1'
figure camel_parts camel 800x800 "" '#panel=0&theme=light&side=object&width=3&view=-0.5,0.25,1'
figure viewer armadillo 1280x800 "" '#theme=light&side=object&select=6'
figure playback elephant 640x640 "" \
  '#panel=0&theme=light&view=0.35,0.2,1&frame=6' '#panel=0&theme=light&view=0.35,0.2,1&frame=16' \
  '#panel=0&theme=light&view=0.35,0.2,1&frame=30' '#panel=0&theme=light&view=0.35,0.2,1&frame=1000'
