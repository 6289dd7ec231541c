# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK: reads a file, says what it holds, writes it in the same format: IN HELD OUT ..."""
import sys
import held
import vtk_data
from vtkmodules import vtkIOGeometry, vtkIOLegacy, vtkIOPLY, vtkIOXML
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow


def check():
    text = vtkOutputWindow.GetInstance().GetOutput()
    if "rror" in text:
        sys.exit(" ".join(text.split())[:300])


def instance(kind, what, classes):
    module = {"ply": vtkIOPLY, "vtk": vtkIOLegacy, "vtp": vtkIOXML}.get(kind, vtkIOGeometry)
    return getattr(module, classes[kind] + what)()


def convert(source, report, target):
    kind = source.rsplit(".", 1)[1]
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    classes = {"obj": "vtkOBJ", "ply": "vtkPLY", "stl": "vtkSTL", "vtk": "vtkPolyData", "vtp": "vtkXMLPolyData",
               "glb": "vtkGLTF"}
    reader = instance(kind, "Reader", classes)
    reader.SetFileName(source)
    reader.Update()
    check()
    data = reader.GetOutputDataObject(0)
    vtk_data.save(report, data)
    writer = instance(kind, "Writer", classes)
    writer.SetFileName(target)
    writer.SetInputData(data)
    if kind in ("stl", "vtk"):
        writer.SetFileTypeToBinary()
    if kind == "glb":
        writer.InlineDataOn()
    writer.Write()
    check()


held.each(convert)
