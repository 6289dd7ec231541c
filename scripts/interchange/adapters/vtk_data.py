# SPDX-License-Identifier: GPL-3.0-or-later
"""What a vtkPolyData, or what is in a vtkMultiBlockDataSet, holds. For VTK and ParaView."""
import held


def arrays(attributes):
    result = {}
    for i in range(attributes.GetNumberOfArrays()):
        values = attributes.GetArray(i)
        if values is not None:
            result[values.GetName() or str(i)] = [values.GetTuple(k) for k in range(values.GetNumberOfTuples())]
    return result


def leaves(data):
    if data.IsA("vtkCompositeDataSet"):
        iterator = data.NewIterator()
        while not iterator.IsDoneWithTraversal():
            yield iterator.GetCurrentDataObject()
            iterator.GoToNextItem()
    else:
        yield data


def save(name, data):
    points, faces, edges, cell_data, of_face, of_edge, point_data = [], [], [], {}, [], [], {}
    for leaf in leaves(data):
        first = len(points)
        for i in range(leaf.GetNumberOfPoints()):
            points.append(leaf.GetPoint(i))
        for key, values in arrays(leaf.GetPointData()).items():
            point_data.setdefault(key, []).extend(values)
        for key, values in arrays(leaf.GetCellData()).items():
            cell_data.setdefault(key, []).extend(values)
        base = len(of_face) and max(of_face[-1], of_edge[-1] if of_edge else 0) + 1
        for c in range(leaf.GetNumberOfCells()):
            ids = leaf.GetCell(c).GetPointIds()
            corners = [first + ids.GetId(k) for k in range(ids.GetNumberOfIds())]
            if leaf.GetCellType(c) in (3, 4):
                new = held.edges_of(corners)
                edges += new
                of_edge += [base + c] * len(new)
            elif leaf.GetCellType(c) in (5, 7, 9):
                faces.append(corners)
                of_face.append(base + c)
    held.save(name, points, faces, edges, point=point_data,
              face={k: [v[i] for i in of_face] for k, v in cell_data.items() if of_face},
              edge={k: [v[i] for i in of_edge] for k, v in cell_data.items() if of_edge})
