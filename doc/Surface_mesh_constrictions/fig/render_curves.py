#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_curves.py MESH.off CURVES.json|- OUT.png [--size 900] [--view X Y Z] [--up X Y Z]

Draws a mesh and the curves that `constrictions detect --json CURVES.json` found on it; or, with - for the curves, the
parts in the file parts.ply that `constrictions segment` writes. The pictures of the manual are made with it. Needs
numpy only."""
import argparse
import json
import struct
import zlib

import numpy as np


def read_off(name):
    rows = (line.split("#")[0].split() for line in open(name, errors="replace"))
    rows = [row for row in rows if row]
    rows = rows[1:] if len(rows[0]) == 1 else [rows[0][1:]] + rows[1:]
    nv, nf = int(rows[0][0]), int(rows[0][1])
    points = np.array([row[:3] for row in rows[1 : nv + 1]], float)
    faces = np.array([row[1:4] for row in rows[nv + 1 : nv + nf + 1]], int)
    return points, faces, np.tile([203.0, 208.0, 214.0], (len(faces), 1))


def read_parts(name):
    """Points, faces and colours of faces of a PLY file with the header that the program writes."""
    data = open(name, "rb").read()
    end = data.index(b"end_header\n") + len("end_header\n")
    counts = {line.split()[1]: int(line.split()[2]) for line in data[:end].decode().splitlines() if line[:7] == "element"}
    points = np.frombuffer(data, "<f8", 3 * counts["vertex"], end).reshape(-1, 3)
    face = np.dtype([("n", "u1"), ("corners", "<i4", 3), ("colour", "u1", 3), ("patch", "<i4")])
    faces = np.frombuffer(data, face, counts["face"], end + points.nbytes)
    return points, faces["corners"], faces["colour"].astype(float)


def write_png(name, image):
    height, width, _ = image.shape
    raw = b"".join(b"\0" + row.tobytes() for row in image)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(name, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        f.write(chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def camera(view, up):
    z = np.array(view, float)
    z /= np.linalg.norm(z)
    x = np.cross(up, z)
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


def splat(depth, colour, positions, values):
    """Writes samples (x, y, depth) with their colours where they are nearer than what is there."""
    height, width = depth.shape
    x, y = np.floor(positions[:, 0]).astype(int), np.floor(positions[:, 1]).astype(int)
    inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
    index, z, values = y[inside] * width + x[inside], positions[inside, 2], values[inside]
    order = np.argsort(z, kind="stable")
    index, z, values = index[order], z[order], values[order]
    nearest = np.full(width * height, -np.inf)
    nearest[index] = z
    last = np.full(width * height, -1)
    last[index] = np.arange(len(index))
    hit = last >= 0
    closer = hit & (nearest > depth.ravel())
    depth.ravel()[closer] = nearest[closer]
    colour.reshape(-1, 3)[closer] = values[last[closer]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("curves")
    parser.add_argument("out")
    parser.add_argument("--size", type=int, default=900)
    parser.add_argument("--view", type=float, nargs=3, default=(0.4, 0.25, 1.0))
    parser.add_argument("--up", type=float, nargs=3, default=(0.0, 1.0, 0.0))
    options = parser.parse_args()

    points, faces, tints = (read_parts if options.mesh.endswith(".ply") else read_off)(options.mesh)
    curves = []
    if options.curves != "-":
        curves = [np.array(c["points"], float) for c in json.load(open(options.curves))["constrictions"]]
    oversampling = 2
    size = options.size * oversampling
    frame = camera(options.view, options.up)
    flat = points @ frame.T
    low, high = flat.min(0), flat.max(0)
    scale = 0.94 * size / max(high[0] - low[0], high[1] - low[1])
    width, height = (int(np.ceil((high[i] - low[i]) * scale + 0.06 * size)) for i in (0, 1))

    def project(p):
        q = (p @ frame.T - (low + high) / 2) * scale
        return np.column_stack([width / 2 + q[:, 0], height / 2 - q[:, 1], q[:, 2]])

    depth = np.full((height, width), -np.inf)
    colour = np.full((height, width, 3), 255.0)

    corners = project(points)[faces]
    normals = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]]) @ frame.T
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    light = np.array([0.35, 0.45, 0.82])
    shade = 0.42 + 0.58 * np.abs(normals @ light)
    tint = tints * shade[:, None]
    extent = np.maximum(np.ptp(corners[:, :, 0], axis=1), np.ptp(corners[:, :, 1], axis=1))
    steps = np.maximum(1, np.ceil(extent * 1.3)).astype(int)
    samples_of_faces, colours_of_faces = [], []
    for n in np.unique(steps):
        chosen = np.flatnonzero(steps == n)
        i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
        keep = i + j <= n
        a, b = i[keep] / n, j[keep] / n
        weights = np.column_stack([1 - a - b, a, b])
        for part in np.array_split(chosen, max(1, len(chosen) * len(a) // 4000000)):
            samples_of_faces.append(np.einsum("sk,fkd->fsd", weights, corners[part]).reshape(-1, 3))
            colours_of_faces.append(np.repeat(tint[part], len(a), axis=0))
            if sum(map(len, samples_of_faces)) > 4000000:
                splat(depth, colour, np.vstack(samples_of_faces), np.vstack(colours_of_faces))
                samples_of_faces, colours_of_faces = [], []
    if samples_of_faces:
        splat(depth, colour, np.vstack(samples_of_faces), np.vstack(colours_of_faces))

    palette = np.array([[214, 39, 40], [31, 119, 180], [44, 140, 44], [230, 120, 20], [130, 80, 170], [0, 140, 150],
                        [200, 60, 140], [120, 90, 30]], float)
    radius = max(2.0, size / 420)
    disc = np.array([(u, v) for u in range(-8, 9) for v in range(-8, 9) if u * u + v * v <= radius * radius], float)
    brushes, colours = [], []
    for k, curve in enumerate(curves):
        q = project(curve)
        for p, r in zip(q, np.roll(q, -1, axis=0)):
            n = int(np.ceil(np.linalg.norm(r - p))) + 1
            brush = np.repeat(p + np.linspace(0, 1, n)[:, None] * (r - p), len(disc), axis=0)
            brush[:, :2] += np.tile(disc, (n, 1))
            brush[:, 2] += 3 * radius
            brushes.append(brush)
            colours.append(np.tile(palette[k % len(palette)], (len(brush), 1)))
    if brushes:
        splat(depth, colour, np.vstack(brushes), np.vstack(colours))

    height, width = height // oversampling * oversampling, width // oversampling * oversampling
    image = colour[:height, :width].reshape(height // oversampling, oversampling, width // oversampling, oversampling, 3)
    write_png(options.out, np.clip(image.mean((1, 3)), 0, 255).astype(np.uint8))


if __name__ == "__main__":
    main()
