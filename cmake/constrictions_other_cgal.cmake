# SPDX-License-Identifier: GPL-3.0-or-later

# Where a CGAL is installed beside the one that was chosen, compilers look into it for a header that the chosen one does
# not have, and what is built is a mixture. So each such header is shadowed by one that stops the compiler.
#
# CONSTRICTIONS_OTHER_CGAL: the folders of includes with another CGAL; CONSTRICTIONS_SHADOWED_HEADERS: what is shadowed.
set(CONSTRICTIONS_OTHER_CGAL)
set(CONSTRICTIONS_SHADOWED_HEADERS)

set(chosen)
foreach(folder IN LISTS CGAL_INCLUDE_DIRS)
  file(REAL_PATH "${folder}" folder)
  list(APPEND chosen "${folder}")
endforeach()

set(shadows "${CMAKE_CURRENT_BINARY_DIR}/other_cgal")
file(REMOVE_RECURSE "${shadows}")
foreach(folder IN LISTS CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
  file(REAL_PATH "${folder}" real)
  if(real IN_LIST chosen OR NOT EXISTS "${folder}/CGAL/version.h")
    continue()
  endif()
  list(APPEND CONSTRICTIONS_OTHER_CGAL "${folder}")
  file(GLOB_RECURSE headers RELATIVE "${folder}" "${folder}/CGAL/*")
  foreach(own IN LISTS chosen ITEMS "${PROJECT_SOURCE_DIR}/include")
    file(GLOB_RECURSE own_headers RELATIVE "${own}" "${own}/CGAL/*")
    list(REMOVE_ITEM headers ${own_headers})
  endforeach()
  foreach(header IN LISTS headers)
    file(WRITE "${shadows}/${header}"
      "#error \"${folder}/${header} is not of the CGAL that was chosen, which does not have this header\"\n")
  endforeach()
  list(APPEND CONSTRICTIONS_SHADOWED_HEADERS ${headers})
endforeach()

if(CONSTRICTIONS_OTHER_CGAL)
  # As a folder of the system it comes before those that compilers look into by themselves.
  include_directories(SYSTEM AFTER "${shadows}")
endif()
