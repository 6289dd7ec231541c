# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives PyVista's surfaces of triangles their constrictions: closed lines, with their prominences.

python with_pyvista.py MESH OUTPUT.vtp
"""

import sys

import numpy as np
import pyvista

import constrictions


def lines_of_constrictions(mesh):
    found = constrictions.Surface(mesh.points, mesh.regular_faces).detect()
    lines, number = [], 0
    for c in found:
        lines += [len(c.points) + 1, *range(number, number + len(c.points)), number]
        number += len(c.points)
    result = pyvista.PolyData(np.concatenate([np.empty((0, 3)), *(c.points for c in found)]), lines=lines)
    result.cell_data["prominence"] = [c.prominence for c in found]
    return result


pyvista.PolyData.constrictions = property(lines_of_constrictions)
curves = pyvista.read(sys.argv[1]).constrictions
curves.save(sys.argv[2])
print(f"{curves.n_cells} constrictions")
# prints: 3 constrictions
