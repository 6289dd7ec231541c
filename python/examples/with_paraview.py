# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows the constrictions of a mesh in ParaView. In ParaView itself, paste the script of the programmable filter into
Filters, Programmable Filter, whose output is to be vtkPolyData.

pvpython with_paraview.py MESH OUTPUT.vtp
"""

import sys

from paraview import simple

SCRIPT = """
import constrictions, numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
triangles = inputs[0].Polygons.reshape(-1, 4)[:, 1:]
found = constrictions.Surface(inputs[0].Points, triangles).detect()
lines, number = vtkCellArray(), 0
for c in found:
    lines.InsertNextCell(len(c.points) + 1, [*range(number, number + len(c.points)), number])
    number += len(c.points)
output.Initialize()
output.Points = numpy.concatenate([numpy.empty((0, 3)), *(c.points for c in found)])
output.VTKObject.SetLines(lines)
output.CellData.append(numpy.array([c.prominence for c in found]), "prominence")
"""
curves = simple.ProgrammableFilter(simple.OpenDataFile(sys.argv[1]), OutputDataSetType="vtkPolyData", Script=SCRIPT)
simple.SaveData(sys.argv[2], curves, DataMode="Binary")
print(f"{curves.GetDataInformation().GetNumberOfCells()} constrictions")
# prints: 3 constrictions
