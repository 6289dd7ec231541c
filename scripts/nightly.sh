#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs what takes hours and rarely finds anything, and so is not part of .ci/run. A step that fails does not stop those
# after it. Prints the result of each step; the exit code is 1 if one has failed. What a step prints is in
# build/nightly/STEP.log.
#
#   scripts/nightly.sh [STEP...]        all steps, if none is given
#
#   coverage                            which lines of include/ no test executes
#   mutation-certificate, mutation-tightening, mutation-verification, mutation-prominence, mutation-selection
#                                       which comparisons can be flipped without a test that notices
#   configurations                      what .ci/run leaves out: the whole suite with the sanitizers of both compilers, and
#                                       the same curves in the debug builds and with Clang
#   arithmetic                          proofs on machines and with compilers that compute differently; prints a table
#   faults                              each allocation and each call that writes fails once
#   fuzz                                an hour of fuzzing against the oracle
#   threads                             the tests of concurrency with ThreadSanitizer
#   headers                             every header compiles on its own
#   examples                            each example compiles on its own, which .ci/run compiles together, and runs
#   meshes                              all of CGAL's meshes but a point cloud are answered, each curve certified; prints
#                                       the tables of the manual
#   selection                           the default call selects what is selected of all, on CGAL's meshes of up to
#                                       60,000 faces, but for two where all constrictions take many minutes; prints the
#                                       table of the manual
#   curves                              the certificates of all curves of large meshes, of which .ci/run looks at those
#                                       that are selected, and girths at 10,000 places
#   completeness                        which strict constrictions of 300 small meshes random walks find and the
#                                       detection misses; prints the table of the manual
#   necks                               which known narrow places of generated bodies the default call finds, and how
#                                       CGAL's segmentation and plane sections do; prints the tables of the manual
#   others                              the meshes that packages of Debian and npm ship are answered or refused for a
#                                       reason, each curve certified; prints the tables of the manual
#   stability                           whether constrictions of twelve meshes are found again on changed ones;
#                                       prints the table of the manual
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ $# -gt 0 ] || set -- headers examples meshes others selection curves completeness stability necks coverage \
  mutation-{certificate,tightening,verification,prominence,selection} configurations arithmetic faults fuzz threads
mkdir -p build/nightly
# scripts/test.sh or another step may have configured the same folder for something else.
whole=(-DWITH_{TOOLS,EXAMPLES,LONG_TESTS,TEST_PROGRAMS}=ON -DWITH_QUICK_COMPILATION=OFF -DCONSTRICTIONS_TEST_PREFIX=)

compare_on_a_thousand_necks() {
  local set=benchmark/Surface_mesh_constrictions/thousand_necks results=build/nightly/necks python=/usr/bin/python3
  mkdir -p "$results"
  $python $set/run.py --json "$results/constrictions.json" --time-limit 3600 \
    --command 'build/release/tools/constrictions/constrictions detect {mesh} --json {out} --quiet' &&
    $python $set/run.py --json "$results/sdf.json" --time-limit 3600 \
      --command 'build/release/benchmark/Surface_mesh_constrictions/sdf_borders {mesh} {out}' &&
    $python $set/run.py --json "$results/sections.json" --time-limit 3600 \
      --command "$python {here}/plane_sections.py {mesh} {out}" &&
    $python $set/run.py --compare "constrictions=$results/constrictions.json" "sdf=$results/sdf.json" \
      "sections=$results/sections.json"
}

run() { # STEP
  case $1 in
    coverage) scripts/coverage.sh ;;
    mutation-*)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes &&
        scripts/mutation/run.py build/mutation --group "${1#mutation-}" --jobs "$(scripts/number_of_jobs.sh 3900)"
      ;;
    configurations)
      scripts/test.sh debug:curves clang-debug:curves cgal6-debug:curves clang-release:curves \
        cgal6-release:curves sanitizers clang-cgal6-sanitizers
      ;;
    arithmetic) scripts/check_arithmetic.sh ;;
    faults)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --parallel "$(scripts/number_of_jobs.sh 3900)" --target test_parts test_tools &&
        CONSTRICTIONS_ALL_FAULTS=1 ctest --preset release -R 'Faults|AllocationFailures' --parallel "$(nproc)" \
          --timeout 20000
      ;;
    fuzz) scripts/fuzz.sh 60 ;;
    threads) scripts/check_threads.sh ;;
    headers)
      scripts/setup.sh && cmake --preset release "${whole[@]}" -DWITH_TOOLS=OFF -DWITH_PYTHON=OFF -DWITH_EXAMPLES=OFF \
        -DWITH_TEST_PROGRAMS=OFF -DWITH_HEADER_CHECK=ON &&
        cmake --build --preset release --parallel "$(scripts/number_of_jobs.sh 2000)" \
          --target public_headers_compile_alone --target internal_headers_compile_alone
      ;;
    examples)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        make -C build/release/examples/Surface_mesh_constrictions -j "$(scripts/number_of_jobs.sh 2200)" &&
        ctest --preset release -R '^example\.'
      ;;
    meshes)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --target constrictions &&
        scripts/check_meshes.py build/release/tools/constrictions/constrictions data/meshes --time-limit 3600 \
          --least 142
      ;;
    others)
      scripts/setup.sh && { command -v npm > /dev/null || scripts/setup.sh nodejs npm; } &&
        cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --target constrictions &&
        scripts/check_meshes_of_others.py build/release/tools/constrictions/constrictions build/nightly/meshes_of_others
      ;;
    necks)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes &&
        cmake --preset release "${whole[@]}" -DWITH_BENCHMARKS=ON &&
        cmake --build --preset release --target constrictions --target sdf_borders &&
        compare_on_a_thousand_necks
      ;;
    selection)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --target selection_of_all &&
        printf '%s\n' data/meshes/*.off | grep -v -e cheese -e ChineseDragon |
        xargs build/release/test/selection_of_all/selection_of_all --most-faces 60000 --wrong 39
      ;;
    curves)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --parallel "$(scripts/number_of_jobs.sh 3900)" \
          --target test_certificates test_detection &&
        CONSTRICTIONS_ALL_CURVES=1 CONSTRICTIONS_ALL_PLACES=1 ctest --preset release \
          -R 'Certificates/|Real_meshes|GirthAtRandomPlaces' --parallel "$(nproc)"
      ;;
    completeness)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --target completeness &&
        build/release/test/completeness/completeness --bodies 32 --walks 390 750 --missed 1150 --separating 5 \
          data/meshes/*.off
      ;;
    stability)
      scripts/setup.sh && scripts/fetch_meshes.sh data/meshes && cmake --preset release "${whole[@]}" &&
        cmake --build --preset release --target stability &&
        build/release/test/stability/stability --lost 45 \
          data/meshes/{anchor,cactus,camel,cow,dino,eight,elephant,homer,knot1,mushroom,pig,spool}.off
      ;;
    *)
      echo "there is no step $1"
      return 2
      ;;
  esac
}

status=0
for step in "$@"; do
  seconds=$SECONDS
  result=passed
  run "$step" > "build/nightly/$step.log" 2>&1 || result=FAILED
  echo "$step: $result after $(((SECONDS - seconds + 30) / 60)) minutes: $(tail -n 1 "build/nightly/$step.log")"
  [ "$result" = passed ] || status=1
done
exit "$status"
