# SPDX-License-Identifier: GPL-3.0-or-later

# For the project's own programs only; users of the headers choose their own warnings.
add_library(constrictions_warnings INTERFACE)
target_compile_options(constrictions_warnings INTERFACE -Wall -Wextra -Wpedantic -Werror)

# An update of another library may deprecate what is called here, which must not stop a build.
target_compile_options(constrictions_warnings INTERFACE -Wno-error=deprecated-declarations)

# False alarms of GCC: inside Boost's and Eigen's headers, once they are inlined; and for get(map, source(h, tm)).
target_compile_options(constrictions_warnings INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-dangling-reference>")
