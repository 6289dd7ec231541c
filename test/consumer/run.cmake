# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -DBUILD_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... [-DBUILD_TYPE=...] [-DCMAKE_...=...] -P run.cmake
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/prefix" --config "${BUILD_TYPE}")
# Without Eigen, which users need not have, and without optimisation, which takes longer to compile.
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}/build"
  -G "${CMAKE_GENERATOR}"
  -DCMAKE_BUILD_TYPE=Debug
  "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
  "-DCGAL_DIR=${CGAL_DIR}"
  "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON"
  "-DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON"
  "-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config Debug --target run_consumer)
