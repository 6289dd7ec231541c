# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangle meshes of simple make: tubes, boundaries of voxels, isosurfaces; and their sections with planes.

A mesh is `Mesh(points, faces)`: doubles of shape (n, 3), and of shape (m, 3) the corners of each face, counterclockwise
seen from outside. All meshes are oriented manifolds, closed or with boundary.

A *mesh point* is (u, v, t): the point at (1 - t) p_u + t p_v of the edge uv, or with u = v a vertex. It stays on the
mesh when the vertices move. A loop is a list of mesh points; two in succession, and the last and the first, are in a
common face, so that the polygon through them is on the surface.
"""
import collections
import math

import numpy as np

Mesh = collections.namedtuple("Mesh", "points faces")


def length(points):
    """Length of the closed polygon through points, an array of shape (n, 3)."""
    sides = points - np.roll(points, 1, axis=0)
    return float(np.sqrt((sides * sides).sum(axis=1)).sum())


def positions(mesh, loop):
    """Coordinates of mesh points."""
    u, v, t = (np.array(column) for column in zip(*loop))
    return mesh.points[u] * (1 - t)[:, None] + mesh.points[v] * t[:, None]


def signed_volume(mesh):
    a, b, c = (mesh.points[mesh.faces[:, i]] for i in range(3))
    return float((a * np.cross(b, c)).sum() / 6)


# ---- Tubes --------------------------------------------------------------------------------------------------------


def tube(rings, ends):
    """The surface through rings of n points each, an array of shape (m, n, 3). `ends` says what is at the first and the
    last ring: "joined" joins them, "caps" puts a point into the middle of each, "open" leaves the rims free."""
    m, n = rings.shape[:2]
    number = np.arange(m * n).reshape(m, n)
    rows = number if ends == "joined" else number[:-1]
    p, u = rows, np.roll(number, -1, axis=0)[: len(rows)]
    q, w = np.roll(p, -1, axis=1), np.roll(u, -1, axis=1)
    faces = [np.stack([p, q, w], -1).reshape(-1, 3), np.stack([p, w, u], -1).reshape(-1, 3)]
    points = [rings.reshape(-1, 3)]
    if ends == "caps":
        for ring, centre, turn in ((0, m * n, 1), (m - 1, m * n + 1, -1)):
            a = number[ring]
            b = np.roll(a, -turn)
            faces.append(np.stack([np.full(n, centre), b, a], -1))
            points.append(rings[ring].mean(axis=0)[None])
    faces = np.concatenate(faces)
    mesh = Mesh(np.concatenate(points), faces)
    return mesh if signed_volume(mesh) > 0 else Mesh(mesh.points, faces[:, ::-1].copy())


def ring_loop(ring, n):
    """The loop of the n vertices of a ring of a tube."""
    return [(ring * n + k, ring * n + k, 0.0) for k in range(n)]


def directions(n):
    """Cosines and sines of n equal steps around a circle. Those of math round alike everywhere, unlike numpy's."""
    angles = [2 * math.pi * k / n for k in range(n)]
    return np.array([[math.cos(a), math.sin(a)] for a in angles])


def lathe(n, profile, ends):
    """Surface of revolution about the z axis: rings of n vertices with the radii and heights of a profile."""
    profile, around = np.array(profile, float), directions(n)
    rings = np.empty((len(profile), n, 3))
    rings[:, :, :2] = profile[:, None, :1] * around[None]
    rings[:, :, 2] = profile[:, 1:]
    return tube(rings, ends)


def sweep(centres, radii, n, closed=False, normals=None):
    """A tube around a curve through centres (m, 3), with circles of the given radii perpendicular to it, or with
    radii (m, n) other sections. An open one ends in points. Without `normals`, from which angles are counted, the
    sections turn as little as possible."""
    centres = np.asarray(centres, float)
    if closed:
        tangents = np.roll(centres, -1, axis=0) - np.roll(centres, 1, axis=0)
    else:
        tangents = np.gradient(centres, axis=0)
    tangents /= np.sqrt((tangents * tangents).sum(axis=1))[:, None]
    if normals is None:
        normals = np.empty_like(centres)
        normal = np.eye(3)[int(np.argmin(np.abs(tangents[0])))]
        for i, t in enumerate(tangents):
            normal = normal - t * (normal * t).sum()
            normal = normal / math.sqrt((normal * normal).sum())
            normals[i] = normal
    else:
        normals = normals - tangents * (normals * tangents).sum(axis=1)[:, None]
        normals = normals / np.sqrt((normals * normals).sum(axis=1))[:, None]
    binormals = np.cross(tangents, normals)
    radii = np.asarray(radii, float)
    radii = np.broadcast_to(radii[:, None] if radii.ndim == 1 else radii, (len(centres), n))
    around = directions(n)
    rings = centres[:, None] + radii[:, :, None] * (
        around[None, :, :1] * normals[:, None] + around[None, :, 1:] * binormals[:, None])
    return tube(rings, "joined" if closed else "caps")


# ---- Voxels -------------------------------------------------------------------------------------------------------


def voxel_surface(cells):
    """Boundary of a set of unit cubes, each given by its corner with the least coordinates. Cubes that touch have a
    square in common, or there is a way from one to the other through cubes around where they touch."""
    cells, number, points, faces = set(cells), {}, [], []
    for cell in sorted(cells):
        for axis in range(3):
            for up in (0, 1):
                other = list(cell)
                other[axis] += 2 * up - 1
                if tuple(other) in cells:
                    continue
                square = []
                for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += up
                    corner[(axis + 1) % 3] += i
                    corner[(axis + 2) % 3] += j
                    corner = tuple(corner)
                    if corner not in number:
                        number[corner] = len(points)
                        points.append(corner)
                    square.append(number[corner])
                a, b, c, d = square if up else square[::-1]
                faces += [(a, b, c), (a, c, d)]
    return Mesh(np.array(points, float), np.array(faces))


# ---- Isosurfaces --------------------------------------------------------------------------------------------------

# A cube in six tetrahedra around its diagonal, positively oriented; a corner is given by the bits of x, y and z.
_TETRAHEDRA = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7))
# Even permutations of the corners of a tetrahedron that bring one corner, or two, to the front.
_FIRST = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))
_PAIRS = ((0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 2, 0), (2, 3, 0, 1))


def isosurface(field, lower, upper, step):
    """Where a field changes its sign, in a box of cubes; negative is inside. Marching tetrahedra: closed if no point of
    the box's boundary is inside, else with boundary there. `field` takes arrays x, y, z. A crossing keeps away from the
    ends of its edge, by 4% of it, so that no face is degenerate."""
    counts = [int(round((b - a) / step)) + 1 for a, b in zip(lower, upper)]
    axes = [a + step * np.arange(count) for a, count in zip(lower, counts)]
    values = np.empty(counts)
    for i, x in enumerate(axes[0]):
        y, z = np.meshgrid(axes[1], axes[2], indexing="ij")
        values[i] = field(np.full_like(y, x), y, z)
    inside = values < 0
    strides = (counts[1] * counts[2], counts[2], 1)
    offset = [sum(stride for bit, stride in enumerate(strides) if corner >> bit & 1) for corner in range(8)]
    flat_inside, flat_values = inside.ravel(), values.ravel()
    number = np.arange(flat_values.size).reshape(counts)[:-1, :-1, :-1].ravel()
    corners_inside = sum(flat_inside[number + o].astype(np.int8) for o in offset)
    number = number[(corners_inside > 0) & (corners_inside < 8)]

    triangles = []  # of pairs of grid nodes
    for tetrahedron in _TETRAHEDRA:
        nodes = np.stack([number + offset[c] for c in tetrahedron], -1)
        code = (flat_inside[nodes] * np.array([1, 2, 4, 8])).sum(axis=1)
        for permutation in _FIRST:
            for outward, case in ((True, 1 << permutation[0]), (False, 15 - (1 << permutation[0]))):
                a, b, c, d = (nodes[code == case][:, i] for i in permutation)
                triangles.append(((a, b), (a, c), (a, d)) if outward else ((a, b), (a, d), (a, c)))
        for permutation in _PAIRS:
            case = 1 << permutation[0] | 1 << permutation[1]
            a, b, c, d = (nodes[code == case][:, i] for i in permutation)
            triangles += [((a, c), (a, d), (b, d)), ((a, c), (b, d), (b, c))]
    keys = np.concatenate([
        np.stack([np.minimum(u, v) * flat_values.size + np.maximum(u, v) for u, v in t], -1) for t in triangles])
    edges, faces = np.unique(keys, return_inverse=True)
    u, v = edges // flat_values.size, edges % flat_values.size
    t = np.clip(flat_values[u] / (flat_values[u] - flat_values[v]), 0.04, 0.96)

    def place(node):
        index = np.unravel_index(node, counts)
        return np.stack([axis[i] for axis, i in zip(axes, index)], -1)

    return Mesh(place(u) * (1 - t)[:, None] + place(v) * t[:, None], faces.reshape(-1, 3))


# ---- Topology -----------------------------------------------------------------------------------------------------


def components(mesh):
    """The number of the connected component of each vertex."""
    label = np.arange(len(mesh.points))
    while True:
        least = label[mesh.faces].min(axis=1)
        new = label.copy()
        for i in range(3):
            np.minimum.at(new, mesh.faces[:, i], least)
        new = new[new]
        if (new == label).all():
            return np.unique(label, return_inverse=True)[1]
        label = new


Topology = collections.namedtuple("Topology", "components genus holes")


def topology(mesh):
    """Components, the sum of their genera, and closed curves of the boundary. Throws ValueError unless the mesh is an
    oriented manifold with all of its vertices used."""
    n, faces = len(mesh.points), mesh.faces.astype(np.int64)
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    halfedges = start * n + end
    if (start == end).any():
        raise ValueError("a face has a corner twice")
    if len(np.unique(halfedges)) != len(halfedges):
        raise ValueError("two faces have an edge in common, in the same direction")
    opposite = end * n + start
    border = ~np.isin(opposite, halfedges)
    # the faces of a vertex are one fan: each halfedge is joined to the next one around its start
    order = np.argsort(halfedges)
    previous = np.roll(faces, 1, axis=1).ravel()  # the third corner of the face
    turned = start * n + previous  # edge from the start to the third corner; its halfedge is in the next face
    place = np.minimum(np.searchsorted(halfedges[order], turned), len(order) - 1)
    found = halfedges[order][place] == turned
    following = np.where(found, order[place], -1)
    label = np.arange(len(halfedges))
    pairs = np.stack([np.flatnonzero(following >= 0), following[following >= 0]], -1)
    while True:
        new = label.copy()
        least = label[pairs].min(axis=1)
        np.minimum.at(new, pairs[:, 0], least)
        np.minimum.at(new, pairs[:, 1], least)
        new = new[new]
        if (new == label).all():
            break
        label = new
    fans = np.unique(np.stack([start, label], -1), axis=0)
    if len(fans) != n or len(np.unique(start)) != n:
        raise ValueError("a vertex has several fans of faces, or none")
    successor = dict(zip(end[border].tolist(), start[border].tolist()))
    holes = 0
    while successor:
        holes += 1
        first, at = next(iter(successor.items()))
        del successor[first]
        while at != first:
            at = successor.pop(at)
    count = int(components(mesh).max()) + 1
    edges = (len(halfedges) + int(border.sum())) // 2
    euler = n - edges + len(faces)
    return Topology(count, (2 * count - euler - holes) // 2, holes)


# ---- Sections -----------------------------------------------------------------------------------------------------


def sections(mesh, origin, normal, heights=None):
    """The closed curves in which a plane meets the mesh, as loops of mesh points. `heights` are those of the vertices
    above the origin, if they are known. A vertex in the plane counts as above it."""
    if heights is None:
        heights = ((mesh.points - origin) * normal).sum(axis=1)
    above = heights >= 0
    corners = above[mesh.faces]
    crossed = np.flatnonzero(corners.any(axis=1) & ~corners.all(axis=1))
    # of the two edges that a face crosses, the one that goes up leads in, the one that goes down leads out
    follow = {}
    for face, up in zip(mesh.faces[crossed].tolist(), corners[crossed].tolist()):
        entry = exit_ = None
        for i in range(3):
            u, v = face[i], face[i - 2]
            if up[i] != up[i - 2]:
                if up[i]:
                    exit_ = (v, u)
                else:
                    entry = (u, v)
        follow[entry] = exit_
    loops = []
    while follow:
        first, at = next(iter(follow.items()))
        del follow[first]
        loop = [first]
        while at != first and at is not None:
            loop.append(at)
            at = follow.pop(at, None)
        if at is not None:
            loops.append([(u, v, float(heights[u] / (heights[u] - heights[v]))) for u, v in loop])
    return loops
