# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The tips of limbs of triangle meshes, without the program that is measured on them."""

import heapq
import math


def read_off(path):
    """(points, triangles)"""
    lines = (line.split("#")[0] for line in path.read_text(encoding="utf-8").splitlines())
    words = " ".join(lines).split()
    count, faces = int(words[1]), int(words[2])
    numbers = [float(word) for word in words[4:4 + 3 * count]]
    corners = [int(word) for word in words[4 + 3 * count:4 + 3 * count + 4 * faces]]
    return list(zip(*[iter(numbers)] * 3)), [tuple(corners[4 * f + 1:4 * f + 4]) for f in range(faces)]


def write_ply(path, points, faces, weights):
    """With the weights as a property of vertices."""
    head = ["ply", "format ascii 1.0", f"element vertex {len(weights)}",
            *(f"property double {name}" for name in ("x", "y", "z", "weight")),
            f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    rows = [" ".join(map(repr, (*p, w))) for p, w in zip(points, weights)]
    path.write_text("\n".join(head + rows + ["3 {} {} {}".format(*face) for face in faces]) + "\n",
                    encoding="utf-8")


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.hypot(*a) for x in a]


def area(points, faces):
    def arm(a, b):
        return [x - y for x, y in zip(points[b], points[a])]
    return sum(math.hypot(*cross(arm(a, b), arm(a, c))) for a, b, c in faces) / 2


def distances(points, neighbours, start):
    """Along edges; infinity where there is no way."""
    found, queue = [math.inf] * len(points), [(0, start)]
    while queue:
        distance, v = heapq.heappop(queue)
        if distance >= found[v]:
            continue
        found[v] = distance
        for w in neighbours[v]:
            heapq.heappush(queue, (distance + math.dist(points[v], points[w]), w))
    return found


def tips(points, faces, count):
    """So many vertices: the farthest from the one in the middle, and each next as far as possible from
    those before."""
    neighbours = [set() for _ in points]
    for face in faces:
        for v in face:
            neighbours[v].update(face)
    mean = [sum(axis) / len(points) for axis in zip(*points)]
    middle = min(range(len(points)), key=lambda v: math.dist(points[v], mean))
    nearest, found = distances(points, neighbours, middle), []
    while len(found) < count:
        found.append(max((v for v in range(len(points)) if nearest[v] < math.inf), key=nearest.__getitem__))
        nearest = list(map(min, nearest, distances(points, neighbours, found[-1])))
    return found
