# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Surfaces with many loops, or many handles, as points and faces."""

import itertools
import math
import random


def sphere(level):
    """An octahedron, subdivided."""
    points = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    for _ in range(level):
        middles, finer = {}, []

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                middles[key] = len(points)
                sums = [x + y for x, y in zip(points[a], points[b])]
                points.append(tuple(x / math.hypot(*sums) for x in sums))
            return middles[key]

        for a, b, c in faces:
            d, e, f = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = finer
    return points, faces


def punctured_sphere(level, loops):
    """Without so many of its faces, no two of which share a vertex."""
    points, faces = sphere(level)
    taken, left_out = set(), set()
    for f in random.Random(1).sample(range(len(faces)), len(faces)):
        if len(left_out) < loops and taken.isdisjoint(faces[f]):
            left_out.add(f)
            taken.update(faces[f])
    if len(left_out) < loops:
        raise ValueError(f"no room for {loops} loops")
    return points, [face for f, face in enumerate(faces) if f not in left_out]


def slab(handles):
    """A flat slab of cubes with so many square holes in rows, smoothed: of that genus."""
    per_row = max(1, math.ceil(math.sqrt(handles)))
    rows = max(1, math.ceil(handles / per_row))
    solid = set(itertools.product(range(4 * per_row + 2), range(4 * rows + 2), range(2)))
    for hole in range(handles):
        i, j = 4 * (hole % per_row) + 2, 4 * (hole // per_row) + 2
        solid -= set(itertools.product((i, i + 1), (j, j + 1), range(2)))
    numbers, faces = {}, []
    for cube, axis, side in itertools.product(sorted(solid), range(3), (0, 1)):
        outer = list(cube)
        outer[axis] += 1 if side else -1
        if tuple(outer) in solid:
            continue
        corner = list(cube)
        corner[axis] += side
        square = []
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            place = list(corner)
            place[(axis + 1) % 3] += u
            place[(axis + 2) % 3] += v
            square.append(numbers.setdefault(tuple(place), len(numbers)))
        if not side:
            square.reverse()
        if sum(corner) % 2:
            square = square[1:] + square[:1]
        faces += [tuple(square[k] for k in (0, 1, 2)), tuple(square[k] for k in (0, 2, 3))]
    return smoothed([list(map(float, place)) for place in numbers], faces), faces


def smoothed(points, faces, rounds=6):
    around = [set() for _ in points]
    for face in faces:
        for v in face:
            around[v].update(w for w in face if w != v)
    for _ in range(rounds):
        points = [[(x + sum(points[w][k] for w in around[v]) / len(around[v])) / 2 for k, x in enumerate(point)]
                  for v, point in enumerate(points)]
    return points


def write_off(path, points, faces):
    path.write_text(f"OFF\n{len(points)} {len(faces)} 0\n"
                    + "".join("%.17g %.17g %.17g\n" % tuple(point) for point in points)
                    + "".join("3 %d %d %d\n" % face for face in faces), encoding="ascii")
