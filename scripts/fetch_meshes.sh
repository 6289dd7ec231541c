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

download() {
  mkdir -p download
  if [ "$(id -u)" -eq 0 ] && id _apt > /dev/null 2>&1; then
    chown _apt download
  fi
  (cd download && apt-get -o Acquire::Retries=3 --quiet=2 download libcgal-demo < /dev/null)
}

# Without package lists there is nothing to download from.
update() {
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 --quiet=2 update < /dev/null
}

echo "Fetching CGAL's example meshes"
download || { update && download; }
dpkg-deb --extract download/libcgal-demo_*.deb package

archive=$(find package -name data.tar.gz -print -quit)
if [ -z "$archive" ]; then
  echo "$0: there is no data.tar.gz in $(ls download)" >&2
  exit 1
fi
tar --extract --gzip --no-same-owner --file "$archive" --directory "$target" --strip-components=2 data/meshes
touch "$complete"
