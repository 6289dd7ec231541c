#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs, from Debian's packages (Debian 12 and 13), what building the program needs and, but for --program, what the
# tests need. Where the packages for the viewer, or for the engines that run many meshes, cannot be had, the program is
# built, or tested, without them.
#
#   scripts/setup.sh --program         what the program needs
#   scripts/setup.sh [PACKAGE...]      what the tests need, too, and these packages
set -euo pipefail

packages=(
  build-essential
  ca-certificates
  cmake
  libcgal-dev
  libcli11-dev
  libgmp-dev
  libmpfr-dev
  libtbb-dev
  nlohmann-json3-dev
  zlib1g-dev
)
optional=()
# Programs, which may come from elsewhere. Debian's npm needs Debian's nodejs.
command -v npm > /dev/null || optional+=(nodejs npm)

if [ "${1:-}" != --program ]; then
  packages+=(
    doxygen
    libbenchmark-dev
    libeigen3-dev
    libgtest-dev
    libopenmesh-dev
    python3
    "$@"
  )
  optional+=(munge parallel slurm-wlm)
  command -v chromium > /dev/null || optional+=(chromium)
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

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
apt_get() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" \
    < /dev/null
}

echo "Installing: ${missing[*]} ${missing_optional[*]}"
apt_get update --quiet=2
if [ ${#missing[@]} -gt 0 ]; then
  apt_get install --quiet=2 --yes --no-install-recommends "${missing[@]}"
fi
if [ ${#missing_optional[@]} -gt 0 ]; then
  apt_get install --quiet=2 --yes --no-install-recommends "${missing_optional[@]}" ||
    echo "Not installed: ${missing_optional[*]}. What needs them is left out, or not tested." >&2
fi
