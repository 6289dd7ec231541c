# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts a mesh of any format that meshio reads into parts, and writes it with the parts as data of the cells.

python with_meshio.py MESH OUTPUT
"""

import sys

import meshio

import constrictions

mesh = meshio.read(sys.argv[1])
surface = constrictions.Surface(mesh.points, mesh.get_cells_type("triangle"))
necks = [c for c in surface.detect() if c.side == "object"]
split = surface.split(necks)
cells = [("triangle", split.faces)]
meshio.write_points_cells(sys.argv[2], split.vertices, cells, cell_data={"part": [split.labels]})
print(f"{len(necks)} necks, {split.labels.max() + 1} parts")
# prints: 3 necks, 4 parts
