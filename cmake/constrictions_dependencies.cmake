# SPDX-License-Identifier: GPL-3.0-or-later

# What users of the headers need: CGAL::CGAL. Part of the build and of the installed package.
include(CMakeFindDependencyMacro)
find_dependency(CGAL 5.5)
