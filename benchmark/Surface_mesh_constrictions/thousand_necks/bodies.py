# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies with known narrow places, by families.

A narrow place (`Place`) is given by an axis, a segment from one wide part to the other: through a neck inside the
solid, through a bore or a throat of a pore outside of it. With it go loops on the mesh that wind around the axis once,
at places where the cross-section is least. The longest of them is the *known loop*. All curves around the wide parts at
the ends of the axis are longer, so that the shortest curve in between is a constriction, and not longer than the known
loop.

Each family is a function of a random generator and the number of the body, which returns a mesh, its places, and what
its topology is by construction.
"""
import collections
import math
import zlib

import numpy as np

from surfaces import (Mesh, Topology, directions, isosurface, lathe, length, positions, ring_loop, sections, sweep,
                      tube, voxel_surface)

# side: "object" for a neck of the solid, "complement" for a neck of what is around it
Place = collections.namedtuple("Place", "axis side loops")
Body = collections.namedtuple("Body", "family name treatment mesh places topology")

BALL, RING = Topology(1, 0, 0), Topology(1, 1, 0)
SEED = 1  # of the set that is named
TREATMENTS = ("plain", "rotated", "moved float", "rotated moved float", "noise")
SIDES = (6, 8, 10, 12, 16, 24, 32, 48, 64, 96, 128)


# ---- Places -------------------------------------------------------------------------------------------------------


def plane_basis(direction):
    """Two unit vectors perpendicular to a unit vector and to each other, a right-handed basis with it."""
    a = np.cross(direction, np.eye(3)[int(np.argmin(np.abs(direction)))])
    a /= math.sqrt((a * a).sum())
    return a, np.cross(direction, a)


def winding(points, origin, direction):
    """How often a closed polygon winds around an axis; `direction` is a unit vector."""
    a, b = plane_basis(direction)
    relative = points - origin
    x, y = (relative * a).sum(axis=1), (relative * b).sum(axis=1)
    next_x, next_y = np.roll(x, -1), np.roll(y, -1)
    turns = np.arctan2(x * next_y - y * next_x, x * next_x + y * next_y)
    return int(round(float(turns.sum()) / (2 * math.pi)))


def section_place(mesh, start, end, side, at=(0.5,), wide=None):
    """A place whose loops are sections of the mesh perpendicular to the axis, at parts of its length, of the curves
    that wind around it the shortest."""
    axis = np.array([start, end], float)
    direction = axis[1] - axis[0]
    direction /= math.sqrt((direction * direction).sum())
    loops = []
    for part in at:
        origin = axis[0] + part * (axis[1] - axis[0])
        around = [loop for loop in sections(mesh, origin, direction)
                  if abs(winding(positions(mesh, loop), origin, direction)) == 1]
        if not around:
            raise ValueError("no curve of the section is around the axis")
        loops.append(min(around, key=lambda loop: length(positions(mesh, loop))))
    return Place(axis, side, loops)


# ---- Bores, counterbores, straight necks, boxes, voxels -----------------------------------------------------------


def stretch(radius, start, end, rows):
    """A straight piece of a profile in rows, without its end."""
    return [(radius, start + (end - start) * i / rows) for i in range(rows)]


def bore(g, i):
    n, rows, r, h = int(g.choice(SIDES)), int(g.choice([1, 1, 1, 2, 3])), g.uniform(0.5, 3), g.uniform(1, 5)
    mesh = lathe(n, stretch(r, 0, h, rows) + [(r, h), (2 * r, h), (2 * r, 0)], "joined")
    rings = [ring_loop(row, n) for row in range(rows + 1)]
    return mesh, [Place(np.array([[0, 0, -0.1 * h], [0, 0, 1.1 * h]]), "complement", rings)], RING


def counterbore(g, i):
    n, rows = int(g.choice(SIDES)), int(g.choice([1, 1, 1, 2, 3]))
    r, h = g.uniform(2, 5), g.uniform(2, 5)
    wide, outer, top = r * g.uniform(1.6, 2.4), r * g.uniform(3, 4), h + g.uniform(0.5, 2)
    profile = stretch(r, 0, h, rows) + [(r, h), (wide, h), (wide, top), (outer, top), (outer, 0)]
    rings = [ring_loop(row, n) for row in range(rows + 1)]
    return lathe(n, profile, "joined"), [Place(np.array([[0, 0, -0.1 * h], [0, 0, top]]), "complement", rings)], RING


def straight_neck(g, i):
    n, rows, h = int(g.choice(SIDES)), int(g.choice([1, 1, 1, 2, 3])), g.uniform(0.5, 4)
    profile = [(2, 0), (2, 2)] + stretch(1, 2, 2 + h, rows) + [(1, 2 + h), (2, 2 + h), (2, 4 + h)]
    rings = [ring_loop(2 + row, n) for row in range(rows + 1)]
    return lathe(n, profile, "caps"), [Place(np.array([[0, 0, 1], [0, 0, 3 + h]]), "object", rings)], BALL


def grooves(g, i):
    """A shaft with fins: the grooves between them, 0.3 to 1.2 radii wide, and 0.2 to 0.8 deep."""
    n, number = int(g.choice(SIDES)), int(g.randint(2, 6))
    profile, places = [], []

    def add(radius, height):
        profile.append((radius, height))
        return len(profile) - 1

    at, fin = 0.0, 1 + g.uniform(0.2, 0.8)
    add(fin, at)
    for _ in range(number):
        at += g.uniform(0.15, 0.4)
        start = at
        add(fin, at)
        rings = [add(1, at)]
        at += g.uniform(0.3, 1.2)
        rings.append(add(1, at))
        fin = 1 + g.uniform(0.2, 0.8)
        add(fin, at)
        axis = np.array([[0, 0, start - 0.05], [0, 0, at + 0.05]])
        places.append(Place(axis, "object", [ring_loop(ring, n) for ring in rings]))
    add(fin, at + 0.3)
    return lathe(n, profile, "caps"), places, BALL


def box(corner, sizes):
    return [tuple(c + d for c, d in zip(corner, offset)) for offset in np.ndindex(*(int(s) for s in sizes))]


def boxes_with_tube(g, i):
    a, b, d = g.randint(2, 5, 3), g.randint(2, 5, 3), int(g.randint(1, 5))
    w = int(a[0])
    mesh = voxel_surface(box((0, 0, 0), a) + box((w, 0, 0), (d, 1, 1)) + box((w + d, 0, 0), b))
    parts = [(1 + k + 0.5) / (d + 2) for k in range(d)]
    return mesh, [section_place(mesh, (w - 1, 0.5, 0.5), (w + d + 1, 0.5, 0.5), "object", parts)], BALL


def digital_ball(centre, radius):
    reach = range(-int(radius) - 1, int(radius) + 2)
    return {tuple(c + d for c, d in zip(centre, (x, y, z))) for x in reach for y in reach for z in reach
            if x * x + y * y + z * z <= radius * radius}


def voxel_dumbbell(g, i):
    """Two digital balls and a digital rod, as a segmented image gives them."""
    radius = int(g.randint(8, 19))
    rod, distance = 0.3 * radius, int(2.2 * radius)
    reach = range(-int(rod) - 1, int(rod) + 2)
    cells = digital_ball((0, 0, 0), radius) | digital_ball((distance, 0, 0), radius)
    cells |= {(x, y, z) for x in range(distance + 1) for y in reach for z in reach if y * y + z * z <= rod * rod}
    mesh = voxel_surface(cells)
    ends = (radius // 2 + 0.5, 0.5, 0.5), (distance - radius // 2 + 0.5, 0.5, 0.5)
    return mesh, [section_place(mesh, *ends, "object")], BALL


def voxel_rooms(g, i):
    """Rooms on a grid and corridors between some that are next to each other: of genus 0 for each tree, more for each
    corridor more."""
    rooms = 4 + 3 * i
    width = int(g.choice([1, 1, 2]))
    shape, pitch = (3, 3, 3 + i // 3), width + 7
    start = tuple(int(g.randint(n)) for n in shape)
    sizes, doors, ways = {start: None}, set(), []

    def neighbours(room):
        for axis in range(3):
            for step in (-1, 1):
                other = tuple(c + step * (k == axis) for k, c in enumerate(room))
                if all(0 <= c < n for c, n in zip(other, shape)):
                    yield other

    while len(sizes) < rooms:
        ways = sorted((a, b) for a in sizes for b in neighbours(a) if b not in sizes)
        a, b = ways[g.randint(len(ways))]
        sizes[b] = None
        doors.add((min(a, b), max(a, b)))
    ways = sorted({(min(a, b), max(a, b)) for a in sizes for b in neighbours(a) if b in sizes} - doors)
    for k in g.permutation(len(ways))[: int(g.randint(0, 2 + 2 * i))]:
        doors.add(ways[k])
    cells = set()
    for room in sorted(sizes):
        half = int(g.randint(1, 3))
        sizes[room] = half
        cells.update(box([pitch * c - half for c in room], [width + 2 * half] * 3))
    for a, b in doors:
        axis = next(k for k in range(3) if a[k] != b[k])
        cells.update(box([pitch * c for c in a], [pitch + 1 if k == axis else width for k in range(3)]))
    mesh, places = voxel_surface(cells), []
    for a, b in sorted(doors):
        axis = next(k for k in range(3) if a[k] != b[k])
        end = np.array([a, b], float) * pitch + width / 2
        # from inside of one room to inside of the other
        end[0, axis] += width / 2 + sizes[a] - 0.5
        end[1, axis] -= width / 2 + sizes[b] - 0.5
        places.append(section_place(mesh, end[0], end[1], "object"))
    return mesh, places, Topology(1, len(doors) - len(sizes) + 1, 0)


def plate(g, i):
    """A plate with square holes, of genus up to 50."""
    across, along = ((1, 1), (1, 2), (2, 2), (2, 3), (3, 3), (3, 4), (4, 5), (5, 5), (5, 8), (5, 10))[i % 10]
    width, thick = int(g.choice([1, 1, 2])), int(g.randint(1, 4))
    pitch = width + 3 + thick
    holes = [(pitch * x + pitch - width, pitch * y + pitch - width) for x in range(across) for y in range(along)]
    inside = {(x + dx, y + dy) for x, y in holes for dx in range(width) for dy in range(width)}
    size = (pitch * across + pitch - width, pitch * along + pitch - width)
    cells = [(x, y, z) for x in range(size[0]) for y in range(size[1]) for z in range(thick) if (x, y) not in inside]
    mesh, half = voxel_surface(cells), width / 2
    parts = [(0.1 + k + 0.5) / (thick + 0.2) for k in range(thick)]
    places = [section_place(mesh, (x + half, y + half, -0.1), (x + half, y + half, thick + 0.1), "complement", parts)
              for x, y in holes]
    return mesh, places, Topology(1, len(holes), 0)


def ladder(g, i):
    """A ladder of square bars, with a hole between any two rungs: each rung is a place, and each piece of a rail
    between two rungs."""
    holes, width, gap = 1 + i, int(g.choice([1, 1, 2])), int(g.randint(2, 5))
    across = int(g.randint(2, 5))
    size = (2 * width + across, (holes + 1) * width + holes * gap)
    inside = {(x, width + k * (width + gap) + y) for x in range(width, width + across) for k in range(holes)
              for y in range(gap)}
    mesh = voxel_surface([(x, y, z) for x in range(size[0]) for y in range(size[1]) for z in range(width)
                          if (x, y) not in inside])
    half, places = width / 2, []
    for k in range(holes + 1):
        y = k * (width + gap) + half
        ends = (half, y, half), (size[0] - half, y, half)
        places.append(section_place(mesh, *ends, "object", (0.47, 0.53)))
    for k in range(holes):
        low = k * (width + gap) + half
        for x in (half, size[0] - half):
            ends = (x, low, half), (x, low + width + gap, half)
            places.append(section_place(mesh, *ends, "object", (0.47, 0.53)))
    return mesh, places, Topology(1, holes, 0)


# ---- Chains, knots, bones, threads --------------------------------------------------------------------------------


def wave(part):
    """0 at the integers, 1 in the middle between them."""
    return math.sin(math.pi * part) ** 2


def beads(number, rows, neck_radii):
    """Radii along a chain of beads of radius 1, `rows` from one neck to the next; the ends are half beads, round."""
    radii = []
    for k in range(number):
        for row in range(rows):
            part = row / rows
            left, right = neck_radii[k - 1] if k else None, neck_radii[k] if k < number - 1 else None
            least = left if part < 0.5 else right
            radii.append(math.sqrt(1 - (1 - 2 * part) ** 2) if least is None else least + (1 - least) * wave(part))
    return radii[1:]


def chain(g, i, rows=None, sides=None):
    """Beads on a bent string."""
    number, rows, n = int(g.randint(4, 10)), rows or int(g.randint(8, 21)), sides or int(g.randint(8, 41))
    necks = [float(g.uniform(0.25, 0.6)) for _ in range(number - 1)]
    radii = beads(number, rows, necks)
    turn, rise, bend = g.uniform(0.2, 0.5), g.uniform(0.5, 2.5), g.uniform(6, 12)
    steps = [2.2 * (k + 1) / rows for k in range(len(radii))]
    centres = [(bend * math.cos(s / bend), bend * math.sin(s / bend), rise * math.sin(turn * s)) for s in steps]
    mesh = sweep(centres, radii, n)
    places = []
    for k in range(number - 1):
        row = rows * (k + 1) - 1
        axis = np.array([centres[row - rows // 2], centres[row + rows // 2]])
        places.append(Place(straightened(axis, centres[row]), "object", [ring_loop(row, n)]))
    return mesh, places, BALL


def shallow_necks(g, i):
    """A rod that gets thinner by 3% to 15% at a few places."""
    number, rows, n = int(g.randint(1, 4)), 2 * int(g.randint(4, 13)), int(g.randint(16, 49))
    pitch, depths = g.uniform(1.5, 3), [float(g.uniform(0.03, 0.15)) for _ in range(number)]
    profile = [(0.6, -0.25), (1, 0)]
    for k, depth in enumerate(depths):
        profile += [(1 - depth * wave(row / rows), pitch * (k + row / rows)) for row in range(1, rows)]
        profile.append((1, pitch * (k + 1)))
    profile.append((0.6, pitch * number + 0.25))
    places = []
    for k in range(number):
        axis = np.array([[0, 0, pitch * k], [0, 0, pitch * (k + 1)]])
        at = min(range(len(profile)), key=lambda r: abs(profile[r][1] - pitch * (k + 0.5)))
        places.append(Place(axis, "object", [ring_loop(at, n)]))
    return lathe(n, profile, "caps"), places, BALL


def straightened(axis, middle):
    """The segment, moved so that its middle is the given point."""
    return axis + (np.asarray(middle) - axis.mean(axis=0))


def knot(g, i, rows=None, sides=None):
    """A tube along a torus knot, thick and thin in turn."""
    p, q = ((2, 3), (3, 2), (2, 5), (3, 4), (2, 7), (5, 2), (3, 5), (1, 1))[i % 8]
    n, rows = sides or int(g.randint(8, 25)), rows or int(g.randint(10, 21))
    thick, necks = 0.5 if p > 1 else 0.8, 4 * p + 2 * q
    least = [float(g.uniform(0.3, 0.6)) for _ in range(necks)]
    centres, normals, radii = [], [], []
    for k in range(necks * rows):
        part = k / (necks * rows)
        a, b = 2 * math.pi * p * part, 2 * math.pi * q * part
        outward = np.array([math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)])
        centres.append(np.array([4 * math.cos(a), 4 * math.sin(a), 0]) + 1.6 * outward)
        normals.append(outward)
        neck = least[int((k + rows // 2) // rows) % necks]
        radii.append(thick * (neck + (1 - neck) * wave(k / rows)))
    mesh = sweep(centres, radii, n, closed=True, normals=np.array(normals))
    places = []
    for k in range(necks):
        row = rows * k
        axis = np.array([centres[row - rows // 3], centres[(row + rows // 3) % len(centres)]])
        places.append(Place(straightened(axis, centres[row]), "object", [ring_loop(row, n)]))
    return mesh, places, RING


def smooth(points, at):
    """A curve through points (position, value), with level tangents, at a position."""
    for (a, start), (b, end) in zip(points, points[1:]):
        if at <= b:
            t = (at - a) / (b - a)
            return start + (end - start) * t * t * (3 - 2 * t)
    return points[-1][1]


def bone(g, i, rows=None, sides=None):
    """A long bone with a shaft and a neck below its head, condyles at the other end, and noise like that of a scan: up
    to a tenth or, in every other body, a fifth of an edge."""
    rows, n = rows or int(g.randint(30, 91)), sides or int(g.randint(16, 49))
    shaft, neck = g.uniform(0.4, 0.55), g.uniform(0.45, 0.6)
    profile = [(0, 0.0), (0.6, 1.0), (5, shaft), (9, 0.95), (10.2, neck), (11.6, 0.9), (12.6, 0.0)]
    heights = [12.6 * (k + 1) / (rows + 1) for k in range(rows)]
    bend, flat = g.uniform(0.2, 0.8), g.uniform(0.8, 1.0)
    centres = [(bend * math.sin(z / 4), bend * max(0, z - 8) / 2, z) for z in heights]
    around = directions(n)
    radii = np.empty((rows, n))
    for k, z in enumerate(heights):
        r = smooth(profile, z)
        if z < 0.6 or z > 11.6:  # round ends
            t = 1 - z / 0.6 if z < 0.6 else (z - 11.6) / 1.0
            r = (1.0 if z < 0.6 else 0.9) * math.sqrt(max(0.0, 1 - t * t))
        condyles = max(0.0, 1 - abs(z - 0.6) / 2)
        radii[k] = r * (1 + 0.25 * condyles * around[:, 0] ** 2) * (flat + (1 - flat) * around[:, 1] ** 2)
    mesh = sweep(centres, radii, n)
    edge = min(12.6 / rows, 2 * math.pi * shaft / n)
    amplitude = edge * (0.1 if i % 2 else 0.2)
    mesh = Mesh(mesh.points + g.uniform(-1, 1, mesh.points.shape) * amplitude, mesh.faces)
    places = []
    for low, height, high in ((0.8, 5, 8.8), (9.2, 10.2, 11.4)):
        row = int(np.argmin(np.abs(np.array(heights) - height)))
        first, last = (int(np.argmin(np.abs(np.array(heights) - h))) for h in (low, high))
        ends = np.array([centres[first], centres[last]])
        direction = np.array(centres[row + 1]) - np.array(centres[row - 1])
        direction /= math.sqrt((direction * direction).sum())
        middle = np.array(centres[row])
        axis = np.array([middle + direction * ((end - middle) * direction).sum() for end in ends])
        rings = [ring_loop(k, n) for k in (row - 1, row, row + 1)]
        points = [mesh.points[np.array([u for u, _, _ in ring])] for ring in rings]
        places.append(Place(axis, "object", [min(zip(map(length, points), rings))[1]]))
    return mesh, places, BALL


def thread(g, i):
    """Bolts with a groove between head and thread, studs that are threaded on both sides of a waist, and nuts whose
    thread is broken by a collar. The thread is a helical ridge that runs out at its ends."""
    n, pitch, depth = int(g.choice([16, 24, 32])), g.uniform(0.3, 0.5), g.uniform(0.1, 0.2)
    waist, kind, around = g.uniform(0.55, 0.75), i % 3, directions(n)
    step, groove, long = pitch / 8, g.uniform(0.4, 1.2), g.uniform(2, 4)

    def threaded(start, end, sign):
        rows = []
        count = int(round((end - start) / step))
        for k in range(count + 1):
            z = start + (end - start) * k / count
            fade = min(1.0, (z - start) / pitch, (end - z) / pitch)
            row = []
            for a in range(n):
                phase = (z / pitch - a / n) % 1.0
                row.append(1 + sign * fade * depth * (1 - abs(2 * phase - 1)))
            rows.append((z, row))
        return rows

    def rows_at(radius, *heights):
        return [(z, [radius] * n) for z in heights]

    def waist_rows(start):
        return rows_at(waist, *[start + groove * k / 3 for k in range(4)])

    if kind == 0:
        rows = rows_at(1.8, 0, 0.8) + waist_rows(0.8) + threaded(0.8 + groove, 0.8 + groove + long, 1)
        first, middle = 2, 0.8 + groove / 2
    elif kind == 1:
        rows = threaded(0, long, 1)
        first, middle = len(rows), long + groove / 2
        rows += waist_rows(long) + threaded(long + groove, 2 * long + groove, 1)
    else:  # the thread is cut into the wall of the hole
        rows = threaded(0, long / 2, 1)
        first, middle = len(rows), long / 2 + groove / 2
        rows += waist_rows(long / 2) + threaded(long / 2 + groove, long + groove, 1)
        rows += rows_at(2.0, long + groove, 0)
    rings = np.empty((len(rows), n, 3))
    for k, (z, radii) in enumerate(rows):
        rings[k, :, :2] = np.array(radii)[:, None] * around
        rings[k, :, 2] = z
    mesh = tube(rings, "joined" if kind == 2 else "caps")
    axis = np.array([[0, 0, middle - groove / 2 - 0.3], [0, 0, middle + groove / 2 + 0.3]])
    loops = [ring_loop(first + k, n) for k in range(4)]
    return mesh, [Place(axis, "complement" if kind == 2 else "object", loops)], RING if kind == 2 else BALL


# ---- Trees, lattices, pores, vessels ------------------------------------------------------------------------------


class Balls_and_rods:
    """Balls, and rods between them that are thinnest in the middle: negative inside."""

    def __init__(self):
        self.balls, self.rods = [], []

    def __call__(self, x, y, z):
        value = np.full(x.shape, np.inf)
        for (a, b, c), radius in self.balls:
            value = np.minimum(value, np.sqrt((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2) - radius)
        for start, end, thick, thin in self.rods:
            d, u, v, w = end - start, x - start[0], y - start[1], z - start[2]
            t = np.clip((u * d[0] + v * d[1] + w * d[2]) / (d * d).sum(), 0, 1)
            away = np.sqrt((u - t * d[0]) ** 2 + (v - t * d[1]) ** 2 + (w - t * d[2]) ** 2)
            value = np.minimum(value, away - thin - (thick - thin) * (2 * t - 1) ** 2)
        return value

    def join(self, start, end, thick, thin):
        self.rods.append((np.array(start, float), np.array(end, float), thick, thin))

    def box(self, margin):
        centres = np.array([c for c, _ in self.balls])
        return centres.min(axis=0) - margin, centres.max(axis=0) + margin

    def places(self, mesh, side):
        return [section_place(mesh, start, end, side) for start, end, _, _ in self.rods]


def grown_tree(g, number):
    """Balls of radii 0.7 to 1 that grow from one another with gaps, each joined to its parent by a rod."""
    tree, between = Balls_and_rods(), []  # and points of the rods between the balls
    tree.balls.append((np.zeros(3), 1.0))

    def is_near(points, others, distance):
        gaps = points[:, None] - others[None]
        return (gaps * gaps).sum(axis=-1).min() < distance * distance

    while len(tree.balls) < number:
        parent = int(g.randint(len(tree.balls)))
        (start, start_radius), radius = tree.balls[parent], float(g.uniform(0.7, 1.0))
        direction, gap, thin = g.uniform(-1, 1, 3), float(g.uniform(0.8, 1.6)), float(g.uniform(0.25, 0.45))
        size = math.sqrt((direction * direction).sum())
        if not 0.2 < size < 1:
            continue
        direction /= size
        centre = start + direction * (start_radius + gap + radius)
        rod = start + direction * (start_radius + np.linspace(0, gap, 9))[:, None]
        if any(is_near(centre[None], c[None], radius + r + 0.5) or k != parent and is_near(rod, c[None], r + 1.0)
               for k, (c, r) in enumerate(tree.balls)):
            continue
        if any(is_near(rod, other, 1.2) or is_near(centre[None], other, radius + 1.0) for other in between):
            continue
        tree.join(start, centre, thin + 0.2, thin)
        tree.balls.append((centre, radius))
        between.append(rod)
    return tree


def tree(g, i, step=0.22, number=None):
    field = grown_tree(g, number or 4 + i)
    mesh = isosurface(field, *field.box(1.3), step)
    return mesh, field.places(mesh, "object"), BALL


def pores(g, i):
    """A block with chambers inside that are joined by throats: the places choke what is not solid."""
    void = grown_tree(g, 4 + i)
    chambers = isosurface(void, *void.box(1.3), 0.22)
    lower, upper = void.box(2.0)
    block = voxel_surface([(0, 0, 0)])
    mesh = Mesh(np.concatenate([chambers.points, lower + block.points * (upper - lower)]),
                np.concatenate([chambers.faces[:, ::-1], block.faces + len(chambers.points)]))
    return mesh, void.places(mesh, "complement"), Topology(2, 0, 0)


def lattice(g, i):
    """Balls on a cubic grid with struts along its edges, of genus up to 50; a few struts are missing, but never one
    that holds the rest together."""
    shape = ((2, 2, 2), (2, 2, 3), (2, 3, 3), (3, 3, 3), (3, 3, 4))[i % 5]
    nodes = list(np.ndindex(*shape))
    struts = [(a, tuple(c + (k == axis) for k, c in enumerate(a))) for a in nodes for axis in range(3)
              if a[axis] + 1 < shape[axis]]
    for k in sorted(g.permutation(len(struts))[: i // 5 + len(struts) // 12].tolist(), reverse=True):
        rest = struts[:k] + struts[k + 1:]
        if is_connected(nodes, rest):
            struts = rest
    field = Balls_and_rods()
    for node in nodes:
        field.balls.append((2.4 * np.array(node, float), float(g.uniform(0.6, 0.75))))
    for a, b in struts:
        thin = float(g.uniform(0.24, 0.38))
        field.join(2.4 * np.array(a, float), 2.4 * np.array(b, float), thin + 0.15, thin)
    mesh = isosurface(field, *field.box(1.0), 0.22)
    return mesh, field.places(mesh, "object"), Topology(1, len(struts) - len(nodes) + 1, 0)


def is_connected(nodes, edges):
    reached, border = {nodes[0]}, [nodes[0]]
    while border:
        node = border.pop()
        for a, b in edges:
            for other in ((b,) if a == node else (a,) if b == node else ()):
                if other not in reached:
                    reached.add(other)
                    border.append(other)
    return len(reached) == len(nodes)


def vessel(g, i, step=0.2):
    """Chambers in a row, joined by stenoses, with inlets that are narrow too and end, flared, in the sides of a box: an
    open surface."""
    chambers = 1 + i % 4
    field = Balls_and_rods()
    lower, upper = np.array([-3.0, -3.0, -3.0]), np.array([4.4 * (chambers - 1) + 3.0, 3.0, 3.0])
    centres = [np.array([4.4 * k, g.uniform(-0.3, 0.3), g.uniform(-0.3, 0.3)]) for k in range(chambers)]
    for centre in centres:
        field.balls.append((centre, float(g.uniform(1.1, 1.35))))
    for a, b in zip(centres, centres[1:]):
        thin = float(g.uniform(0.25, 0.5))
        field.join(a, b, thin + 0.35, thin)
    ways = [(0, np.array([-1.0, 0, 0])), (chambers - 1, np.array([1.0, 0, 0]))]
    for k in range(chambers):
        for direction in (np.array([0, 1.0, 0]), np.array([0, -1.0, 0]), np.array([0, 0, 1.0]), np.array([0, 0, -1.0])):
            if g.uniform() < 0.5:
                ways.append((k, direction))
    for k, direction in ways:
        # to a point beyond the side of the box, so that the side cuts the tube where it widens
        thin = float(g.uniform(0.25, 0.45))
        aside = g.uniform(-0.3, 0.3, 3) * (direction == 0)
        end = np.where(direction == 0, centres[k] + aside, direction * 3.4 + (4.4 * k) * np.abs(direction[0]))
        field.join(centres[k], end, thin + 0.45, thin)
    mesh = isosurface(field, lower, upper, step)
    return mesh, field.places(mesh, "object"), Topology(1, 0, len(ways))


# ---- Bodies without a narrow place --------------------------------------------------------------------------------


def convex(g, i):
    """Ellipsoids, prisms and cones: none of them has a closed geodesic that is held."""
    n, kind = int(g.choice(SIDES)), i % 3
    if kind == 0:
        rows = int(g.randint(5, 30))
        profile = [(math.sin(math.pi * (k + 1) / (rows + 1)), -math.cos(math.pi * (k + 1) / (rows + 1)))
                   for k in range(rows)]
    elif kind == 1:
        profile = [(1, 0), (1, 1), (1, 2)]
    else:
        profile = [(1, 0), (0.7, 0.6), (0.2, 1.6)]
    mesh = lathe(n, profile, "caps")
    return Mesh(mesh.points * g.uniform(0.4, 2.0, 3), mesh.faces), [], BALL


# ---- Large bodies -------------------------------------------------------------------------------------------------


def large(g, i):
    """Bodies of 100,000 to a million faces."""
    if i == 0:
        return vessel(g, 1, step=0.075)
    if i == 1:
        return bone(g, 0, rows=700, sides=215)
    return chain(g, 0, rows=700, sides=180)


# ---- The set ------------------------------------------------------------------------------------------------------

# name: function, number of bodies, treatments
FAMILIES = {
    "bores": (bore, 20, TREATMENTS),
    "counterbores": (counterbore, 20, TREATMENTS),
    "straight necks": (straight_neck, 20, TREATMENTS),
    "grooves": (grooves, 10, TREATMENTS),
    "shallow necks": (shallow_necks, 10, TREATMENTS),
    "boxes with a tube": (boxes_with_tube, 20, TREATMENTS),
    "voxel dumbbells": (voxel_dumbbell, 4, ("plain", "rotated")),
    "voxel rooms": (voxel_rooms, 8, ("plain", "rotated moved float")),
    "plates with holes": (plate, 10, TREATMENTS),
    "ladders": (ladder, 6, TREATMENTS),
    "chains": (chain, 8, TREATMENTS),
    "knots": (knot, 5, TREATMENTS),
    "bones with noise": (bone, 9, TREATMENTS[:4]),
    "threads": (thread, 11, TREATMENTS),
    "trees": (tree, 8, TREATMENTS),
    "pores": (pores, 5, TREATMENTS),
    "lattices": (lattice, 5, TREATMENTS),
    "vessels": (vessel, 6, TREATMENTS),
    "large": (large, 3, ("rotated",)),
    "convex": (convex, 12, ("plain",)),
}


def rotation(g):
    """A random rotation, by a quaternion."""
    while True:
        q = g.uniform(-1, 1, 4)
        size = (q * q).sum()
        if 0.1 < size < 1:
            break
    w, x, y, z = q / math.sqrt(size)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def treated(mesh, places, treatment, g):
    """The body as somebody's file has it: rotated, moved, rounded to floats, or with a noise of a thousandth of the
    radius of its narrowest place."""
    turn = rotation(g) if "rotated" in treatment else np.eye(3)
    shift = g.uniform(-20, 20, 3) if "moved" in treatment else np.zeros(3)

    def move(points):
        # sums are written out, as those of libraries depend on the processor
        return np.stack([points[..., 0] * r[0] + points[..., 1] * r[1] + points[..., 2] * r[2] + s
                         for r, s in zip(turn, shift)], -1)

    points = move(mesh.points)
    if "noise" in treatment:
        least = min(known_length(mesh, place) for place in places)
        points = points + g.uniform(-1, 1, points.shape) * (1e-3 * least / (2 * math.pi))
    if "float" in treatment:
        points = points.astype(np.float32).astype(float)
    return Mesh(points, mesh.faces), [place._replace(axis=move(place.axis)) for place in places]


def known_length(mesh, place):
    """Of the longest of the loops of a place."""
    return max(length(positions(mesh, loop)) for loop in place.loops)


def body(family, number, seed=SEED):
    """One body of the set; always the same for the same seed."""
    make, _, treatments = FAMILIES[family]
    g = np.random.RandomState([seed, zlib.crc32(family.encode()), number])
    mesh, places, topology = make(g, number)
    treatment = treatments[number % len(treatments)]
    mesh, places = treated(mesh, places, treatment, g)
    return Body(family, f"{family.replace(' ', '_')}_{number:02}", treatment, mesh, places, topology)


# of families whose bodies take longer: how many of them are in the small part of the set
QUICK = {"voxel dumbbells": 1, "knots": 2, "trees": 2, "pores": 2, "lattices": 1, "vessels": 2, "large": 0}


def quick_numbers(family):
    """Numbers of the bodies of a small part of the set: the first ones, of most families one for each treatment."""
    _, count, treatments = FAMILIES[family]
    return range(QUICK.get(family, min(count, max(2, len(treatments)))))
