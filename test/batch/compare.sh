# SPDX-License-Identifier: GPL-3.0-or-later
# For the tests in this folder, which are called with PROGRAM MESHES SCRIPTS.

program=$1 meshes=$2 scripts=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Good meshes and some that cannot be used, one of them with an awkward name; one is missing.
cp "$meshes"/{anchor,cactus,eight,sphere,tetrahedron,bones,hand,P}.off .
cp eight.off "it's  \"8\" \$1.off"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > open.off
ls ./*.off > list.txt
echo missing.off >> list.txt
options=(--seeds triangles --max 5)

# The lines on the standard input, without what depends on the machine, in a fixed order.
lines() {
  sed -E 's/,"seconds":[^,]*,"peak_rss_bytes":[0-9]*\}$/}/' | sort
}

"$program" batch list.txt -o expected --quiet "${options[@]}"
lines < expected/results.jsonl > expected.txt
[ "$(wc -l < expected.txt)" -eq "$(wc -l < list.txt)" ]

# Compares the lines on the standard input.
expect_same_lines() {
  lines > found.txt
  diff expected.txt found.txt
  echo "$1: $(wc -l < found.txt) lines, the same"
}
