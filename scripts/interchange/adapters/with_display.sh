#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program that wants a screen in an unpacked Debian, with Xvfb from there. As root, in namespaces of its own:
#
#   unshare --mount --pid --fork with_display.sh ROOT FOLDER PROGRAM ARGUMENT...     FOLDER is /work in there
set -euo pipefail

root=$1 folder=$2
shift 2
mkdir -p "$root"/{dev,proc,work,tmp,root}
rm -rf "$root"/tmp/.X*
mount --rbind /dev "$root/dev"
mount -t proc proc "$root/proc"
mount --bind "$folder" "$root/work"
libraries=/usr/lib/x86_64-linux-gnu
inside() {
  /usr/sbin/chroot "$root" "$@"
}
export DISPLAY=:99 HOME=/tmp XDG_RUNTIME_DIR=/tmp LC_ALL=C.UTF-8 LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
export LD_LIBRARY_PATH="$libraries:$libraries/blas:$libraries/lapack:$libraries/meshlab"
inside /usr/bin/Xvfb "$DISPLAY" -screen 0 640x480x24 > "$root/tmp/xvfb.log" 2>&1 &
for _ in $(seq 100); do
  [ -S "$root/tmp/.X11-unix/X99" ] && break
  sleep 0.2
done
inside "$@"
