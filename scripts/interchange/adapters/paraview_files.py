# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView: opens a file, says what it holds, saves the data in the same format: IN HELD OUT ..."""
import sys
from paraview import servermanager, simple
import held
import vtk_data


def convert(source, report, target):
    read = simple.OpenDataFile(source)
    if read is None:
        sys.exit("no reader")
    read.UpdatePipeline()
    vtk_data.save(report, servermanager.Fetch(read))
    if source.endswith("glb"):
        sys.exit("no writer")
    simple.SaveData(target, read)


held.each(convert)
