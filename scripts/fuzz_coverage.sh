#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Prints how many lines of the readers, of the certificate and of the second witness are reached by fuzzing alone: by
# the inputs in test/fuzz/corpus and those that scripts/fuzz.sh has found.
#
#   scripts/fuzz_coverage.sh [FOLDER...]     FOLDER/TARGET may have more inputs of a target, one a file
#
# The lines that are not reached are in build/fuzz/coverage/lines.txt, with a count of 0.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh clang
clang_version=$(clang++ -dumpversion)
scripts/setup.sh "libclang-rt-${clang_version%%.*}-dev" "llvm-${clang_version%%.*}"
# A cache of the compiler that makes paths relative would hide the headers from llvm-cov.
export CCACHE_BASEDIR=
cmake --preset clang-fuzzing -B build/clang-fuzz-coverage \
  -DCMAKE_CXX_FLAGS="-fprofile-instr-generate -fcoverage-mapping"
cmake --build build/clang-fuzz-coverage --parallel "$(scripts/number_of_jobs.sh 3900)" \
  --target fuzz_mesh_readers fuzz_curve_readers fuzz_meshes
out=build/fuzz/coverage
mkdir -p "$out"
[ ! -d /dev/shm ] || export TMPDIR=/dev/shm

programs=()
profiles=()
for target in mesh_readers curve_readers meshes; do
  inputs="$out/$target.inputs"
  rm -rf "$inputs"
  mkdir -p "$inputs"
  scripts/unpack_corpus.py "test/fuzz/corpus/$target.hex" "$inputs"
  folders=("$inputs")
  for folder in build/fuzz/corpus "$@"; do
    [ ! -d "$folder/$target" ] || folders+=("$folder/$target")
  done
  program="build/clang-fuzz-coverage/test/fuzz/fuzz_$target"
  LLVM_PROFILE_FILE="$out/$target.profraw" "$program" -runs=0 "${folders[@]}" > "$out/$target.log" 2>&1
  [ ${#programs[@]} -eq 0 ] || programs+=(-object)
  programs+=("$program")
  profiles+=("$out/$target.profraw")
done

"llvm-profdata-${clang_version%%.*}" merge -sparse "${profiles[@]}" -o "$out/all.profdata"
internal=include/CGAL/Surface_mesh_constrictions/internal
: > "$out/lines.txt"
exec 2> "$out/llvm-cov.log" # warns of small functions that the programs compile differently
for room in tools/constrictions/input "$internal/exact" "$internal/verify"; do
  mapfile -t sources < <(find "$PWD/$room" -name '*.cpp' -o -name '*.h' | sort)
  echo "$room"
  "llvm-cov-${clang_version%%.*}" report "${programs[@]}" "-instr-profile=$out/all.profdata" "${sources[@]}" |
    awk '$1 != "Filename" && NF >= 10 {printf "  %-32s %5d lines, %5d not reached, %s\n", $1, $8, $9, $10}'
  "llvm-cov-${clang_version%%.*}" show "${programs[@]}" "-instr-profile=$out/all.profdata" "${sources[@]}" \
    >> "$out/lines.txt"
done
