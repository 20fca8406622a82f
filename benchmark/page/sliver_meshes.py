# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Closed meshes with thin faces as other programs make them: isosurfaces by marching tetrahedra,
decimation without regard to shape, and coordinates rounded to a grid."""

import itertools
import math

from page.loop_subdivision import read_off, write_off
from page.random_decimation import area_vector, cosine, decimated

FIELDS = {
    "blob": lambda x, y, z: math.hypot(x, y, z) - (
        0.7 + 0.12 * math.sin(5 * x) * math.cos(4 * y) + 0.1 * math.sin(6 * z)),
    "ellipsoid": lambda x, y, z: math.sqrt(x * x / 0.8 + y * y / 0.3 + z * z / 0.15) - 1
    + 0.08 * math.sin(7 * x) * math.cos(6 * y),
    "cushion": lambda x, y, z: x ** 4 + y ** 4 + z ** 4 - 0.4 + 0.05 * math.sin(6 * x + 4 * y),
    "torus": lambda x, y, z: math.hypot(math.hypot(x, y) - 0.6, z) - (
        0.22 + 0.04 * math.sin(5 * x + 1) * math.cos(4 * z + y)),
    "two_holes": lambda x, y, z: (2.56 * x * x * (1 - 2.56 * x * x) - 2.56 * y * y) ** 2
    + 1.536 * z * z - 0.02,
}
GRIDS = (13, 17, 22, 27)
DECIMATED = {"oblong": 0.5, "elephant": 0.4, "blobby": 0.3, "rotor": 0.6, "couplingdown": 0.6, "eight": 0.5,
             "knot1": 0.5, "ellipsoid": 0.6}
SEEDS = (1, 2, 3)
TURN = 70  # degrees
SNAPPED = {"oblong": 0.06, "blobby": 0.02, "ellipsoid": 0.06, "elephant": 0.01, "eight": 0.03, "homer": 0.01,
           "couplingdown": 0.02}
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]


def less(p, q):
    return tuple(a - b for a, b in zip(p, q))


def normal(points, face):
    return area_vector(*(points[v] for v in face))


class Isosurface:
    """Where a function changes its sign, on a grid of n^3 points of [-1, 1]^3."""

    def __init__(self, function, n):
        ticks = [-1.0001 + 2.0001 * i / (n - 1) for i in range(n)]
        self.at = {g: tuple(ticks[i] for i in g) for g in itertools.product(range(n), repeat=3)}
        self.value = {g: function(*p) for g, p in self.at.items()}
        self.points, self.faces, self.number = [], [], {}
        for corner in itertools.product(range(n - 1), repeat=3):
            cube = [tuple(a + b for a, b in zip(corner, c)) for c in CUBE]
            if len({self.value[g] < 0 for g in cube}) > 1:
                for tetrahedron in TETRAHEDRA:
                    self.cut([cube[k] for k in tetrahedron])

    def crossing(self, a, b):
        a, b = min(a, b), max(a, b)
        if (a, b) not in self.number:
            t = self.value[a] / (self.value[a] - self.value[b])
            self.number[a, b] = len(self.points)
            self.points.append(tuple((1 - t) * p + t * q for p, q in zip(self.at[a], self.at[b])))
        return self.number[a, b]

    def cut(self, tetrahedron):
        inside = [g for g in tetrahedron if self.value[g] < 0]
        outside = [g for g in tetrahedron if self.value[g] >= 0]
        if not inside or not outside:
            return
        pairs = list(itertools.product(inside, outside))
        ring = [self.crossing(*pair) for pair in (pairs if len(pairs) == 3 else [pairs[k] for k in (0, 1, 3, 2)])]
        out = less([sum(c) / len(outside) for c in zip(*(self.at[g] for g in outside))],
                   [sum(c) / len(inside) for c in zip(*(self.at[g] for g in inside))])
        for face in [tuple(ring[:3]), (ring[0], *ring[2:])][:len(ring) - 2]:
            is_outward = cosine(normal(self.points, face), out) > 0
            self.faces.append(face if is_outward else face[::-1])


def snapped(points, faces, share):
    """Rounded to a grid of that share of the extent; where a face would turn over or vanish, less."""
    step = share * max(max(c) - min(c) for c in zip(*points))
    moved = [tuple(step * round(x / step) for x in p) for p in points]
    for _ in range(60):
        bad = {v for face in faces for v in face if not keeps(normal(points, face), normal(moved, face))}
        if not bad:
            break
        for v in bad:
            moved[v] = tuple(0.7 * p + 0.3 * q for p, q in zip(points[v], moved[v]))
    return moved, faces


def keeps(before, after):
    """Whether a face has kept its side and a fiftieth of its area."""
    return cosine(before, after) > 0 and math.hypot(*after) > 0.02 * math.hypot(*before)


def make(folder, data):
    """Writes them; `data` has the meshes of CGAL."""
    folder.mkdir(parents=True, exist_ok=True)
    for (name, function), n in itertools.product(FIELDS.items(), GRIDS):
        surface = Isosurface(function, n)
        write_off(folder / f"marched_{name}_{n}.off", surface.points, surface.faces)
    for (name, share), seed in itertools.product(DECIMATED.items(), SEEDS):
        points, faces = read_off(data / f"{name}.off")
        fewer = decimated(points, faces, int(share * len(faces)), seed=seed, greatest_turn=TURN)
        write_off(folder / f"decimated_{name}_{seed}.off", *fewer)
    for name, share in SNAPPED.items():
        write_off(folder / f"snapped_{name}.off", *snapped(*read_off(data / f"{name}.off"), share))
