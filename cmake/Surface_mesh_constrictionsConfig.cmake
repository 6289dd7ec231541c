# SPDX-License-Identifier: GPL-3.0-or-later

# The exported target refers to CGAL's, so those come first.
include("${CMAKE_CURRENT_LIST_DIR}/constrictions_dependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_constrictionsTargets.cmake")
