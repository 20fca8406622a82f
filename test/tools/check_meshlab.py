#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""MeshLab reads the PLY files of `conformal`: colours, quality and texture coordinates come out of
it as they went in, and its window under Xvfb shows the colours and the texture.

usage: check_meshlab.py CONFORMAL [FOLDER]   (keeps the meshes and pictures in FOLDER)

Run by hand, not by ctest, for MeshLab brings half of Qt. On Debian 12 (MeshLab 2020.09):
apt-get install meshlab xvfb xauth imagemagick
"""

import math
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from check_example import dome, sphere
from headless_page import read_png

PROGRAMS = ("meshlab", "meshlabserver", "xvfb-run", "import")
FORMATS = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
           "float": "f", "double": "d"}
CYAN, MAGENTA = (0, 255, 255), (255, 0, 255)


def write_ply(path, points, faces, extra, rows, comment=""):
    """A PLY file in ASCII whose vertices have more properties."""
    names = [*(f"double {axis}" for axis in "xyz"), *extra]
    lines = ["ply", "format ascii 1.0", *filter(None, [comment]), f"element vertex {len(points)}",
             *(f"property {name}" for name in names), f"element face {len(faces)}",
             "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(map(repr, (*map(float, point), *row))) for point, row in zip(points, rows)]
    lines += [" ".join(map(str, (3, *face))) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def vertices(path):
    """The vertices of a PLY file, a dictionary each."""
    head, _, body = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in head.decode().splitlines()]
    count = next(int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
    begin = lines.index(["element", "vertex", str(count)]) + 1
    properties = []
    for line in lines[begin:]:
        if line[0] != "property":
            break
        properties.append((line[2], line[1]))
    names = [name for name, _ in properties]
    if ["format", "ascii", "1.0"] in lines:
        rows = [map(float, line.split()) for line in body.decode().splitlines()[:count]]
    else:
        row = struct.Struct("<" + "".join(FORMATS[kind] for _, kind in properties))
        rows = row.iter_unpack(body[:count * row.size])
    return [dict(zip(names, values)) for values in rows]


def write_squares(path, size=64, square=8):
    """A picture of cyan and magenta squares."""
    rows = b"".join(b"\0" + b"".join(bytes((CYAN, MAGENTA)[(x // square + y // square) % 2])
                                     for x in range(size)) for y in range(size))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def check_values(path, names):
    """What MeshLab writes after it has read the file has these values of every vertex."""
    copy = path.with_name(f"meshlab_{path.name}")
    subprocess.run(["xvfb-run", "-a", "meshlabserver", "-i", path, "-o", copy, "-m", "sa", "vc", "vq",
                    "vt"], check=True, capture_output=True, timeout=120)
    ours, theirs = vertices(path), vertices(copy)
    if len(ours) != len(theirs):
        sys.exit(f"{path.name}: {len(ours)} vertices, in MeshLab {len(theirs)}")
    for number, (a, b) in enumerate(zip(ours, theirs)):
        for name in ("x", "y", "z", *names):
            if not math.isclose(a[name], b.get(name, math.nan), rel_tol=1e-5, abs_tol=1e-5):
                sys.exit(f"{path.name}: {name} of vertex {number} is {a[name]}, in MeshLab "
                         f"{b.get(name)}")
    spread = {name: (min(v[name] for v in ours), max(v[name] for v in ours)) for name in names}
    print(f"{path.name}: {len(ours)} vertices,", ", ".join(
        f"{name} {low:.4g} to {high:.4g}" for name, (low, high) in spread.items()))


def window(path):
    """What the window of MeshLab shows when it has opened the file."""
    picture = path.with_suffix(".png")
    script = f'meshlab "{path}" & sleep 12; import -window root "png24:{picture}"; kill $!'
    process = subprocess.Popen(["xvfb-run", "-a", "-s", "-screen 0 1200x900x24", "sh", "-c", script],
                               start_new_session=True, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    try:
        process.wait(timeout=120)
    finally:
        time.sleep(1)
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    return [pixel for row in read_png(picture.read_bytes()) for pixel in row]


def check_window(path, kinds):
    """Of each kind of colour there is at least a thousandth in the window."""
    pixels = window(path)
    for name, is_wanted in kinds.items():
        share = sum(is_wanted(*pixel) for pixel in pixels) / len(pixels)
        print(f"{path.name}: {100 * share:.2f} % of the screen is {name}")
        if share < 0.001:
            sys.exit(f"{path.name}: MeshLab's window does not show {name}")


def main():
    missing = [program for program in PROGRAMS if shutil.which(program) is None]
    if missing:
        sys.exit(f"{', '.join(missing)} not found; on Debian: apt-get install meshlab xvfb xauth "
                 "imagemagick")
    conformal = sys.argv[1]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else temporary).resolve()
        ball, half, spun, flat = (folder / name for name in
                                  ("ball.ply", "half.ply", "spun.ply", "flat.ply"))
        points, faces = sphere(4)
        write_ply(ball, points, faces, ("uchar red", "uchar green", "uchar blue"),
                  [tuple(round(127.5 + 127 * x) for x in point) for point in points])
        points, faces = dome(14)
        write_ply(half, points, faces, (), [()] * len(points), "comment TextureFile squares.png")
        write_squares(folder / "squares.png")
        subprocess.run([conformal, "spin", "-q", ball, "--rho-expression", "2*x", "-o", spun],
                       check=True)
        subprocess.run([conformal, "flatten", "-q", half, "-o", flat], check=True)
        check_values(spun, ("red", "green", "blue", "quality"))
        check_values(flat, ("quality", "texture_u", "texture_v"))
        check_window(spun, {"reddish": lambda r, g, b: r > 1.3 * g and r > 1.05 * b,
                            "greenish": lambda r, g, b: g > 1.1 * r and g > 1.02 * b,
                            "bluish and bright": lambda r, g, b: b > 220 and b > 1.3 * r > 0})
        check_window(flat, {"cyan": lambda r, g, b: r < 50 and g > 120 and b > 120,
                            "magenta": lambda r, g, b: r > 120 and g < 50 and b > 120})


if __name__ == "__main__":
    main()
