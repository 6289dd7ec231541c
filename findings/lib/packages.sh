# SPDX-License-Identifier: GPL-3.0-or-later
# What every script of findings/ begins with: a temporary folder "$work" that goes when the script ends, and functions
# that put public packages of a stated version there. Nothing is installed on the machine.
#
#   debian PACKAGE=VERSION ...    unpacks packages of Debian 12 into $work/root, with what they need and this machine
#                                 lacks; the machine runs Debian 12, so that its libraries fit
#   debian_13 PACKAGE=VERSION ... unpacks packages of Debian 13 that are written in Python into $work/root_13, and nothing
#                                 that they need: list that for debian
#   npm_packages NAME@VERSION ... installs packages of the npm registry into $work/node_modules
#   compile SOURCE LIBRARY ...    compiles $work/SOURCE.cpp to $work/SOURCE with the unpacked headers
#   verdict SEEN STATED           ends the script, with exit code 0 if both are equal
#
# meshes.py beside this file makes the meshes. With FINDINGS_CACHE=DIR the unpacked packages stay in DIR, and scripts
# that need the same ones share them.

set -euo pipefail
export LC_ALL=C.UTF-8
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
triplet=$(gcc -print-multiarch 2> /dev/null || echo x86_64-linux-gnu)
export PATH="$work/root/usr/bin:/usr/bin:$PATH" # the Python of Debian, for its modules
export LD_LIBRARY_PATH="$work/root/usr/lib/$triplet:$work/root/lib/$triplet"
export LIBRARY_PATH="$LD_LIBRARY_PATH"
export CPLUS_INCLUDE_PATH="$work/root/usr/include:$work/root/usr/include/eigen3"
export PYTHONPATH="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd):$work/root/usr/lib/python3/dist-packages"
export PYTHONDONTWRITEBYTECODE=1

# Makes $work/NAME, or takes it from the cache: kept NAME COMMAND ARGUMENT ...
kept() {
  local name=$1
  shift
  if [ -z "${FINDINGS_CACHE:-}" ]; then
    "$@"
    return
  fi
  local place
  place="$(realpath -m "$FINDINGS_CACHE")/$(echo "$@" | sha1sum | cut -c 1-12)/$name"
  if [ ! -e "$place" ]; then
    "$@"
    mkdir -p "${place%/*}"
    mv "$work/$name" "$place"
  fi
  ln -sfn "$place" "$work/$name"
}

debian() {
  kept root unpack_debian "$@"
}

debian_13() {
  kept root_13 unpack_debian_13 "$@"
  PYTHONPATH+=":$work/root_13/usr/lib/python3/dist-packages"
}

use_apt() { # RELEASE
  mkdir -p "$work/$1"/{lists/partial,cache/archives/partial}
  apt=(nice -n 19 apt-get --quiet=2 -o Acquire::Retries=3 -o Acquire::Languages=none -o Debug::NoLocking=1
    -o APT::Sandbox::User= -o Dir::Etc::sourcelist="$work/$1/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o Dir::Etc::preferences=/dev/null -o Dir::Etc::preferencesparts=/dev/null
    -o Dir::State::lists="$work/$1/lists" -o Dir::Cache="$work/$1/cache")
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
    "${DEBIAN_MIRROR:-http://deb.debian.org/debian} $1 main" > "$work/$1/sources.list"
  "${apt[@]}" update
}

unpack_debian() {
  local apt deb
  mkdir -p "$work/root"
  use_apt bookworm
  "${apt[@]}" install --download-only --reinstall --no-install-recommends --allow-downgrades --yes "$@" \
    > "$work/apt.log"
  for deb in "$work"/bookworm/cache/archives/*.deb; do
    dpkg-deb --extract "$deb" "$work/root"
  done
}

unpack_debian_13() {
  local apt deb
  mkdir -p "$work/root_13"
  use_apt trixie
  (cd "$work/trixie/cache" && "${apt[@]}" download "$@")
  for deb in "$work"/trixie/cache/*.deb; do
    dpkg-deb --extract "$deb" "$work/root_13"
  done
}

npm_packages() {
  kept node_modules install_npm "$@"
}

install_npm() {
  (cd "$work" && nice -n 19 npm install --silent --no-audit --no-fund --ignore-scripts --no-save "$@" > npm.log)
}

compile() {
  local source=$1
  shift
  nice -n 19 g++ -std=c++17 -O0 -frounding-math "$work/$source.cpp" -o "$work/$source" "${@/#/-l}"
}

# Ends the script: prints what was seen; exit code 0 if it is what the script states, else 1.
verdict() {
  local seen=$1 stated=$2
  echo "$seen"
  if [ "$seen" = "$stated" ]; then
    echo "as stated"
    exit 0
  fi
  echo "CHANGED; this was stated:"
  echo "$stated"
  exit 1
}
