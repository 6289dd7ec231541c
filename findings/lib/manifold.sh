# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts on Manifold begin with: packages.sh, Manifold 3.5.4, and $work/torus.json, points and faces of a torus.
. "$(dirname "${BASH_SOURCE[0]}")/packages.sh"
npm_packages manifold-3d@3.5.4
python3 - "$work/torus.json" << 'END_OF_TORUS'
import json
import sys

import meshes

with open(sys.argv[1], "w") as out:
    json.dump(meshes.torus(), out)
END_OF_TORUS
