#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# GNU parallel, with a mesh for each of its jobs, gives the lines of constrictions batch.
#
#   with_parallel.sh PROGRAM MESHES SCRIPTS        exit code 77: GNU parallel is not installed
set -euo pipefail

if ! parallel --version 2> /dev/null | grep -q '^GNU parallel'; then
  echo "GNU parallel is not installed (package parallel): skipped"
  exit 77
fi
source "$(dirname "${BASH_SOURCE[0]}")/compare.sh"

parallel -j 3 "$program" batch "${options[@]}" {} :::: list.txt > printed.jsonl
expect_same_lines "a mesh for each job" < printed.jsonl

parallel -j 2 "$program" batch list.txt -o slices --quiet "${options[@]}" -j 1 --slice {}/3 ::: 1 2 3
cat slices/results.*.jsonl | expect_same_lines "slices"

# parallel's own way to resume: what its log has as done is not done again
head -n 4 list.txt > begin.txt
parallel --joblog log.txt "$program" batch "${options[@]}" {} :::: begin.txt > begin.jsonl
parallel --joblog log.txt --resume "$program" batch "${options[@]}" {} :::: list.txt > rest.jsonl
cat begin.jsonl rest.jsonl | expect_same_lines "resumed"
