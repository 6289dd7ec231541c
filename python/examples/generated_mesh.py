# SPDX-License-Identifier: GPL-3.0-or-later
"""The waist of a body of revolution, from arrays alone."""

import numpy as np

import constrictions

around, rings = 24, 21
height = np.linspace(-1, 1, rings)
radius = (1.1 - height**2) * (0.2 + height**2)
angle = 2 * np.pi * np.arange(around) / around
x, y = np.outer(radius, np.cos(angle)), np.outer(radius, np.sin(angle))
z = np.repeat(height, around).reshape(rings, around)
V = np.concatenate([np.stack([x, y, z], -1).reshape(-1, 3), [[0, 0, -1.1], [0, 0, 1.1]]])

a = np.arange(rings * around).reshape(rings, around)  # counterclockwise around the axis
b = np.roll(a, -1, axis=1)
quads = a[:-1], b[:-1], b[1:], a[1:]
bottom, top = np.full(around, len(V) - 2), np.full(around, len(V) - 1)
triangles = [quads[:3], (quads[0], *quads[2:]), (bottom, b[0], a[0]), (top, a[-1], b[-1])]
F = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in triangles])

for c in constrictions.Surface(V, F).detect():
    print(f"length {c.length:.3f}, {c.certificate}, through {len(c.pivots)} vertices")
# prints: length 1.378, strict_constriction, through 24 vertices
