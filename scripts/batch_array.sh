#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a task of a Slurm job array: constrictions batch for every N-th mesh, where N is the number of tasks of the
# array. The program constrictions must be in the PATH, or the variable CONSTRICTIONS must say where it is.
#
#   sbatch --array=1-N scripts/batch_array.sh INPUT ... -o DIR [OPTIONS]      the arguments of constrictions batch
#
# The lines are in DIR/results.I-of-N.jsonl. When a task that was cut off is submitted again, it goes on where it was.
#SBATCH --job-name=constrictions
set -euo pipefail

index=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))
exec "${CONSTRICTIONS:-constrictions}" batch "$@" --slice "$index/$SLURM_ARRAY_TASK_COUNT" -j "${SLURM_CPUS_PER_TASK:-1}"
