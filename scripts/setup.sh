#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs, from Debian's packages (Debian 12 and 13), what building the program needs and, but for --program, what the
# tests need. Says first how much is downloaded. What apt-get says is kept in build/setup.log.
#
#   scripts/setup.sh --program         what the program needs
#   scripts/setup.sh [PACKAGE...]      what the tests need, too, and these packages
#   scripts/setup.sh --browser         also npm and Chromium, with which the page of the viewer is tested
#   scripts/setup.sh --engines         also Slurm, with which scripts/batch_array.sh is tested; the packages enable the
#                                      services munge, slurmctld and slurmd of this machine
#
# Without the rights to install packages it prints the command that installs them, and fails if the build or the tests
# need them. The packages for the viewer, the engines and the Python module may be missing: then the program is built,
# or tested, without these parts.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log="$project/build/setup.log"

packages=(
  ca-certificates
  cmake
  g++
  libcgal-dev
  libcli11-dev
  libgmp-dev
  libmpfr-dev
  libtbb-dev
  make
  nlohmann-json3-dev
  zlib1g-dev
)
# for the page of the viewer, and for VTP and 3MF files
optional=(esbuild libexpat1-dev libjs-three libzip-dev)
for_tests=true
for argument in "$@"; do
  case $argument in
    --program) for_tests=false ;;
    # Programs, which may come from elsewhere. Debian's npm needs Debian's nodejs.
    --browser)
      command -v npm > /dev/null || optional+=(nodejs npm)
      command -v chromium > /dev/null || optional+=(chromium)
      ;;
    --engines) optional+=(munge slurm-wlm) ;;
    -*)
      echo "usage: $0 [--program] [--browser] [--engines] [PACKAGE...]" >&2
      exit 2
      ;;
    *) packages+=("$argument") ;;
  esac
done
if "$for_tests"; then
  packages+=(doxygen libbenchmark-dev libeigen3-dev libgtest-dev libmeshoptimizer-dev libopenmesh-dev python3)
  optional+=(parallel python3-jsonschema)
  # for the Python module
  optional+=(pybind11-dev python3-dev python3-meshio python3-numpy python3-pytest)
fi

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2> /dev/null)" = installed ]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
missing_optional=()
for package in "${optional[@]}"; do
  is_installed "$package" || missing_optional+=("$package")
done
if [ ${#missing[@]} -eq 0 ] && [ ${#missing_optional[@]} -eq 0 ]; then
  echo "All packages are installed."
  exit 0
fi

# Fails if something is needed; what is optional is left out.
give_up() { # REASON
  echo "Not installed, $1. As root: apt-get update && apt-get install --no-install-recommends" \
    "${missing[*]} ${missing_optional[*]}" >&2
  [ ${#missing[@]} -eq 0 ] || exit 1
  exit 0
}

# Nothing but apt-get is asked for. A user may be allowed to run it, but not to choose its environment.
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || give_up "as there is no sudo"
  sudo apt-get --version > /dev/null || give_up "as sudo does not allow apt-get"
  as_root=(sudo)
  if sudo DEBIAN_FRONTEND=noninteractive apt-get --version > /dev/null 2>&1; then
    as_root=(sudo DEBIAN_FRONTEND=noninteractive)
  fi
fi
export DEBIAN_FRONTEND=noninteractive
apt_get() {
  "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 --quiet "$@" \
    < /dev/null >> "$log" 2>&1
}

# What apt-get would download and use, in its words; it asks before it installs, and is told no.
sizes() {
  LC_ALL=C apt-get install --assume-no --no-install-recommends -o Debug::NoLocking=1 "$@" 2>&1 < /dev/null |
    sed --quiet --regexp-extended \
      -e 's/^Need to get ([^ ]+ [kMG]?B)(\/([^ ]+ [kMG]?B))? of archives.*/\1 to download/p' \
      -e 's/^After this operation, ([^ ]+ [kMG]?B) of additional disk space.*/\1 on disk/p' |
    paste --serial --delimiters=, | sed 's/,/, /'
}

install() { # PACKAGE...
  echo "Installing $*: $(sizes "$@")"
  apt_get install --yes --no-install-recommends "$@"
}

errors() {
  grep '^E: ' "$log" | tail -n 3 >&2 || true
}

mkdir -p "$project/build"
: > "$log"
# A source that does not answer, or is not signed, need not be the one that has the packages.
apt_get update || echo "apt-get update could not read all sources; going on with those that it has read." >&2
grep '^[WE]: ' "$log" | head -n 3 >&2 || true
if [ ${#missing[@]} -gt 0 ] && ! install "${missing[@]}"; then
  errors
  echo "What apt-get said is in $log." >&2
  exit 1
fi
if [ ${#missing_optional[@]} -gt 0 ] && ! install "${missing_optional[@]}"; then
  errors
  echo "Not installed: ${missing_optional[*]}. What needs them is left out, or not tested." >&2
fi
