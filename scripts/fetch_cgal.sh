#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Unpacks the CGAL of a Debian release into a folder, beside the installed one. Does nothing if it is there.
# Prints the folder to give as CGAL_DIR on the last line.
#
#   scripts/fetch_cgal.sh RELEASE DIR       bookworm: CGAL 5.5; trixie: CGAL 6.0
#
# DEBIAN_MIRROR is where the package comes from; http://deb.debian.org/debian if it is not set.
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: $0 RELEASE DIR" >&2
  exit 2
fi
release=$1
mkdir -p "$2"
target=$(cd "$2" && pwd)
complete="$target/.complete"

print_config_dir() {
  local config
  config=$(find "$target/usr/lib" -path '*/cmake/CGAL/CGALConfig.cmake' -print -quit)
  if [ -z "$config" ]; then
    echo "$0: there is no CGALConfig.cmake below $target/usr/lib" >&2
    exit 1
  fi
  dirname "$config"
}

if [ -e "$complete" ]; then
  print_config_dir
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work" # apt-get downloads as an unprivileged user
mkdir -p "$work"/{download,lists/partial,cache/archives/partial}
if [ "$(id -u)" -eq 0 ] && id _apt > /dev/null 2>&1; then
  chown _apt "$work"/{download,lists/partial,cache/archives/partial}
fi

# The release's own package lists, in a place of their own: what is installed on this machine does not change, and the
# signature and the checksums are apt's to verify, whatever the release's current version is.
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
  "${DEBIAN_MIRROR:-http://deb.debian.org/debian} $release main" > "$work/sources.list"
apt_get() {
  apt-get --quiet=2 -o Acquire::Retries=3 -o Acquire::Languages=none \
    -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::Etc::preferences=/dev/null -o Dir::Etc::preferencesparts=/dev/null \
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" \
    "$@" < /dev/null
}

echo "Fetching the CGAL of Debian's $release: 5 MB"
apt_get update
(cd "$work/download" && apt_get download libcgal-dev)
rm -rf "${target:?}/usr"
dpkg-deb --extract "$work"/download/libcgal-dev_*.deb "$target"
touch "$complete"
print_config_dir
