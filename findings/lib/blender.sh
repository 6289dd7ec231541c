# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts on Blender begin with: packages.sh, and Blender 3.4.1 with the folders that it looks for.
. "$(dirname "${BASH_SOURCE[0]}")/packages.sh"
debian blender=3.4.1+dfsg-2+b1
export BLENDER_SYSTEM_SCRIPTS="$work/root/usr/share/blender/scripts"
export BLENDER_SYSTEM_DATAFILES="$work/root/usr/share/blender/datafiles"
for folder in . "$triplet/blas" "$triplet/lapack" "$triplet/pulseaudio"; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$folder"
done
