# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The same run again and again, with one thread and with two: the same bytes."""

import hashlib
import math
import shutil

from page import ply_points
from page.fault_bench import RHO, Check

NEAR = 1e-10  # of the diameter


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, point)) for point in points]
    lines += [" ".join(map(str, (3, *face))) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def strip(m, n, is_closed):
    """Faces of m x n squares, closed both ways or with a boundary; the vertex (i, j) is i n + j."""
    def vertex(i, j):
        return i % m * n + j % n
    faces = []
    for i in range(m if is_closed else m - 1):
        for j in range(n if is_closed else n - 1):
            a, b = vertex(i, j), vertex(i + 1, j)
            c, d = vertex(i + 1, j + 1), vertex(i, j + 1)
            faces += [(a, b, c), (a, c, d)]
    return faces


def torus(path, m=96, n=32):
    points = []
    for i in range(m):
        for j in range(n):
            u, v = 2 * math.pi * i / m, 2 * math.pi * j / n
            radius = 2 + 0.7 * math.cos(v)
            points.append((radius * math.cos(u), radius * math.sin(u), 0.7 * math.sin(v)))
    return write_off(path, points, strip(m, n, True))


def bent_sheet(path, m=48, n=48):
    points = [(i / m, j / n, 0.2 * math.sin(3 * i / m) * j / n)
              for i in range(m) for j in range(n)]
    return write_off(path, points, strip(m, n, False))


def runs(bench):
    sheet, ring = bent_sheet(bench.folder / "sheet.off"), torus(bench.folder / "torus.off")
    spin = ["spin", bench.mesh, *RHO]
    return {
        "spin": spin, "spin, CHOLMOD": [*spin, "--advanced", "solver=cholmod"],
        "spin, handles": ["spin", ring, "--rho-expression", "0.3*z"],
        "spin, boundary": ["spin", sheet, *RHO, "--boundary", "tangents"],
        "boundary": ["boundary", sheet, "--binormal-tilt", "10*cos(2*pi*s)"],
        "flow": ["flow", bench.mesh, "--steps", "2"],
        "flow, boundary": ["flow", sheet, "--steps", "2"],
        "flatten": ["flatten", sheet, "--planar-mesh"], "harmonic": ["harmonic", ring],
    }


def distance(a, b):
    """The largest one between points with the same number, in shares of the diameter of a."""
    size = math.dist([min(x) for x in zip(*a)], [max(x) for x in zip(*a)])
    return max(map(math.dist, a, b)) / size if len(a) == len(b) else math.inf


def repeated(check, bench, name, arguments, times):
    """{threads: the output}, all of the same threads being the same"""
    outputs = {}
    for threads in (1, 2):
        hashes = set()
        for _ in range(times):
            folder = bench.new_folder("repeated")
            output = folder / "output.ply"
            code, message = bench.run(*arguments, "-o", output, "--threads", str(threads))
            check.ended(f"exit {code}")
            check.expect(code == 0, f"{name}: {message}")
            outputs[threads] = output.read_bytes() if output.exists() else b""
            hashes.add(hashlib.sha256(outputs[threads]).digest())
            shutil.rmtree(folder)
        check.expect(len(hashes) == 1, f"{name}, {threads} threads: {len(hashes)} outputs")
    return outputs


def repeats(bench, times):
    """Each command so many times with one thread and with two."""
    check = Check(f"the same bytes {times} times, with one thread and with two")
    others = []
    for name, arguments in runs(bench).items():
        outputs = repeated(check, bench, name, arguments, times)
        if outputs[1] == outputs[2]:
            continue
        far = distance(*map(ply_points.points, (outputs[1], outputs[2])))
        others.append(f"{name}: two threads differ from one by {far:.1e} of the diameter")
        check.expect(far <= NEAR, others[-1])
    return check.row("; ".join(others) or "one thread and two give the same bytes as well")
