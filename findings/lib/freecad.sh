# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts on FreeCAD begin with: packages.sh, and FreeCAD 0.20.2 where Python finds its modules FreeCAD and
# Mesh.
. "$(dirname "${BASH_SOURCE[0]}")/packages.sh"
debian freecad-python3=0.20.2+dfsg1-4
export LD_LIBRARY_PATH="$LD_LIBRARY_PATH:$work/root/usr/lib:$work/root/usr/lib/freecad-python3/lib"
export PYTHONPATH="$PYTHONPATH:$work/root/usr/lib/freecad-python3/lib:$work/root/usr/lib/freecad/lib"
export PYTHONPATH="$PYTHONPATH:$work/root/usr/lib/freecad/Mod/Mesh"
export HOME="$work" XDG_RUNTIME_DIR="$work"
