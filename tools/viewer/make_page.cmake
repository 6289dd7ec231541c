# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -DESBUILD=... -DTHREE_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... -DPAGE=... -P make_page.cmake
#
# Bundles the page of the viewer, and writes it as a C++ file that defines page_template().
cmake_minimum_required(VERSION 3.22)

foreach(entry main.js style.css)
  execute_process(
    COMMAND "${ESBUILD}" "${SOURCE_DIR}/${entry}" "--outfile=${WORK_DIR}/${entry}"
      --bundle
      --minify
      --format=iife
      --target=chrome100,firefox100,safari15
      --legal-comments=inline
      --log-level=warning
      "--alias:three=${THREE_DIR}"
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()

file(READ "${WORK_DIR}/main.js" script)
file(READ "${WORK_DIR}/style.css" style)
file(READ "${SOURCE_DIR}/page.html" page)
string(FIND "${script}" "</script>" end)
if(NOT end EQUAL -1)
  message(FATAL_ERROR "The script of the page ends itself")
endif()
string(REPLACE "/* style */" "${style}" page "${page}")
string(REPLACE "/* script */" "${script}" page "${page}")
file(WRITE "${WORK_DIR}/page.html" "${page}")

# As numbers, since compilers need not take literals of this length.
file(READ "${WORK_DIR}/page.html" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1, " bytes "${bytes}")
file(WRITE "${PAGE}" "// Made by make_page.cmake.
#include \"page_template.h\"

namespace constrictions {

namespace {

const unsigned char bytes[] = {
${bytes}};

} // namespace

const std::string& page_template()
{
  static const std::string page(bytes, bytes + sizeof bytes);
  return page;
}

} // namespace constrictions
")
