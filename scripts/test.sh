#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the given configurations and runs their tests together. The last line is ctest's summary, the exit code is
# ctest's.
#
#   scripts/test.sh [PRESET[:curves|:short]...]    presets of CMakePresets.json; release if none is given
#
# Builds and tests everything, except that each header compiles on its own, which scripts/nightly.sh tests. The
# benchmarks are built in the last configuration only. With `:short` the sources of test programs that run for long are
# only checked, and there are no examples. With `:curves` only two things are tested: that the combinatorial curves of
# real meshes are those of every other configuration, and that a project can use the installed package.
#
# If CGAL_DIR is set, that CGAL is used. Else a preset named for CGAL 6 uses Debian's CGAL 6, and the others use the
# installed one.
#
# A compiler takes up to 3.9 GB of memory: no more compilers run at a time than fit into the memory. What needs a
# browser or Slurm is skipped where they are not there; scripts/setup.sh --browser --engines installs them.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
configurations=("$@")
if [ $# -eq 0 ]; then
  configurations=(release)
fi
log="$project/build/ctest.log"

"$project/scripts/setup.sh"
if [[ ${configurations[*]} == *clang* ]]; then
  "$project/scripts/setup.sh" clang
  clang_version=$(clang++ -dumpversion)
  "$project/scripts/setup.sh" "libclang-rt-${clang_version%%.*}-dev"
fi
"$project/scripts/fetch_meshes.sh" "$project/data/meshes"

cd "$project"
mkdir -p build
names=()
for configuration in "${configurations[@]}"; do
  preset=${configuration%:*}
  options=(-DWITH_QUICK_COMPILATION=ON -DWITH_HEADER_CHECK=OFF "-DCONSTRICTIONS_TEST_PREFIX=$preset.")
  case $configuration in
    *:curves) options+=(-DWITH_TOOLS=OFF -DWITH_PYTHON=OFF -DWITH_EXAMPLES=OFF -DWITH_TEST_PROGRAMS=OFF) ;;
    *:short) options+=(-DWITH_EXAMPLES=OFF -DWITH_LONG_TESTS=OFF) ;;
  esac
  if [ "$configuration" = "${configurations[-1]}" ]; then
    options+=(-DWITH_BENCHMARKS=ON)
  fi
  if [ -n "${CGAL_DIR:-}" ]; then
    options+=("-DCGAL_DIR=$CGAL_DIR")
  elif [[ $preset == *cgal6* ]]; then
    scripts/fetch_cgal.sh trixie build/cgal6
  fi
  cmake --preset "$preset" -G "Unix Makefiles" "${options[@]}"
  names+=("$preset")
done

# One make for all of them, so that no processor waits for the last files of each.
{
  printf '.PHONY: all'
  printf ' %s' "${names[@]}"
  printf '\nall:'
  printf ' %s' "${names[@]}"
  printf '\n'
  printf '%s:\n\t+$(MAKE) --no-print-directory -C $@\n' "${names[@]}"
} > build/Makefile
make -C build --jobs "$(scripts/number_of_jobs.sh 3900)"

# One run of ctest over all of them.
printf 'subdirs("%s")\n' "${names[@]}" > build/CTestTestfile.cmake
status=0
ctest --test-dir build --output-on-failure --no-tests=error --parallel "$(nproc)" --output-log "$log" || status=$?
grep -E 'tests passed|No tests were found' "$log" | tail -n 1
exit "$status"
