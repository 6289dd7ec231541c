# SPDX-License-Identifier: GPL-3.0-or-later

# `cpack -G DEB` in a build makes Debian packages of what was built: the program, the headers, the Python module.
# scripts/check_packages.sh builds, checks, installs and uses them.

# Of each component of the installation a package.
set(CPACK_PACKAGE_NAME constrictions)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "The Surface_mesh_constrictions maintainers <maintainers@constrictions.invalid>"
  CACHE STRING "Who makes the packages: a name and an address")
set(CPACK_COMPONENTS_ALL constrictions_development)
if(TARGET constrictions)
  list(APPEND CPACK_COMPONENTS_ALL constrictions_program)
endif()
if(TARGET constrictions_python)
  list(APPEND CPACK_COMPONENTS_ALL constrictions_python)
endif()
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian/arrange_package.cmake")

# The first line of a description is the title; the others have 80 characters at most.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(about "A constriction of a surface is a simple closed curve on it whose length is
locally minimal: a rubber band that stays where it was put. Constrictions are
closed geodesics. They mark necks, throats, limb joints and handles, and each
is proved with exact arithmetic.
.")

set(CPACK_DEBIAN_CONSTRICTIONS_PROGRAM_PACKAGE_NAME constrictions)
set(CPACK_DEBIAN_CONSTRICTIONS_PROGRAM_PACKAGE_SECTION math)
set(CPACK_DEBIAN_CONSTRICTIONS_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CONSTRICTIONS_PROGRAM_DESCRIPTION "closed curves of locally minimal length on triangle meshes
${about}
This package has the program constrictions, which finds them in files of
meshes, cuts the meshes along them, and writes pages that show them in a
browser.")

set(CPACK_DEBIAN_CONSTRICTIONS_DEVELOPMENT_PACKAGE_NAME libsurface-mesh-constrictions-dev)
set(CPACK_DEBIAN_CONSTRICTIONS_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CONSTRICTIONS_DEVELOPMENT_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_CONSTRICTIONS_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libgmp-dev, libmpfr-dev")
set(CPACK_DEBIAN_CONSTRICTIONS_DEVELOPMENT_PACKAGE_SUGGESTS "libtbb-dev, libeigen3-dev")
set(CPACK_DEBIAN_CONSTRICTIONS_DEVELOPMENT_DESCRIPTION "closed curves of locally minimal length on triangle meshes (headers)
${about}
This package has the headers of Surface_mesh_constrictions, which are used
like those of a package of CGAL, and the files for CMake and pkg-config.")

# The module is for one version of Python: from this one on, and before the next one.
if(TARGET constrictions_python)
  string(REGEX MATCH "^3\\.([0-9]+)" this_python "${CONSTRICTIONS_PYTHON_FOUND}")
  math(EXPR next_python "${CMAKE_MATCH_1} + 1")
  set(CPACK_DEBIAN_CONSTRICTIONS_PYTHON_PACKAGE_NAME python3-constrictions)
  set(CPACK_DEBIAN_CONSTRICTIONS_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_CONSTRICTIONS_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_CONSTRICTIONS_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${this_python}~), python3 (<< 3.${next_python}), python3-numpy")
  set(CPACK_DEBIAN_CONSTRICTIONS_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_LIST_DIR}/debian/python/postinst;${CMAKE_CURRENT_LIST_DIR}/debian/python/prerm")
  set(CPACK_DEBIAN_CONSTRICTIONS_PYTHON_DESCRIPTION "closed curves of locally minimal length on triangle meshes (Python)
${about}
This package has the module constrictions, which takes and returns arrays of
numpy.")
endif()

# What every package has in its folder of documents.
find_program(GZIP_EXECUTABLE gzip)
set(documents "${CMAKE_CURRENT_BINARY_DIR}/debian")
set(CONSTRICTIONS_CHANGELOG_PACKAGE constrictions)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in" "${documents}/changelog.Debian" @ONLY)
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/CHANGES.md" "${documents}/changelog" COPYONLY)
if(GZIP_EXECUTABLE)
  # without the name and the time of the file, so that it is the same each time
  execute_process(
    COMMAND "${GZIP_EXECUTABLE}" --best --no-name --force "${documents}/changelog.Debian" "${documents}/changelog"
    COMMAND_ERROR_IS_FATAL ANY)
  foreach(pair constrictions_program=constrictions
               constrictions_development=libsurface-mesh-constrictions-dev
               constrictions_python=python3-constrictions)
    string(REPLACE "=" ";" pair "${pair}")
    list(GET pair 0 component)
    list(GET pair 1 package)
    if(component IN_LIST CPACK_COMPONENTS_ALL)
      install(
        FILES "${documents}/changelog.Debian.gz" "${documents}/changelog.gz"
          "${CMAKE_CURRENT_LIST_DIR}/debian/copyright"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
        COMPONENT ${component})
    endif()
  endforeach()
endif()

install(FILES "${CMAKE_CURRENT_LIST_DIR}/debian/lintian-overrides"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides"
  RENAME libsurface-mesh-constrictions-dev
  COMPONENT constrictions_development)

include(CPack)
