# SPDX-License-Identifier: GPL-3.0-or-later

# cpack calls this when files are installed into a folder for each package, before it packs these. Some places below
# /usr, which belong to Debian's packages, are not those below another prefix, where CMake installs.
file(GLOB packages "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr")
foreach(usr IN LISTS packages)
  file(GLOB of_version "${usr}/lib/python3.*/*-packages")
  if(of_version)
    file(MAKE_DIRECTORY "${usr}/lib/python3")
    file(RENAME "${of_version}" "${usr}/lib/python3/dist-packages")
    cmake_path(GET of_version PARENT_PATH of_version)
    file(REMOVE_RECURSE "${of_version}")
  endif()
  if(EXISTS "${usr}/share/zsh/site-functions")
    file(RENAME "${usr}/share/zsh/site-functions" "${usr}/share/zsh/vendor-completions")
  endif()
  file(GLOB pages "${usr}/share/man/man*/*.[0-9]")
  foreach(page IN LISTS pages)
    execute_process(COMMAND gzip --best --no-name "${page}" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endforeach()
