# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Meshes for the tests of the module, as arrays V and F."""

import numpy as np

GOLDEN = (1 + 5 ** .5) / 2
ICOSAHEDRON = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
               (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
               (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]


def icosphere(levels, noise=0.):
    """The unit sphere with 20 * 4^levels faces, and its vertices moved by up to the noise."""
    V = [(s, t * GOLDEN, 0) for t in (1, -1) for s in (-1, 1)]
    V = [tuple(np.roll(v, k)) for k in range(3) for v in V]
    V, F = [np.array(v) / np.linalg.norm(v) for v in V], ICOSAHEDRON
    for _ in range(levels):
        middles, finer = {}, []

        def middle(a, b):
            edge = min(a, b), max(a, b)
            if edge not in middles:
                middles[edge] = len(V)
                V.append((V[a] + V[b]) / np.linalg.norm(V[a] + V[b]))
            return middles[edge]

        for a, b, c in F:
            x, y, z = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
        F = finer
    random = np.random.default_rng(7)
    V = np.array(V)
    return V + noise * random.uniform(-1, 1, V.shape), np.array(F)


def grid_faces(rows, columns, is_closed):
    def at(i, j):
        return i % rows * columns + j % columns

    size = (rows, columns) if is_closed else (rows - 1, columns - 1)
    return np.array([face for i in range(size[0]) for j in range(size[1])
                     for face in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)),
                                  (at(i, j), at(i + 1, j + 1), at(i, j + 1)))])


def torus(rows, columns, radius=2.):
    a, b = np.meshgrid(2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns,
                       indexing="ij")
    r = radius + np.cos(b)
    V = np.stack([r * np.cos(a), r * np.sin(a), np.sin(b)], axis=-1).reshape(-1, 3)
    return V, grid_faces(rows, columns, True)


def patch(size, noise=0.):
    """A bent square."""
    x, y = np.meshgrid(np.linspace(-1, 1, size), np.linspace(-1, 1, size), indexing="ij")
    V = np.stack([x, y, .3 * x * x - .2 * x * y], axis=-1).reshape(-1, 3)
    random = np.random.default_rng(3)
    return V + noise / size * random.uniform(-1, 1, V.shape), grid_faces(size, size, False)


def write_ply(path, V, F, **values):
    """With doubles, and one property of the vertices for each of the values."""
    names = "".join(f"property double {name}\n" for name in ("x", "y", "z", *values))
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(V)}\n{names}"
            f"element face {len(F)}\nproperty list uchar int vertex_indices\nend_header\n")
    faces = np.zeros(len(F), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, F
    columns = np.column_stack([V, *values.values()]).astype("<f8")
    path.write_bytes(head.encode() + columns.tobytes() + faces.tobytes())
