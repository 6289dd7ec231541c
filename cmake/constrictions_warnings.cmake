# SPDX-License-Identifier: GPL-3.0-or-later

# For the project's own programs only; users of the headers choose their own warnings.
add_library(constrictions_warnings INTERFACE)
target_compile_options(constrictions_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Werror
  # GCC gives it inside Boost's and Eigen's headers too, once they are inlined.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
