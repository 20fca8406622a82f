# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Where vesicles begin: surfaces of revolution of a given reduced volume, with triangles of about one size, that
a sixth of a turn does not change."""

import math


def spheroid(flatness):
    """A profile from the upper pole to the lower one: (distance from the axis, height)."""
    return [(math.sin(t), math.cos(t) / flatness) for t in arc(0, math.pi)]


def capsule(length):
    upper = [(math.sin(t), length / 2 + math.cos(t)) for t in arc(0, math.pi / 2)]
    return upper + [(r, -z) for r, z in reversed(upper)]


def bowl(inner, opening=.6):
    """Parts of two spheres around one centre, joined by a rim around an opening below."""
    end, tube = math.pi - opening, (1 - inner) / 2
    outer = [(math.sin(t), math.cos(t)) for t in arc(0, end)]
    rim = [((1 - tube) * r + tube * math.sin(t), (1 - tube) * z + tube * math.cos(t))
           for r, z in outer[-1:] for t in arc(end, end + math.pi)]
    return outer + rim + [(inner * r, inner * z) for r, z in reversed(outer)]


FAMILIES = {"prolate": (capsule, 0, 40), "oblate": (spheroid, 1, 50), "stomatocyte": (bowl, .1, .9)}


def arc(begin, end, count=500):
    return [begin + (end - begin) * i / count for i in range(count + 1)]


def reduced(profile):
    area = volume = 0
    for (r, z), (q, y) in zip(profile, profile[1:]):
        area += math.pi * (r + q) * math.dist((r, z), (q, y))
        volume += math.pi * (r * r + r * q + q * q) / 3 * (z - y)
    return 6 * math.sqrt(math.pi) * volume / area ** 1.5


def profile_of(branch, volume):
    family, low, high = FAMILIES[branch]
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if reduced(family(middle)) > volume else (low, middle)
    return family(low)


def even(profile, count):
    """Points of a profile at count equal distances, and the distance."""
    lengths = [0]
    for p, q in zip(profile, profile[1:]):
        lengths.append(lengths[-1] + math.dist(p, q))
    points, k = [], 0
    for i in range(count + 1):
        s = lengths[-1] * i / count
        while k + 2 < len(profile) and lengths[k + 1] <= s:
            k += 1
        t = (s - lengths[k]) / (lengths[k + 1] - lengths[k])
        points.append(tuple(a + t * (b - a) for a, b in zip(profile[k], profile[k + 1])))
    return points, lengths[-1] / count


def sizes_of(points, step):
    """A sixth of the number of points on each ring: what triangles of equal sides need, but at most one more than
    on a ring beside it; none at the poles."""
    last = len(points) - 1
    sizes = [0 if j in (0, last) else max(1, round(math.pi * r / (3 * step))) for j, (r, _) in enumerate(points)]
    for order in (range(1, last + 1), range(last - 1, -1, -1)):
        for j in order:
            sizes[j] = min(sizes[j], sizes[j - order.step] + 1)
    return sizes


def revolved(profile, rings):
    """(points, faces) of a profile that is turned around the axis"""
    points, step = even(profile, rings)
    vertices, last, faces, turn = [], None, [], 0
    for (r, z), size in zip(points, sizes_of(points, step)):
        count = max(1, 6 * size)
        turn = .5 - turn if last and len(last) == count else 0  # rings of one size alternate
        ring = [(2 * math.pi * (k + turn) / count, len(vertices) + k) for k in range(count)]
        vertices += [(r * math.cos(a), r * math.sin(a), z) for a, _ in ring]
        faces += strip(last, ring) if last else []
        last = ring
    return vertices, faces


def strip(upper, lower):
    """The faces between two rings of (angle, vertex): whose middle comes first is the next edge."""
    def edges(ring, is_upper):
        if len(ring) == 1:
            return []
        after = ring[1:] + [(ring[0][0] + 2 * math.pi, ring[0][1])]
        return [(a + b, not is_upper, v, w) for (a, v), (b, w) in zip(ring, after)]

    faces, at = [], [upper[0][1], lower[0][1]]
    for _, is_lower, v, w in sorted(edges(upper, True) + edges(lower, False), key=lambda e: (round(e[0], 9), e[1])):
        faces.append((v, w, at[0]) if is_lower else (w, v, at[1]))
        at[is_lower] = w
    return faces

