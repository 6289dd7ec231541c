# SPDX-License-Identifier: GPL-3.0-or-later

# Makes one program of several that share most of what takes long to compile. Its first argument is the name of one of
# their sources, without the ending; the other arguments are those of the program that this source makes.
#
# Each source becomes a namespace, and its main() a function there. The headers of all sources are included before, so
# that their guards leave nothing of them in the namespaces.
function(constrictions_programs_in_one target)
  set(headers)
  set(folders)
  set(namespaces)
  set(calls)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    cmake_path(GET source PARENT_PATH folder)
    file(STRINGS "${source}" includes REGEX "^#include ")
    list(APPEND headers ${includes})
    list(APPEND folders "${folder}")
    string(APPEND namespaces "namespace ${name} {\n#include \"${source}\"\n}\n")
    string(APPEND calls "  if(name == \"${name}\")\n    return call(${name}::main, argc - 1, argv + 1);\n")
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(REMOVE_DUPLICATES folders)
  list(JOIN headers "\n" headers)
  file(CONFIGURE OUTPUT ${target}.cpp CONTENT [=[
@headers@

#include <cstdlib>
#include <iostream>
#include <string>

@namespaces@
namespace {

[[maybe_unused]] int call(int (*main)(), int, char**) { return main(); }
[[maybe_unused]] int call(int (*main)(int, char**), int argc, char** argv) { return main(argc, argv); }

} // namespace

int main(int argc, char** argv)
{
  const std::string name = argc > 1 ? argv[1] : "";
@calls@  std::cerr << "there is no program " << name << std::endl;
  return EXIT_FAILURE;
}
]=] @ONLY)
  add_executable(${target} "${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp")
  target_include_directories(${target} PRIVATE ${folders})
  target_link_libraries(${target} PRIVATE CGAL::Surface_mesh_constrictions constrictions_warnings)
endfunction()

# Adds the program of NAME.cpp, which runs on whole meshes and may include headers of the tests. Sets NAME_command to
# the command that calls it. With WITH_QUICK_COMPILATION all programs that are added become one, which
# constrictions_finish_mesh_programs() makes.
function(constrictions_mesh_program name)
  if(WITH_QUICK_COMPILATION)
    set_property(GLOBAL APPEND PROPERTY CONSTRICTIONS_MESH_PROGRAMS "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp")
    set(${name}_command mesh_programs ${name} PARENT_SCOPE)
  else()
    add_executable(${name} ${name}.cpp)
    target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/test/Surface_mesh_constrictions")
    target_link_libraries(${name} PRIVATE CGAL::Surface_mesh_constrictions constrictions_warnings)
    set(${name}_command ${name} PARENT_SCOPE)
  endif()
endfunction()

function(constrictions_finish_mesh_programs)
  get_property(sources GLOBAL PROPERTY CONSTRICTIONS_MESH_PROGRAMS)
  if(sources)
    constrictions_programs_in_one(mesh_programs ${sources})
    target_include_directories(mesh_programs PRIVATE "${PROJECT_SOURCE_DIR}/test/Surface_mesh_constrictions")
    target_link_libraries(mesh_programs PRIVATE constrictions_long_runs)
  endif()
endfunction()
