# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the points of a binary PLY file, to look at results without the program that wrote them."""

import math
import struct

CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d"}
END = b"end_header\n"


def layout(head):
    """(number of vertices, names of their properties, their format for struct)"""
    count, names, codes, inside = 0, [], "<", False
    for words in (line.split() for line in head.splitlines()):
        if words[0] == "element":
            inside = words[1] == "vertex"
            count = int(words[2]) if inside else count
        elif words[0] == "property" and inside:
            names.append(words[2])
            codes += CODES[words[1]]
    return count, names, codes


def points(data):
    """The points, or ValueError or struct.error where this is no such file or a part of one."""
    end = data.index(END)
    head = data[:end].decode("ascii")
    if "format binary_little_endian 1.0" not in head:
        raise ValueError("not a binary PLY file")
    count, names, codes = layout(head)
    start, size = end + len(END), struct.calcsize(codes)
    body = data[start:start + count * size]
    if len(body) < count * size:
        raise ValueError("truncated")
    axes = [names.index(axis) for axis in "xyz"]
    return [tuple(row[axis] for axis in axes) for row in struct.iter_unpack(codes, body)]


def fault(data, vertices):
    """What is wrong with the file of so many vertices, or an empty text."""
    try:
        found = points(data)
    except (ValueError, struct.error, KeyError) as error:
        return f"not readable: {error}"
    if len(found) != vertices:
        return f"{len(found)} vertices"
    if not all(math.isfinite(value) for point in found for value in point):
        return "not finite"
    return ""
