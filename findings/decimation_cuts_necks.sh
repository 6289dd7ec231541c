#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshoptimizer 1.3.0 (npm), MeshoptSimplifier.simplify(), and VTK 9.1.0 (python3-vtk9
# 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkQuadricDecimation.
#
# Guess: decimation of a closed surface gives a closed surface of the same kind; at worst it stops early.
# What happens: neither looks whether an edge lies on three edges around a neck that bound no face. Two balls on a tube
# of radius 0.01 (the body is 2 long, 1888 faces) fall into two bodies: with VTK when 188 faces are left, with
# meshoptimizer when 90 are. On the way there VTK's result has edges of more than two faces. Nothing is said, and the
# later results are closed and without fault, so that no check of a mesh finds out.
#
# Why it matters: a decimated mesh is searched for its necks, and the thinnest one, the most prominent of all, is what
# is gone. CGAL's edge_collapse() asks for the link condition and keeps it.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1
npm_packages meshoptimizer@1.3.0

cd "$work"
cat > decimate.py << 'END'
import json
import subprocess
import meshes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

points, faces = meshes.dumbbell(0.01)
print("input:", meshes.describe(faces))
data, coordinates, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
coordinates.SetDataTypeToDouble()
for p in points:
    coordinates.InsertNextPoint(p)
for f in faces:
    polygons.InsertNextCell(3, f)
data.SetPoints(coordinates)
data.SetPolys(polygons)
for share in (0.8, 0.9):
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(data)
    decimation.SetTargetReduction(share)
    decimation.Update()
    out = decimation.GetOutput()
    corners = [tuple(out.GetCell(i).GetPointId(k) for k in range(3)) for i in range(out.GetNumberOfCells())]
    print("VTK, reduction by %g:" % share, meshes.describe(corners))

with open("mesh.json", "w") as out:
    json.dump([points, faces], out)
for share, result in zip((0.05, 0.02), json.loads(subprocess.check_output(["node", "simplify.mjs", "0.05", "0.02"]))):
    print("meshoptimizer, to %g:" % share, meshes.describe([tuple(f) for f in result]))
END
cat > simplify.mjs << 'END'
import { readFileSync } from 'node:fs';
import { MeshoptSimplifier } from 'meshoptimizer';

await MeshoptSimplifier.ready;
const [points, faces] = JSON.parse(readFileSync('mesh.json'));
const indices = new Uint32Array(faces.flat()), positions = new Float32Array(points.flat());
const results = process.argv.slice(2).map(share => {
  const target = Math.floor(indices.length * Number(share) / 3) * 3;
  const [result] = MeshoptSimplifier.simplify(indices, positions, 3, target, 1);
  return Array.from({ length: result.length / 3 }, (_, i) => [...result.slice(3 * i, 3 * i + 3)]);
});
console.log(JSON.stringify(results));
END
verdict "$(python3 decimate.py)" \
"input: V 946, F 1888, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
VTK, reduction by 0.8: V 190, F 376, components 1, Euler characteristic 4, border edges 0, non-manifold edges 2
VTK, reduction by 0.9: V 98, F 188, components 2, Euler characteristic 4, border edges 0, non-manifold edges 0
meshoptimizer, to 0.05: V 49, F 90, components 2, Euler characteristic 4, border edges 0, non-manifold edges 0
meshoptimizer, to 0.02: V 22, F 36, components 2, Euler characteristic 4, border edges 0, non-manifold edges 0"
