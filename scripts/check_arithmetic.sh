#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks whether proofs hold on machines and with compilers that compute differently. Prints a row for each
# configuration: how many of the tests of certificates pass, and how many of the ten meshes have the curves of the
# table. Where products are contracted with sums (FMA) these curves are not expected. Fails if a test fails, or if
# something is certified that must not be.
#
#   scripts/check_arithmetic.sh [STEP...]      all steps, if none is given
#
#   contraction   -march=x86-64-v3, without and with -ffp-contract=fast, with GCC and Clang
#   flushed       a library is loaded that makes the processor take subnormal numbers for zero: nothing is certified
#   valgrind      which ignores the rounding mode: nothing is certified
#   aarch64       the cross compiler of Debian, without and with contraction; qemu-user runs it. The libraries of arm64
#                 are unpacked into build/aarch64; what is installed on this machine stays as it is.
#
# DEBIAN_MIRROR is where packages of arm64 come from; http://deb.debian.org/debian if it is not set.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ $# -gt 0 ] || set -- contraction flushed valgrind aarch64
table=test/combinatorial_curves/combinatorial_curves.txt
status=0

fail() { # WHAT
  echo "$0: $1" >&2
  status=1
}

# The row of a configuration. Needs the program of the tests and the command for the curves, words without blanks; runs
# them with RUNNER, which may be empty.
row() { # NAME MUST_HAVE_THE_CURVES TESTS CURVES RUNNER...
  local name=$1 must=$2 tests=$3 curves passed failed same
  read -r -a curves <<< "$4"
  shift 4
  "$@" "$tests" > build/arithmetic.log 2>&1 || true
  passed=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) test.*/\1/p' build/arithmetic.log)
  failed=$(sed -n 's/^ *\([0-9]*\) FAILED TEST.*/\1/p' build/arithmetic.log)
  "$@" "${curves[@]}" data/meshes "$table" > build/arithmetic_curves.log 2>&1 || true
  same=$(sed -n 's/^\([0-9]* of [0-9]*\) meshes have.*/\1/p' build/arithmetic_curves.log)
  printf '| %-44s | %8s | %8s | %10s |\n' "$name" "${passed:-0}" "${failed:-0}" "${same:-none}"
  if [ -z "$passed" ] || [ -n "$failed" ]; then
    cp build/arithmetic.log "build/arithmetic-${name// /_}.log"
    fail "$name: tests of certificates fail, see build/arithmetic-${name// /_}.log"
  fi
  if [ "$must" = yes ] && [ "${same%% *}" != "${same##* }" ]; then
    fail "$name: $same meshes have the curves of the table"
  fi
}

build() { # FOLDER TARGETS COMPILER FLAGS
  cmake -S . -B "$1" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$3" -DCMAKE_CXX_FLAGS="$4" \
    -DWITH_QUICK_COMPILATION=ON -DWITH_PYTHON=OFF -DWITH_EXAMPLES=OFF -DWITH_HEADER_CHECK=OFF > build/arithmetic.log &&
    cmake --build "$1" --parallel "$(scripts/number_of_jobs.sh 3900)" --target $2 >> build/arithmetic.log 2>&1 ||
    { tail -n 20 build/arithmetic.log >&2 && return 1; }
}

contraction() {
  local compiler flags contract must
  for compiler in g++ clang++; do
    for contract in off fast; do
      flags="-march=x86-64-v3 -ffp-contract=$contract"
      must=$([ "$contract" = off ] && echo yes || echo no)
      build "build/arithmetic-$compiler-$contract" "test_certificates mesh_programs" "$compiler" "$flags"
      row "$compiler $flags" "$must" \
        "build/arithmetic-$compiler-$contract/test/Surface_mesh_constrictions/test_certificates" \
        "build/arithmetic-$compiler-$contract/mesh_programs combinatorial_curves" env
    done
  done
}

# The program must say of each curve why it is not certified.
expect_refused() { # NAME REASON RUNNER...
  local name=$1 reason=$2 curves refused
  shift 2
  "$@" build/arithmetic-program/tools/constrictions/constrictions detect data/meshes/cactus.off --all --quiet --threads 2 \
    --json build/arithmetic.json > build/arithmetic.log 2>&1 || true
  curves=$(grep -o '"certificate": *"' build/arithmetic.json | wc -l)
  refused=$(grep -o "\"certificate\": *\"not_certified: floating-point operations $reason" build/arithmetic.json | wc -l)
  printf '| %-44s | %8s | %8s | %10s |\n' "$name" "$((curves - refused))" "$refused" "refused"
  if [ "$curves" -eq 0 ] || [ "$refused" -ne "$curves" ]; then
    fail "$name: $refused of $curves curves are refused"
  fi
}

flushed() {
  build build/arithmetic-program constrictions g++ ""
  echo 'int unused;' > build/flushes.c
  g++ -x c -Ofast -shared -fPIC build/flushes.c -o build/libflushes.so
  expect_refused "program with a library of -Ofast" "take subnormal numbers for zero" \
    env LD_PRELOAD="$PWD/build/libflushes.so"
}

run_with_valgrind() {
  scripts/setup.sh valgrind
  build build/arithmetic-program constrictions g++ ""
  expect_refused "program under valgrind" "do not round in the direction that is set" valgrind --tool=none --quiet
}

# Unpacks packages of Debian for arm64 into a folder.
fetch_arm64() { # FOLDER PACKAGE...
  local target=$1 work
  shift
  [ ! -e "$target/.complete" ] || return 0
  work=$(mktemp -d)
  chmod 755 "$work" # apt-get downloads as an unprivileged user
  mkdir -p "$work"/{download,lists/partial,cache/archives/partial} "$target"
  if [ "$(id -u)" -eq 0 ] && id _apt > /dev/null 2>&1; then
    chown _apt "$work"/{download,lists/partial,cache/archives/partial}
  fi
  . /etc/os-release
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg arch=arm64]" \
    "${DEBIAN_MIRROR:-http://deb.debian.org/debian} $VERSION_CODENAME main" > "$work/sources.list"
  local options=(--quiet=2 -o Acquire::Retries=3 -o Acquire::Languages=none -o APT::Architectures::=arm64
    -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache")
  apt-get "${options[@]}" update < /dev/null
  (cd "$work/download" && apt-get "${options[@]}" download "${@/%/:arm64}" < /dev/null)
  local package
  for package in "$work"/download/*.deb; do
    dpkg-deb --extract "$package" "$target"
  done
  touch "$target/.complete"
  rm -rf "$work"
}

aarch64() {
  scripts/setup.sh g++-aarch64-linux-gnu qemu-user
  local root=build/aarch64 contract name must header
  fetch_arm64 "$root" libgmp-dev libmpfr-dev libgtest-dev
  # the headers that do not depend on the processor, without those of this one's C library
  mkdir -p "$root/headers"
  for header in CGAL boost eigen3; do
    ln -sfn "/usr/include/$header" "$root/headers/$header"
  done
  for contract in off fast; do
    for name in test_certificates combinatorial_curves; do
      local sources=(test/combinatorial_curves/combinatorial_curves.cpp)
      if [ "$name" = test_certificates ]; then
        sources=(test/Surface_mesh_constrictions/exact/*.cpp)
      fi
      printf '#include "%s"\n' "${sources[@]/#/$PWD/}" > "$root/$name.cpp"
      aarch64-linux-gnu-g++ -std=c++17 -O1 -Wno-psabi -DNDEBUG -frounding-math "-ffp-contract=$contract" -static \
        -DCONSTRICTIONS_MESH_DIR="\"$PWD/data/meshes\"" -Iinclude -Itest/Surface_mesh_constrictions \
        -isystem "$root/headers" -isystem "$root/headers/eigen3" -isystem "$root/usr/include" \
        -isystem "$root/usr/include/aarch64-linux-gnu" "$root/$name.cpp" -o "$root/$name-$contract" \
        -L"$root/usr/lib/aarch64-linux-gnu" $([ "$name" != test_certificates ] || echo "-lgtest_main -lgtest") \
        -lmpfr -lgmp -pthread
    done
    must=$([ "$contract" = off ] && echo yes || echo no)
    row "aarch64-linux-gnu-g++ -ffp-contract=$contract" "$must" "$root/test_certificates-$contract" \
      "$root/combinatorial_curves-$contract" qemu-aarch64
  done
}

mkdir -p build
scripts/setup.sh
if [[ " $* " == *" contraction "* ]]; then
  scripts/setup.sh clang
fi
scripts/fetch_meshes.sh data/meshes
printf '| %-44s | %8s | %8s | %10s |\n' configuration passed failed "same curves"
for step in "$@"; do
  case $step in
    contraction | flushed | aarch64) "$step" || fail "$step could not be run" ;;
    valgrind) run_with_valgrind || fail "$step could not be run" ;;
    *) fail "there is no step $step" ;;
  esac
done
exit "$status"
