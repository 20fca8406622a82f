# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A bumpy sphere, and the same with one kind of damage each, as meshes in files have it."""

import math

OCTAHEDRON = ([(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1)],
              [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5),
               (0, 4, 5)])


def between(p, q, s=0.5):
    return tuple((1 - s) * x + s * y for x, y in zip(p, q))


def refined(points, faces):
    points, finer, middle = list(points), [], {}

    def add(a, b):
        key = min(a, b), max(a, b)
        if key not in middle:
            middle[key] = len(points)
            points.append(between(points[a], points[b]))
        return middle[key]
    for a, b, c in faces:
        ab, bc, ca = add(a, b), add(b, c), add(c, a)
        finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return points, finer


def bumpy(point):
    norm = math.sqrt(sum(x * x for x in point))
    x, y, z = (c / norm for c in point)
    r = 1 + 0.1 * math.sin(3 * x + 1) * math.cos(2 * y) + 0.1 * math.sin(2 * z + x)
    return x * r, y * r, z * r


def used(points, faces):
    """Without the vertices that no face has."""
    kept = sorted({v for face in faces for v in face})
    number = {v: i for i, v in enumerate(kept)}
    return [points[v] for v in kept], [tuple(number[v] for v in face) for face in faces]


def sphere(level=4):
    points, faces = OCTAHEDRON
    for _ in range(level):
        points, faces = refined(points, faces)
    return [bumpy(p) for p in points], faces


def split_on_one_side(points, faces, which, share):
    """A vertex on an edge of these faces, so that a face without area lies at their neighbour."""
    for f in which:
        a, b, c = faces[f]
        n = len(points)
        points.append(between(points[a], points[b], share))
        faces[f] = (a, n, c)
        faces += [(n, b, c), (a, b, n)]


def caps():
    points, faces = sphere()
    split_on_one_side(points, faces, range(0, 1000, 20), 0.3)
    return points, faces


def row_of_caps():
    """Each splits an edge of the one before."""
    points, faces = sphere()
    for _ in range(20):
        split_on_one_side(points, faces, [0], 0.7)
    return points, faces


def needles():
    points, faces = sphere()
    split_on_one_side(points, faces, range(0, 1000, 20), 1e-14)
    return points, faces


def slivers(degrees):
    """Both sides of an edge are split next to it, so that faces are thin but have an area."""
    points, faces = sphere()
    for f in range(0, 1000, 20):
        a, b, c = faces[f]
        n, height = len(points), math.radians(degrees) / 2
        points.append(between(between(points[a], points[b]), points[c], height))
        faces[f] = (a, n, c)
        faces += [(n, b, c), (a, b, n)]
    return points, faces


def open_with_caps():
    """They lie outside the boundary, at every edge of a part of it."""
    points, faces = sphere()
    points, faces = used(points, [face for face in faces if min(points[v][2] for v in face) > -0.3])
    edges = {(face[k - 1], face[k]) for face in faces for k in range(3)}
    for a, b in sorted(edge for edge in edges if edge[::-1] not in edges)[:10]:
        n = len(points)
        points.append(between(points[a], points[b]))
        faces.append((b, a, n))
    return points, faces


def soup():
    points, faces = sphere()
    return ([points[v] for face in faces for v in face],
            [(3 * f, 3 * f + 1, 3 * f + 2) for f in range(len(faces))])


def repeated():
    points, faces = sphere()
    return points, faces + faces[:10] + [(c, b, a) for a, b, c in faces[10:20]]


def unused():
    points, faces = sphere()
    return [(5., 5., 5.), *points, (6., 6., 6.)], [tuple(v + 1 for v in face) for face in faces]


def turned():
    points, faces = sphere()
    return points, [face if f % 3 else face[::-1] for f, face in enumerate(faces)]


def fin():
    """A third face at an edge."""
    points, faces = sphere()
    a, b, _ = faces[7]
    return points + [tuple(2 * x for x in points[a])], faces + [(a, b, len(points))]


def two_fans():
    """Two vertices far from each other become one."""
    points, faces = sphere()
    last = faces[-1][0]
    return used(points, [tuple(faces[0][0] if v == last else v for v in face) for face in faces])


def moebius(n=40, m=6):
    points, faces = [], []
    for i in range(n):
        u = 2 * math.pi * i / n
        for j in range(m):
            s = 0.6 * (j / (m - 1) - 0.5)
            r = 1 + s * math.cos(u / 2)
            points.append((r * math.cos(u), r * math.sin(u), s * math.sin(u / 2)))
    for i in range(n):
        for j in range(m - 1):
            ahead = [(i + 1) * m + j, (i + 1) * m + j + 1]
            if i + 1 == n:
                ahead = [m - 1 - j, m - 2 - j]
            faces += [(i * m + j, ahead[0], i * m + j + 1), (i * m + j + 1, ahead[0], ahead[1])]
    return points, faces


def two_spheres():
    points, faces = sphere()
    n = len(points)
    return (points + [(x + 4, y, z) for x, y, z in points],
            faces + [tuple(v + n for v in face) for face in faces])


def flat_tetrahedron():
    return ([(0, 0, 0), (3, 0, 0), (1, 0, 0), (0, 2, 0)],
            [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)])


MESHES = {
    "nothing": sphere,
    "50 caps: a vertex on an edge of the neighbour": caps,
    "a row of 20 caps, one at the other": row_of_caps,
    "10 caps at the boundary": open_with_caps,
    "50 needles of 1e-14 of an edge": needles,
    "slivers of 1 degree": lambda: slivers(1),
    "slivers of 1e-3 degrees": lambda: slivers(1e-3),
    "slivers of 1e-6 degrees": lambda: slivers(1e-6),
    "slivers of 1e-9 degrees": lambda: slivers(1e-9),
    "slivers of 1e-12 degrees": lambda: slivers(1e-12),
    "each face has its own vertices": soup,
    "10 faces twice, 10 also turned around": repeated,
    "vertices without a face": unused,
    "every third face turned around": turned,
    "a fin: three faces at an edge": fin,
    "two fans at a vertex": two_fans,
    "a Moebius strip": moebius,
    "two components": two_spheres,
    "a flat tetrahedron": flat_tetrahedron,
}
