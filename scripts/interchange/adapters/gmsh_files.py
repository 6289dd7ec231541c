# SPDX-License-Identifier: GPL-3.0-or-later
"""Gmsh: reads a file, says what it holds, writes it in the same format: IN HELD OUT ..."""
import ctypes.util
import glob
import sys
import held

# The module asks the system for its library, which is not installed there.
ctypes.util.find_library = lambda name: next(iter(glob.glob("%s/lib/*/lib%s.so.*" % (sys.prefix, name))), None)
import gmsh  # noqa: E402


def convert(source, report, target):
    gmsh.initialize()
    try:
        convert_with_new_model(source, report, target)
    finally:
        gmsh.finalize()


def convert_with_new_model(source, report, target):
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(source)
    tags, places, _ = gmsh.model.mesh.getNodes()
    number = {int(t): i for i, t in enumerate(tags)}
    points = [list(map(float, places[3 * i:3 * i + 3])) for i in range(len(tags))]
    faces, face_entity = elements(2, number)
    edges, edge_entity = elements(1, number)
    if not points:
        sys.exit("not read: " + "; ".join(gmsh.logger.get()[-2:]))
    held.save(report, points, faces, edges, face={"entity": face_entity}, edge={"entity": edge_entity})
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.write(target)


def elements(dimension, number):
    result, entity = [], []
    for e in gmsh.model.getEntities(dimension):
        for kind, nodes in zip(*gmsh.model.mesh.getElements(*e)[::2]):
            size = gmsh.model.mesh.getElementProperties(kind)[3]
            rows = [[number[int(t)] for t in nodes[i:i + size]] for i in range(0, len(nodes), size)]
            result += rows
            entity += [e[1]] * len(rows)
    return result, entity


held.each(convert)
