# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""One step of Loop's subdivision of a closed triangle mesh, from OFF file to OFF file."""

import math
from collections import defaultdict


def read_off(path):
    words = path.read_text(encoding="utf-8").split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = iter(words[4:])
    points = [tuple(float(next(numbers)) for _ in range(3)) for _ in range(vertices)]
    return points, [tuple(int(next(numbers)) for _ in range(int(next(numbers))))
                    for _ in range(faces)]


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [f"{x:.17g} {y:.17g} {z:.17g}" for x, y, z in points]
    lines += [f"3 {a} {b} {c}" for a, b, c in faces]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def combination(*terms):
    return tuple(sum(weight * point[i] for weight, point in terms) for i in range(3))


def subdivided(points, faces):
    """Vertices keep their numbers; those of edges follow."""
    neighbours, opposite = defaultdict(set), defaultdict(list)
    for face in faces:
        for i in range(3):
            a, b, c = face[i], face[(i + 1) % 3], face[(i + 2) % 3]
            opposite[min(a, b), max(a, b)].append(c)
            neighbours[a] |= {b, c}
    result, number = [], {}
    for v, point in enumerate(points):
        k = len(neighbours[v])
        beta = (5 / 8 - (3 / 8 + math.cos(2 * math.pi / k) / 4) ** 2) / k
        result.append(combination((1 - k * beta, point),
                                  *((beta, points[u]) for u in sorted(neighbours[v]))))
    for (a, b), (c, d) in opposite.items():
        number[a, b] = number[b, a] = len(result)
        result.append(combination((3 / 8, points[a]), (3 / 8, points[b]),
                                  (1 / 8, points[c]), (1 / 8, points[d])))
    finer = []
    for a, b, c in faces:
        ab, bc, ca = number[a, b], number[b, c], number[c, a]
        finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return result, finer


def subdivide(source, target):
    write_off(target, *subdivided(*read_off(source)))
