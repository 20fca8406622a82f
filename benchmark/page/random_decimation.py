# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Takes vertices off a closed triangle mesh at random: what remains lies on the same surface, but
in triangles as bad as chance makes them."""

import math
import random
from collections import defaultdict

from page.loop_subdivision import read_off, write_off

REFUSALS = 8  # in a row, for each vertex that is left
GREATEST_TURN = 20  # degrees, from the normals of the surface to that of a face


def area_vector(a, b, c):
    u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def cosine(u, v):
    norms = math.hypot(*u) * math.hypot(*v)
    return sum(x * y for x, y in zip(u, v)) / norms if norms > 0 else -1


def least_cosine(triangle):
    """Of the greatest angle."""
    edges = [[triangle[i - 2][k] - triangle[i][k] for k in range(3)] for i in range(3)]
    return min(-cosine(edges[i], edges[i - 1]) for i in range(3))


class Decimation:
    """A mesh whose edges collapse into one of their ends."""

    def __init__(self, points, faces, greatest_angle, greatest_turn):
        self.least_cosine = math.cos(math.radians(greatest_angle))
        self.turn = math.cos(math.radians(greatest_turn))
        self.points, self.faces = points, {f: list(face) for f, face in enumerate(faces)}
        self.around = defaultdict(set)
        self.normals = defaultdict(lambda: [0, 0, 0])  # at the vertices, of the surface before
        for f, face in self.faces.items():
            normal = area_vector(*(points[v] for v in face))
            for v in face:
                self.around[v].add(f)
                self.normals[v] = [x + y for x, y in zip(self.normals[v], normal)]

    def neighbours(self, v):
        return {u for f in self.around[v] for u in self.faces[f]} - {v}

    def may_collapse(self, v, u):
        """Whether v may go to u: faces still look as the surface does, which remains one."""
        if len(self.neighbours(v) & self.neighbours(u)) != 2:
            return False
        for f in self.around[v] - self.around[u]:
            corners = [u if w == v else w for w in self.faces[f]]
            triangle = [self.points[w] for w in corners]
            normal = area_vector(*triangle)
            if least_cosine(triangle) < self.least_cosine:
                return False
            if min(cosine(normal, self.normals[w]) for w in corners) < self.turn:
                return False
        return True

    def collapse(self, v, u):
        for f in self.around.pop(v):
            if u in self.faces[f]:
                for w in self.faces.pop(f):
                    if w != v:
                        self.around[w].discard(f)
            else:
                self.faces[f] = [u if w == v else w for w in self.faces[f]]
                self.around[u].add(f)

    def result(self):
        number = {v: i for i, v in enumerate(sorted(self.around))}
        return ([self.points[v] for v in number],
                [tuple(number[v] for v in self.faces[f]) for f in sorted(self.faces)])


def decimated(points, faces, wanted, greatest_angle=180, seed=1, greatest_turn=GREATEST_TURN):
    """So many faces, or the least that can be found, none with a greater angle in degrees; the same for the same
    seed."""
    chance, mesh = random.Random(seed), Decimation(points, faces, greatest_angle, greatest_turn)
    vertices, refused = list(range(len(points))), 0
    while len(mesh.faces) > wanted and refused < REFUSALS * len(vertices):
        i = chance.randrange(len(vertices))
        v = vertices[i]
        u = chance.choice(sorted(mesh.neighbours(v)))
        refused += 1
        if mesh.may_collapse(v, u):
            refused = 0
            mesh.collapse(v, u)
            vertices[i] = vertices[-1]
            vertices.pop()
    return mesh.result()


def decimate(source, target, wanted, greatest_angle=180):
    write_off(target, *decimated(*read_off(source), wanted, greatest_angle))
