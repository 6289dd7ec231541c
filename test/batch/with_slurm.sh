#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A Slurm job array gives the lines of constrictions batch; when a task has been lost, submitting it again is enough.
#
#   with_slurm.sh PROGRAM MESHES SCRIPTS        exit code 77: Slurm cannot be used here
set -euo pipefail

source "$(dirname "${BASH_SOURCE[0]}")/compare.sh"

submit=(sbatch --wait --quiet --output=task_%a.txt)
export CONSTRICTIONS="$program"
"$scripts/with_slurm.sh" bash -euc '"$@" && rm array/results.2-of-3.jsonl && "$@"' bash \
  "${submit[@]}" --array=1-3 "$scripts/batch_array.sh" list.txt -o array --quiet "${options[@]}"
cat task_*.txt
cat array/results.*.jsonl | expect_same_lines "job array"
