# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -DVERSION=... -DPROJECT_DIR=... -DBUILD_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... [-DBUILD_TYPE=...]
#   [-DCMAKE_...=...] -P run.cmake
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

file(STRINGS "${PROJECT_DIR}/CITATION.cff" cited REGEX "^version: ")
if(NOT cited STREQUAL "version: ${VERSION}")
  message(FATAL_ERROR "The version is ${VERSION}, but in CITATION.cff there is: ${cited}")
endif()

file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/prefix" --config "${BUILD_TYPE}")
if(EXISTS "${WORK_DIR}/prefix/bin/constrictions")
  foreach(file constrictions/constrictions-1.schema.json man/man1/constrictions.1
               bash-completion/completions/constrictions)
    if(NOT EXISTS "${WORK_DIR}/prefix/share/${file}")
      message(FATAL_ERROR "The program is installed without share/${file}")
    endif()
  endforeach()
endif()
if(NOT EXISTS "${WORK_DIR}/prefix/share/pkgconfig/surface-mesh-constrictions.pc")
  message(FATAL_ERROR "The headers are installed without their file for pkg-config")
endif()
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

# A component that there is not is an error, which says so.
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}/component" -G "${CMAKE_GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DCGAL_DIR=${CGAL_DIR}"
    "-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix"
    -DCOMPONENTS=nonsense
  RESULT_VARIABLE result
  OUTPUT_QUIET
  ERROR_VARIABLE error)
string(REGEX REPLACE "[ \n]+" " " error "${error}")
if(result EQUAL 0 OR NOT error MATCHES "It has no components, but is asked for nonsense")
  message(FATAL_ERROR "The component nonsense was found, or not refused: ${error}")
endif()

# The parent of a subproject installs it if it asks for that.
foreach(installs OFF ON)
  set(prefix "${WORK_DIR}/subproject_prefix_${installs}")
  set(option)
  if(installs)
    set(option -DCONSTRICTIONS_INSTALL=ON)
  endif()
  run("${CMAKE_COMMAND}" -S "${PROJECT_DIR}/test/consumer/subproject" -B "${WORK_DIR}/subproject_${installs}"
    -G "${CMAKE_GENERATOR}"
    -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DCGAL_DIR=${CGAL_DIR}"
    ${option})
  run("${CMAKE_COMMAND}" --install "${WORK_DIR}/subproject_${installs}" --prefix "${prefix}" --config Release)
  file(GLOB_RECURSE files RELATIVE "${prefix}" "${prefix}/*")
  list(FILTER files INCLUDE REGEX "Surface_mesh_constrictions")
  if(installs AND NOT files MATCHES "Surface_mesh_constrictionsConfig.cmake")
    message(FATAL_ERROR "The subproject is not installed, though it is asked for")
  elseif(NOT installs AND files)
    message(FATAL_ERROR "The subproject is installed with its parent: ${files}")
  endif()
endforeach()
