# SPDX-License-Identifier: GPL-3.0-or-later
# What scripts begin with that compile with two versions of CGAL: packages.sh, and
#
#   compile_with_cgal6 SOURCE LIBRARY ... as compile, with CGAL 6.0.1 of Debian 13, of which it unpacks the headers
. "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

compile_with_cgal6() {
  curl --fail --silent --show-error --location --output "$work/cgal6.deb" \
    "${DEBIAN_MIRROR:-http://deb.debian.org/debian}/pool/main/c/cgal/libcgal-dev_6.0.1-1_amd64.deb"
  dpkg-deb --extract "$work/cgal6.deb" "$work/cgal6"
  CPLUS_INCLUDE_PATH="$work/cgal6/usr/include:$CPLUS_INCLUDE_PATH" compile "$@"
}
