#!/usr/bin/env bash
# Installs what the build, the tests and the demonstration need, from Debian's packages (Debian 12 and 13).
#
#   scripts/setup.sh
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
  nlohmann-json3-dev
  python3
  python3-numpy
  python3-scipy
)

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2> /dev/null)" = installed ]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
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

echo "Installing: ${missing[*]}"
apt_get update --quiet=2
apt_get install --quiet=2 --yes --no-install-recommends "${missing[@]}"
