# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""PLY files whose properties of vertices all are numbers, as the programs write them."""

import struct

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f",
         "double": "d", "int8": "b", "uint8": "B", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def read_ply(path):
    """The positions, and the names of the properties."""
    head, data = path.read_bytes().split(b"end_header\n", 1)
    lines = [line.split() for line in head.decode().split("\n")]
    binary = any(line[:2] == ["format", "binary_little_endian"] for line in lines)
    start = next(i for i, line in enumerate(lines) if line[:2] == ["element", "vertex"])
    count, names = int(lines[start][2]), []
    for line in lines[start + 1:]:
        if line[:1] != ["property"]:
            break
        names.append((line[2], TYPES[line[1]]))
    if binary:
        rows = list(struct.iter_unpack("<" + "".join(t for _, t in names),
                                       data[:count * struct.calcsize("<" + "".join(t for _, t in names))]))
    else:
        rows = [tuple(map(float, line.split())) for line in data.decode().split("\n")[:count]]
    columns = {name: [row[i] for row in rows] for i, (name, _) in enumerate(names)}
    return list(zip(columns["x"], columns["y"], columns["z"])), set(columns)
