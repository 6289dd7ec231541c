#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Puts CGAL's example meshes, from Debian's package libcgal-demo, into a folder. Does nothing if they are there.
#
#   scripts/fetch_meshes.sh DIR
set -euo pipefail

if [ $# -ne 1 ]; then
  echo "usage: $0 DIR" >&2
  exit 2
fi
mkdir -p "$1"
target=$(cd "$1" && pwd)
complete="$target/.complete"
if [ -e "$complete" ]; then
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work" # apt-get downloads as an unprivileged user
cd "$work"

apt_get() {
  apt-get -o Acquire::Retries=3 --quiet=2 "$@" < /dev/null
}

download() { # OPTION...
  mkdir -p download
  if [ "$(id -u)" -eq 0 ] && id _apt > /dev/null 2>&1; then
    chown _apt download
  fi
  (cd download && apt_get "$@" download libcgal-demo)
}

# Package lists of its own, for which nobody needs to be root. A source that does not answer need not be the one that
# has the package.
download_with_own_lists() {
  local places=(-o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" -o Acquire::Languages=none)
  mkdir -p "$work"/{lists/partial,cache/archives/partial}
  if [ "$(id -u)" -eq 0 ] && id _apt > /dev/null 2>&1; then
    chown _apt "$work"/{lists/partial,cache/archives/partial}
  fi
  apt_get "${places[@]}" update || true
  download "${places[@]}"
}

echo "Fetching CGAL's example meshes, Debian's package libcgal-demo: 27 MB"
download 2> /dev/null || download_with_own_lists
dpkg-deb --extract download/libcgal-demo_*.deb package

archive=$(find package -name data.tar.gz -print -quit)
if [ -z "$archive" ]; then
  echo "$0: there is no data.tar.gz in $(ls download)" >&2
  exit 1
fi
tar --extract --gzip --no-same-owner --file "$archive" --directory "$target" --strip-components=2 data/meshes
touch "$complete"
