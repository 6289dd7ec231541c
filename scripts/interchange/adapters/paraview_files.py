# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView: opens a file, says what it holds, saves the data in the same format: IN HELD OUT"""
import sys
from paraview import servermanager, simple
import vtk_data

source, report, target = sys.argv[1:4]
read = simple.OpenDataFile(source)
if read is None:
    sys.exit("no reader")
read.UpdatePipeline()
vtk_data.save(report, servermanager.Fetch(read))
simple.SaveData(target, read)
