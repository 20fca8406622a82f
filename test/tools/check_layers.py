#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A header includes its own folder or lower layers, never a folder beside it."""

import sources

LEVEL = {
    "algebra": 1,
    "linear_algebra": 2, "mesh": 2,
    "operators": 3,
    "forms": 4, "measure": 4, "painting": 4,
    "spin": 5,
    "flow": 6, "parameterization": 6, "surfaces": 6, "curves": 6,
    "core": 7,
}
BASE = {"config.h", "exceptions.h", "version.h"}
ENTRY_POINTS = 8


def place(header):
    """(folder, level); the files at the top are the base, or else the entry points."""
    if len(header.parts) == 1:
        return (".", 0) if header.name in BASE else ("entry points", ENTRY_POINTS)
    folder = header.parts[0]
    return folder, LEVEL.get(folder)


def complaints():
    for header in sources.headers():
        folder, level = place(header)
        if level is None:
            yield f"{header}: the folder {folder} has no layer; see LEVEL in check_layers.py"
            continue
        for line, name in sources.includes(sources.INCLUDE / header):
            prefix, _, rest = name.partition("/")
            if prefix != sources.LIBRARY:
                continue
            other = sources.pathlib.PurePath(rest)
            other_folder, other_level = place(other)
            if not (sources.INCLUDE / other).exists():
                yield f"{header}:{line}: includes {rest}, which does not exist"
            elif other_folder != folder and (other_level is None or other_level >= level):
                yield (f"{header}:{line}: layer {level} ({folder}) includes {rest} "
                       f"of layer {other_level} ({other_folder})")


if __name__ == "__main__":
    sources.finish(list(complaints()), f"the layers of {len(sources.headers())} headers")
