# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A bumpy torus as a scanner sees it: irregular, with noise."""

import math
import random

from page.loop_subdivision import write_off


def point(u, v):
    tube = 0.4 * (1 + 0.25 * math.sin(3 * u + 2 * v) + 0.15 * math.cos(5 * u - 3 * v) + 0.1 * math.sin(9 * v + 7 * u))
    ring = 1 + tube * math.cos(v)
    return ring * math.cos(u), 0.8 * ring * math.sin(u), tube * math.sin(v) + 0.2 * math.sin(2 * u)


def make(path, rows):
    """Writes 4 rows^2 faces, with noise of 6 % of an edge, and diagonals at random."""
    columns, draw = 2 * rows, random.Random(1)
    du, dv = 2 * math.pi / columns, 2 * math.pi / rows
    noise = 0.06 * 0.4 * dv
    points = []
    for at in range(columns * rows):
        u, v = (at // rows + draw.uniform(-0.3, 0.3)) * du, (at % rows + draw.uniform(-0.3, 0.3)) * dv
        points.append(tuple(x + draw.gauss(0, noise) for x in point(u, v)))
    faces = []
    for i in range(columns):
        for j in range(rows):
            a, b, c, d = ((k % columns) * rows + l % rows for k, l in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            faces += [(a, b, c), (a, c, d)] if draw.random() < 0.5 else [(a, b, d), (b, c, d)]
    write_off(path, points, faces)
    return path
