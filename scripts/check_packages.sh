#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages in a Debian of this release, checks them with lintian, installs them in another Debian, in
# which only what debootstrap calls minbase is installed, and uses them there: the program, its man page and
# completions, the Python module on a mesh of CGAL, and the headers by CMake and by pkg-config. Prints how long it takes
# from nothing to the first curves. Needs root.
#
#   scripts/check_packages.sh 12|13 [FOLDER]
#
# With a folder the packages in it are used, and none are built. It takes half an hour, and 3 GB in build/bare_debian,
# where the packages and the logs are too. See scripts/bare_debian.sh for where Debian's packages come from.
set -euo pipefail

# shellcheck source=scripts/bare_debian.sh
. "$(dirname "${BASH_SOURCE[0]}")/bare_debian.sh"
case ${1:-} in
  12 | 13) release=$1 ;;
  *)
    sed --quiet 's/^#   scripts/usage: scripts/p' "$0" >&2
    exit 2
    ;;
esac
use_debian "$release"
mesh="$project/data/meshes/cactus.off"
if [ ! -e "$mesh" ]; then
  "$project/scripts/fetch_meshes.sh" "$project/data/meshes"
fi

step() { # NAME COMMAND...
  local seconds=$SECONDS code=0
  "${@:2}" > "$folder/packages-$1.log" 2>&1 || code=$?
  printf 'Debian %s, %s: exit code %s, %s s\n' "$release" "$1" "$code" $((SECONDS - seconds))
  if [ "$code" -ne 0 ]; then
    tail -n 20 "$folder/packages-$1.log" >&2
    exit 1
  fi
}

install="DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends"

if [ $# -lt 2 ]; then
  new_root packages-build
  copy_project /root/project
  tools=(dpkg-dev file gzip lintian man-db pybind11-dev python3-dev python3-numpy)
  step prepare inside root "apt-get update && $install ${tools[*]} && cd project && scripts/setup.sh --program"
  step configure inside root "cmake -S project -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
    -DWITH_TESTS=OFF -DWITH_EXAMPLES=OFF"
  step build inside root "cmake --build build --parallel \$(project/scripts/number_of_jobs.sh 3900)"
  step pack inside root "cd build && cpack -G DEB"
  step lintian inside root "lintian --fail-on error --allow-root build/*.deb"
  cat "$folder/packages-lintian.log"
  mkdir -p "$folder/packages"
  rm -f "$folder"/packages/*.deb
  cp "$root"/root/build/*.deb "$folder/packages"
  packages="$folder/packages"
else
  packages=$2
fi
for package in "$packages"/*.deb; do
  # shellcheck disable=SC2016
  dpkg-deb --show --showformat '${Package} ${Version} ${Architecture}: ${Depends}\n' "$package"
done

new_root packages-use
cp "$packages"/*.deb "$root/root"
cp "$mesh" "$root/root/cactus.off"
cp --recursive "$project/test/consumer/project" "$root/root/consumer"
begin=$SECONDS
step install inside root "apt-get update && $install ./constrictions_*.deb ./python3-constrictions_*.deb"
step python inside root "python3 -c \"
import numpy as np, constrictions
lines = [l.split() for l in open('cactus.off') if l.strip() and l[0] != '#']
n, m = map(int, lines[1][:2])
V = np.array([l[:3] for l in lines[2:2 + n]], dtype=float)
F = np.array([l[1:4] for l in lines[2 + n:2 + n + m]], dtype=np.int32)
curves = constrictions.Surface(V, F).detect()
print(curves)
assert np.allclose(sorted(c.length for c in curves), [0.283957, 0.291363, 0.599004], atol=1e-6)\""
echo "From a bare Debian to the first curves in Python: $((SECONDS - begin)) s"
step program inside root "constrictions detect cactus.off &&
  sh /usr/share/doc/constrictions/examples/try.sh results && test -s results/dumbbell.html &&
  test -s /usr/share/doc/constrictions/copyright && test -s /usr/share/constrictions/constrictions-1.schema.json"
step completion inside root "source /usr/share/bash-completion/completions/constrictions &&
  COMP_WORDS=(constrictions seg) && COMP_CWORD=1 && _constrictions && test \"\${COMPREPLY[*]}\" = segment"
step man inside root "$install man-db zsh && man --pager=cat constrictions | grep -q -e '--max-length' &&
  whatis constrictions | grep -q 'closed curves' && zsh -n /usr/share/zsh/vendor-completions/_constrictions"
step headers inside root "$install ./libsurface-mesh-constrictions-dev_*.deb cmake g++ make pkg-config &&
  cmake -S consumer -B consumer/build && cmake --build consumer/build --target run_consumer &&
  g++ -O1 consumer/consumer.cpp -o by_pkg_config \$(pkg-config --cflags --libs surface-mesh-constrictions) &&
  ./by_pkg_config"
step remove inside root "apt-get purge --yes constrictions python3-constrictions libsurface-mesh-constrictions-dev &&
  ! find /usr -path '*onstrictions*' | grep ."
echo "Debian $release: the packages are built, installed, used and removed."
