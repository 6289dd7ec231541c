# SPDX-License-Identifier: GPL-3.0-or-later
include(CMakePackageConfigHelpers)

# Nothing of it depends on the machine, so it is not among the libraries.
set(package_dir "${CMAKE_INSTALL_DATADIR}/cmake/Surface_mesh_constrictions")
set(component COMPONENT constrictions_development)

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_constrictionsConfig.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfig.cmake"
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)

configure_file(
  "${CMAKE_CURRENT_LIST_DIR}/surface-mesh-constrictions.pc.in"
  "${CMAKE_CURRENT_BINARY_DIR}/surface-mesh-constrictions.pc"
  @ONLY)

install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" ${component})
install(TARGETS Surface_mesh_constrictions EXPORT Surface_mesh_constrictionsTargets ${component})
install(EXPORT Surface_mesh_constrictionsTargets NAMESPACE CGAL:: DESTINATION "${package_dir}" ${component})
install(
  FILES
    "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfig.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/constrictions_dependencies.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfigVersion.cmake"
  DESTINATION "${package_dir}" ${component})
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/surface-mesh-constrictions.pc"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/pkgconfig" ${component})
install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/examples/Surface_mesh_constrictions/"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/libsurface-mesh-constrictions-dev/examples" ${component})
