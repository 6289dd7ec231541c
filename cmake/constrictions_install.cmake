# SPDX-License-Identifier: GPL-3.0-or-later
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Surface_mesh_constrictions")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_constrictionsConfig.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfig.cmake"
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)

install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(TARGETS Surface_mesh_constrictions EXPORT Surface_mesh_constrictionsTargets)
install(EXPORT Surface_mesh_constrictionsTargets NAMESPACE CGAL:: DESTINATION "${package_dir}")
install(
  FILES
    "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfig.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/constrictions_dependencies.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_constrictionsConfigVersion.cmake"
  DESTINATION "${package_dir}")
