#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Prints how many processes run at a time without swapping: one for each processor, but no more than fit into the memory
# that is free.
#
#   scripts/number_of_jobs.sh MEGABYTES       what a process may take
set -euo pipefail

if [ $# -ne 1 ]; then
  echo "usage: $0 MEGABYTES" >&2
  exit 2
fi
each=$1
processors=$(nproc)
free=$(($(sed --quiet 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo) / 1024))
# A container may have less.
limit=$(cat /sys/fs/cgroup/memory.max 2> /dev/null || echo max)
if [ "$limit" != max ]; then
  left=$(((limit - $(cat /sys/fs/cgroup/memory.current)) / 1048576))
  free=$((left < free ? left : free))
fi

jobs=$((free / each))
if [ "$jobs" -lt 1 ]; then
  echo "$free MB of memory are free; a compiler may take $each MB, and then this machine swaps." >&2
  jobs=1
elif [ "$jobs" -lt "$processors" ]; then
  echo "$free MB of memory are free, a compiler may take $each MB: $jobs at a time, with $processors processors." >&2
else
  jobs=$processors
fi
echo "$jobs"
