# SPDX-License-Identifier: GPL-3.0-or-later

# What users of the headers need: CGAL::CGAL and CGAL::Eigen3_support. Part of the build and of the installed package.
include(CMakeFindDependencyMacro)
find_dependency(CGAL 5.5)
find_dependency(Eigen3 3.3 NO_MODULE)
include(CGAL_Eigen3_support)
