#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Prints how many lines of the readers, of the certificate and of the second witness are reached by fuzzing alone: by
# the inputs in test/fuzz/corpus and those that scripts/fuzz.sh has found.
#
#   scripts/fuzz_coverage.sh [FOLDER...]     FOLDER/TARGET may have more inputs of a target, one a file
#
# The lines that are not reached are in build/fuzz/coverage/TARGET.txt, with a count of 0.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh clang
clang_version=$(clang++ -dumpversion)
scripts/setup.sh "libclang-rt-${clang_version%%.*}-dev" "llvm-${clang_version%%.*}"
cmake --preset clang-fuzzing -B build/clang-fuzz-coverage \
  -DCMAKE_CXX_FLAGS="-fprofile-instr-generate -fcoverage-mapping"
cmake --build build/clang-fuzz-coverage --parallel "$(scripts/number_of_jobs.sh 3900)" \
  --target fuzz_mesh_readers fuzz_curve_readers fuzz_meshes
out=build/fuzz/coverage
mkdir -p "$out"

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
  "llvm-profdata-${clang_version%%.*}" merge -sparse "$out/$target.profraw" -o "$out/$target.profdata"
  code=(tools/constrictions/input)
  [ "$target" = mesh_readers ] ||
    code+=(include/CGAL/Surface_mesh_constrictions/internal/exact include/CGAL/Surface_mesh_constrictions/internal/verify)
  for part in "${code[@]}"; do
    # shellcheck disable=SC2046 # names without blanks
    "llvm-cov-${clang_version%%.*}" report "$program" "-instr-profile=$out/$target.profdata" \
      $(find "$PWD/$part" -name '*.cpp' -o -name '*.h') | sed "s/^/$target: /"
  done
  "llvm-cov-${clang_version%%.*}" show "$program" "-instr-profile=$out/$target.profdata" > "$out/$target.txt" \
    "$PWD/tools/constrictions/input" "$PWD/include/CGAL/Surface_mesh_constrictions/internal/exact"
done
