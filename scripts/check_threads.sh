#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests of concurrency with the ThreadSanitizer of GCC and of Clang, or of the compilers that are given.
# test/thread_sanitizer takes the place of oneTBB, as ThreadSanitizer cannot look into oneTBB. Fails if there is a race.
#
#   scripts/check_threads.sh [COMPILER...]
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh
if [ $# -eq 0 ]; then
  scripts/setup.sh clang
  clang_version=$(clang++ -dumpversion)
  scripts/setup.sh "libclang-rt-${clang_version%%.*}-dev"
  set -- g++ clang++
fi
scripts/fetch_meshes.sh data/meshes
mkdir -p build/threads

status=0
for compiler in "$@"; do
  program=build/threads/test_concurrency_$compiler
  printf '#include "%s"\n' "$PWD"/test/Surface_mesh_constrictions/{detect/test_concurrency,exact/test_floating_point}.cpp \
    > build/threads/tests.cpp
  "$compiler" -std=c++17 -O1 -g1 -fsanitize=thread -frounding-math -DNDEBUG -DCGAL_LINKED_WITH_TBB \
    -DCONSTRICTIONS_MESH_DIR="\"$PWD/data/meshes\"" -Itest/thread_sanitizer -Iinclude \
    -Itest/Surface_mesh_constrictions build/threads/tests.cpp -o "$program" -lgtest_main -lgtest -lmpfr -lgmp -pthread
  TSAN_OPTIONS="halt_on_error=0 exitcode=66" "$program" > "$program.log" 2>&1 || status=1
  echo "$compiler: $(grep -c 'WARNING: ThreadSanitizer' "$program.log" || true) warnings;" \
    "$(grep -E '^\[  (PASSED|FAILED)  \]' "$program.log" | head -n 1)"
done
exit "$status"
