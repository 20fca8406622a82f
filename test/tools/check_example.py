#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""An example runs on a generated surface: it succeeds and writes as many vertices as it read.

usage: check_example.py PROGRAM [CONFORMAL]   (which takes INPUT OUTPUT.ply, or a curve and OUTPUT.svg)

first_program does the same as the command CONFORMAL in the README.
"""

import itertools
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile


def sphere(subdivisions):
    """(points, faces) of an octahedron, subdivided and put onto the unit sphere."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(subdivisions):
        middle = {}

        def between(a, b, middle=middle):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
            return middle[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    return [tuple(x / math.hypot(*p) for x in p) for p in points], faces


def torus(n):
    """(points, faces) of a torus with bumps, n vertices each way."""
    turn = 2 * math.pi / n
    points = []
    for i, j in itertools.product(range(n), repeat=2):
        u, v = i * turn, j * turn
        tube = 0.5 + 0.06 * math.cos(2 * u + v) + 0.04 * math.sin(3 * v)
        radius = 1 + tube * math.cos(v)
        points.append((radius * math.cos(u), radius * math.sin(u), tube * math.sin(v)))
    faces = []
    for i, j in itertools.product(range(n), repeat=2):
        a, b = i * n + j, (i + 1) % n * n + j
        c, d = (i + 1) % n * n + (j + 1) % n, i * n + (j + 1) % n
        faces += [(a, b, c), (a, c, d)]
    return points, faces


def disk(rings, height=lambda radius: (radius, 0.0)):
    """(points, faces) of a surface of revolution over rings of 6, 12, 18, ... vertices; `height`
    tells the distance from the axis and the height of a ring, 1 being the last one."""
    points, faces, start = [(0.0, 0.0, height(0)[1])], [], [0]
    for k in range(1, rings + 1):
        start.append(len(points))
        r, z = height(k / rings)
        angles = [math.pi * j / (3 * k) for j in range(6 * k)]
        points += [(r * math.cos(a), r * math.sin(a), z) for a in angles]
        for sector, j in itertools.product(range(6), range(k)):
            outer = [start[k] + (sector * k + j + i) % (6 * k) for i in (0, 1)]
            inner = [start[k - 1] + (sector * (k - 1) + j + i) % max(6 * (k - 1), 1) for i in (0, 1)]
            faces.append((inner[0], *outer))
            if j < k - 1:
                faces.append((inner[0], outer[1], inner[1]))
    return points, faces


def dome(rings):
    """(points, faces) of a hemisphere."""
    return disk(rings, lambda r: (math.sin(math.pi / 2 * r), math.cos(math.pi / 2 * r)))


def beam(n, length=6):
    """(points, faces) of a block of 1 x 1 x length, n squares along its short edges."""
    number, faces = {}, []
    size = (n, n, length * n)

    def vertex(*place):
        return number.setdefault(place, len(number))

    for axis, side in itertools.product(range(3), (0, 1)):
        a, b = (axis + 1) % 3, (axis + 2) % 3
        for i, j in itertools.product(range(size[a]), range(size[b])):
            corners = []
            for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                place = [0, 0, 0]
                place[axis], place[a], place[b] = side * size[axis], u, v
                corners.append(vertex(*place))
            p, q, r, s = corners if side else corners[::-1]
            faces += [(p, q, r), (p, r, s)] if (i + j) % 2 else [(p, q, s), (q, r, s)]
    return [tuple(x / n for x in place) for place in number], faces


def dumbbell(subdivisions):
    """(points, faces) of two lobes and a neck, along y: a strong rho shrinks the neck."""
    points, faces = sphere(subdivisions)
    return [((0.3 + y * y) * x, 3 * y, (0.3 + y * y) * z) for x, y, z in points], faces


README = re.compile(r"conformal spin \S+ --rho-expression '([^']*)'")
WANTED = {"uncurl_a_torus": lambda: torus(48), "fields_along_handles": lambda: torus(48),
          "minimal_surface": lambda: disk(12),
          "soap_film_cmc": lambda: dome(12), "bend_the_boundary": lambda: dome(12),
          "nearest_to_a_bend": lambda: beam(6), "flatten_a_face": lambda: dome(12),
          "paint_and_filter": lambda: disk(48)}


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, map(float, point))) for point in points]
    lines += [" ".join(map(str, (len(face), *face))) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def read_off(path):
    """the points of a file that begins with OFF and the counts"""
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = [line.split() for line in lines[1:] if line and not line.startswith("#")]
    return [tuple(map(float, row[:3])) for row in rows[1:1 + int(rows[0][0])]]


def check_first_program(program, conformal):
    """It moves vertices as the command does, also where the bound on lengths acts, and names a face
    of four corners."""
    with tempfile.TemporaryDirectory() as folder:
        source, own, other = (pathlib.Path(folder) / f"{name}.off" for name in ("in", "own", "other"))
        write_off(source, [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1)],
                  [(0, 1, 2, 3), (1, 0, 4), (2, 1, 4), (3, 2, 4), (0, 3, 4)])
        refusal = subprocess.run([program, source, own], check=False, stderr=subprocess.PIPE, text=True)
        if refusal.returncode != 1 or "face 0" not in refusal.stderr or own.exists():
            sys.exit(f"a face of four corners: {refusal.returncode}, {refusal.stderr}")
        write_off(source, *dumbbell(4))
        subprocess.run([program, source, own], check=True)
        rho = README.search(pathlib.Path(__file__).parents[2].joinpath("README.md").read_text(encoding="utf-8"))[1]
        subprocess.run([conformal, "spin", source, "--rho-expression", rho, "-o", other], check=True)
        before, *after = (read_off(path) for path in (source, own, other))
    moved, apart = (max(map(math.dist, a, b)) for a, b in ((before, after[0]), after))
    if not (moved > 0.1 and apart < 1e-4 * moved):
        sys.exit(f"the program moved points by {moved}, and they are {apart} from the command's")


def check_curve(program, size=100):
    """The program draws a curve on its way: five polygons of as many points as it read."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = (pathlib.Path(folder) / name for name in ("curve.txt", "picture.svg"))
        angles = [2 * math.pi * i / size for i in range(size)]
        source.write_text("".join(f"{math.cos(t)} {math.sin(t) + 0.3 * math.sin(2 * t)}\n"
                                  for t in angles))
        subprocess.run([program, str(source), str(target)], check=True)
        curves = re.findall(r'<polygon [^>]*points="([^"]*)"', target.read_text())
    if [len(curve.split()) for curve in curves] != 5 * [size]:
        sys.exit(f"{len(curves)} curves written, wanted five of {size} points")


def check_torus(program):
    """The program prints what it claims: the class stays, and the energy ends near the least."""
    with tempfile.TemporaryDirectory() as folder:
        files = [str(pathlib.Path(folder) / name) for name in ("before.ply", "after.ply")]
        text = subprocess.run([program, "1.25", *files], check=True, stdout=subprocess.PIPE,
                              text=True).stdout
        for file in files:
            pathlib.Path(file).stat()
    before, after = (complex(*map(float, pair))
                     for pair in re.findall(r"\((\S+),(\S+)\) (?:before|after)", text))
    energy, least = map(float, re.search(r"(\S+) after, smoothest (\S+)", text).groups())
    if abs(before.imag - 1.25) > 1e-5 or abs(after - before) > 0.005:
        sys.exit(f"the modulus is {before}, then {after}")
    if abs(energy - least) > 0.01 * least:
        sys.exit(f"the energy is {energy}, the least is {least}")


def check_rotations(program):
    """The rotations found are nearly the true ones, and without noise they are."""
    for noise, least in ((0.1, 0.9), (0, 1 - 1e-9)):
        text = subprocess.run([program, "300", str(noise)], check=True, stdout=subprocess.PIPE,
                              text=True).stdout
        overlap = float(text.split()[-1])
        if not overlap >= least:
            sys.exit(f"the overlap is {overlap}, wanted {least}, with noise {noise}")


def check_filled_hole(program):
    """The program cuts off the top of a sphere, and what it fills the hole with is a sphere again."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = (pathlib.Path(folder) / name for name in ("sphere.off", "result.ply"))
        write_off(source, *sphere(4))
        subprocess.run([program, str(source), str(target), "0.2"], check=True)
        head, _, body = target.read_bytes().partition(b"end_header\n")
    if b"format binary_little_endian" in head:
        count = int(re.search(rb"element vertex (\d+)", head).group(1))
        points = list(itertools.islice(struct.iter_unpack("<3d", body[:24 * count]), count))
    else:
        points = [tuple(map(float, line.split())) for line in body.splitlines()
                  if len(line.split()) == 3]
    error = max(abs(math.hypot(*point) - 1) for point in points)
    if len(points) < 500 or error > 0.01:
        sys.exit(f"{len(points)} vertices, and one is {error} from the sphere")


def check_vesicle(program):
    """The energy of a disc of .6 of the volume of a round sphere, by the shape equations of vesicles."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([program, ".6", f"{folder}/result.ply"], check=True, stdout=subprocess.PIPE, text=True)
    volume, energy = map(float, re.search(r"volume (\S+) .* energy (\S+)", run.stdout).groups())
    if abs(volume - .6) > 1e-6 or abs(energy / 1.9557 - 1) > .01:
        sys.exit(f"a volume of {volume} and an energy of {energy}")


def main():
    if len(sys.argv) > 2:
        check_first_program(*sys.argv[1:3])
    if pathlib.Path(sys.argv[1]).stem == "fair_a_hole":
        return check_filled_hole(sys.argv[1])
    if pathlib.Path(sys.argv[1]).stem == "average_rotations":
        return check_rotations(sys.argv[1])
    if pathlib.Path(sys.argv[1]).stem == "smoothest_torus":
        return check_torus(sys.argv[1])
    if pathlib.Path(sys.argv[1]).stem == "red_blood_cell":
        return check_vesicle(sys.argv[1])
    if pathlib.Path(sys.argv[1]).stem == "unwind_a_curve":
        return check_curve(sys.argv[1])
    points, faces = WANTED.get(pathlib.Path(sys.argv[1]).stem, lambda: sphere(4))()
    with tempfile.TemporaryDirectory() as folder:
        source, target = (pathlib.Path(folder) / name for name in ("surface.off", "result.ply"))
        write_off(source, points, faces)
        result = subprocess.run([sys.argv[1], str(source), str(target)], check=False)
        if result.returncode != 0:
            sys.exit(f"exit code {result.returncode}")
        head = target.read_bytes().partition(b"end_header")[0].decode()
    vertices = int(re.search(r"element vertex (\d+)", head).group(1))
    if vertices != len(points):
        sys.exit(f"{len(points)} vertices read, {vertices} written")


if __name__ == "__main__":
    main()
