#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what the build, the tests and the demonstration need, from Debian's packages (Debian 12 and 13). Where the
# packages for the viewer cannot be had the program is built, or tested, without it.
#
#   scripts/setup.sh [PACKAGE...]      and these packages besides
set -euo pipefail

packages=(
  build-essential
  ca-certificates
  cmake
  doxygen
  libbenchmark-dev
  libcgal-dev
  libcli11-dev
  libeigen3-dev
  libgmp-dev
  libgtest-dev
  libmpfr-dev
  libopenmesh-dev
  libtbb-dev
  munge
  nlohmann-json3-dev
  parallel
  python3
  python3-numpy
  python3-scipy
  slurm-wlm
  "$@"
)

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2> /dev/null)" = installed ]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done

# Programs, which may come from elsewhere. Debian's npm needs Debian's nodejs.
missing_for_viewer=()
command -v npm > /dev/null || missing_for_viewer+=(nodejs npm)
command -v chromium > /dev/null || missing_for_viewer+=(chromium)

if [ ${#missing[@]} -eq 0 ] && [ ${#missing_for_viewer[@]} -eq 0 ]; then
  echo "All packages are installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
apt_get() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" \
    < /dev/null
}

echo "Installing: ${missing[*]} ${missing_for_viewer[*]}"
apt_get update --quiet=2
if [ ${#missing[@]} -gt 0 ]; then
  apt_get install --quiet=2 --yes --no-install-recommends "${missing[@]}"
fi
if [ ${#missing_for_viewer[@]} -gt 0 ]; then
  apt_get install --quiet=2 --yes --no-install-recommends "${missing_for_viewer[@]}" ||
    echo "Not installed: ${missing_for_viewer[*]}. The viewer is left out, or not tested." >&2
fi
