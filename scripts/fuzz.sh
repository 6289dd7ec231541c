#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes with libFuzzer, starting from the inputs in test/fuzz/corpus. Then replaces these by the smallest inputs that
# together reach all that the inputs found so far reach. An input that fails is kept, and printed as a line for the
# corpus; the exit code is then 1. The other inputs that were found are in build/fuzz/corpus, and are used the next
# time.
#
#   scripts/fuzz.sh MINUTES [TARGET...]      minutes for all targets together; all of them, if none is given
#
#   meshes         small meshes: detection, certificates, tightening, hierarchy and selection against the oracle
#   mesh_readers   files of meshes
#   curve_readers  files of curves, loops and labels
set -euo pipefail

if [ $# -eq 0 ] || ! [[ $1 =~ ^[0-9]+$ ]]; then
  echo "usage: $0 MINUTES [TARGET...]" >&2
  exit 2
fi
seconds=$(($1 * 60))
shift
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ $# -gt 0 ] || set -- meshes mesh_readers curve_readers

scripts/setup.sh clang
clang_version=$(clang++ -dumpversion)
scripts/setup.sh "libclang-rt-${clang_version%%.*}-dev"
cmake --preset clang-fuzzing
cmake --build --preset clang-fuzzing --parallel "$(scripts/number_of_jobs.sh 3900)" --target "${@/#/fuzz_}"

# Before the marker the comments and the inputs stay: these have failed once, or were made by hand.
pack() { # FOLDER CORPUS
  python3 - "$@" << 'END'
import pathlib, sys
corpus, marker = pathlib.Path(sys.argv[2]), "# reaches what the others do not:"
kept = (corpus.read_text() if corpus.exists() else "").partition(marker)[0].splitlines()
found = sorted((p.read_bytes().hex() for p in pathlib.Path(sys.argv[1]).iterdir()), key=lambda x: (len(x), x))
corpus.write_text("\n".join(kept + [marker] + [x for x in found if x not in kept]) + "\n")
END
}

# Inputs are written to files that are read at once; the stack of each allocation is not worth its time.
[ ! -d /dev/shm ] || export TMPDIR=/dev/shm
export ASAN_OPTIONS=malloc_context_size=1:quarantine_size_mb=8

status=0
for target in "$@"; do
  folder=build/fuzz/corpus/$target
  least=build/fuzz/least/$target
  failures=build/fuzz/failures
  rm -rf "$least"
  mkdir -p "$folder" "$least" "$failures"
  scripts/unpack_corpus.py "test/fuzz/corpus/$target.hex" "$folder"
  log=build/fuzz/$target.log
  longest=$([ "$target" = meshes ] && echo 96 || echo 1536)
  dictionary=()
  [ ! -f "test/fuzz/$target.dict" ] || dictionary=("-dict=test/fuzz/$target.dict")
  # Of thousands of short inputs a second, the statistics of features took half of the time.
  if ! "build/clang-fuzzing/test/fuzz/fuzz_$target" -max_total_time=$((seconds / $#)) -max_len="$longest" -timeout=60 \
    -entropic=0 -reload=0 -print_funcs=0 "${dictionary[@]}" -rss_limit_mb=3000 -print_final_stats=1 -artifact_prefix="$failures/$target-" "$folder" > "$log" 2>&1; then
    status=1
    grep -E 'FAILURE|ERROR|SUMMARY' "$log" || true
    for input in "$failures/$target"-*; do
      echo "$input: $(od -An -tx1 -v "$input" | tr -d " \n")"
    done
    continue
  fi
  grep -E '^stat::number_of_executed_units|curves: ' "$log" | sed "s/^/$target: /"
  # An input that only runs a line more often than the others need not be kept.
  "build/clang-fuzzing/test/fuzz/fuzz_$target" -merge=1 -use_counters=0 -timeout=60 -rss_limit_mb=3000 -max_len="$longest" "$least" \
    "$folder" > build/fuzz/merge.log 2>&1
  pack "$least" "test/fuzz/corpus/$target.hex"
done
exit "$status"
