#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ParaView 5.11.0 (paraview 5.11.0+dfsg-1+b1) with Expat 2.5.0 (libexpat1 2.5.0-1+deb12u2).
#
# Guess: a surface that SaveData() writes as .vtp with its defaults is read back.
# What happens: the default puts raw bytes behind the XML ("appended", not encoded). Reading that file stops at them
# with "not well-formed (invalid token)", and the surface has no points. With DataMode="Binary", in which the bytes are
# in the XML as base64, the same surface comes back. The package of Expat before, 2.5.0-1+deb12u1, reads both, so that
# an update of another package decides.
#
# Why it matters: curves and parts are shown and saved in ParaView. What was saved is there, but cannot be opened where
# it was written.
. "$(dirname "$0")/lib/packages.sh"
debian libexpat1=2.5.0-1+deb12u2 paraview=5.11.0+dfsg-1+b1 python3-paraview=5.11.0+dfsg-1+b1
for folder in . paraview "$triplet/blas" "$triplet/lapack" "$triplet/openmpi/lib"; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$folder"
done

cd "$work"
cat > saved.py << 'END'
from paraview import simple

print("> ParaView", simple.GetParaViewVersion())
sphere = simple.Sphere()
for name, options in ("default", {}), ("binary", {"DataMode": "Binary"}):
    simple.SaveData("sphere.vtp", sphere, **options)
    read = simple.OpenDataFile("sphere.vtp")
    read.UpdatePipeline()
    print(">", name + ":", read.GetDataInformation().GetNumberOfPoints(), "points")
END
verdict "$(HOME="$work" python3 saved.py 2> paraview.log | grep '^>')" \
"> ParaView (5, 11)
> default: 0 points
> binary: 50 points"
