#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A file includes its own folder or lower layers, never a folder beside it: the headers of the
library, and the files of the program."""

import graphlib

import sources

LEVEL = {
    "threads": 1,
    "algebra": 2,
    "linear_algebra": 3, "mesh": 3,
    "operators": 4,
    "conformal_class": 5, "forms": 5, "measure": 5, "painting": 5,
    "spin": 6,
    "flow": 7, "parameterization": 7, "surfaces": 7, "curves": 7,
    "core": 8,
}
PROGRAM = "conformal"
PROGRAM_LEVEL = {
    "io/file": 1,
    "io/data": 2, "process": 2,
    "io/csv": 3, "io/glb": 3, "io/obj": 3, "io/off": 3, "io/picture": 3, "io/ply": 3, "io/stl": 3, "io/svg": 3,
    "io": 4,
    "repair": 5,
    "input": 6,
    "report": 7,
    "curves": 8, "studio": 8, "transform": 8,
    "commands": 9, "studio/wasm": 9,
    ".": 10,
}
BASE = {"config.h", "exceptions.h", "version.h"}
ENTRY_POINTS = 9


def place(header):
    """(folder, level); the files at the top are the base, or else the entry points."""
    if len(header.parts) == 1:
        return (".", 0) if header.name in BASE else ("entry points", ENTRY_POINTS)
    folder = header.parts[0]
    return folder, LEVEL.get(folder)


def program_place(path):
    folder = path.parent.as_posix()
    return folder, PROGRAM_LEVEL.get(folder)


def of_file(root, file, prefix, place_of):
    """The complaints about one file; names in <> or "" begin with the prefix, or are beside it."""
    folder, level = place_of(file)
    if level is None:
        yield f"{file}: the folder {folder} has no layer; see check_layers.py"
        return
    for line, name in sources.includes(root / file):
        first, _, rest = name.partition("/")
        if first != prefix:
            continue
        other = sources.pathlib.PurePath(rest)
        other_folder, other_level = place_of(other)
        if not (root / other).exists():
            yield f"{file}:{line}: includes {rest}, which does not exist"
        elif other_folder != folder and (other_level is None or other_level >= level):
            yield (f"{file}:{line}: layer {level} ({folder}) includes {rest} "
                   f"of layer {other_level} ({other_folder})")


def program_cycles():
    """A cycle of includes, if there is one."""
    try:
        graphlib.TopologicalSorter(sources.program_modules()).prepare()
    except graphlib.CycleError as error:
        yield "a cycle of includes: " + ", ".join(map(str, error.args[1]))


def complaints():
    for file in sources.library(".h", ".cpp"):
        yield from of_file(sources.INCLUDE, file, sources.LIBRARY, place)
    for file in sources.program():
        yield from of_file(sources.PROGRAM, file, PROGRAM, program_place)
    yield from program_cycles()


if __name__ == "__main__":
    sources.finish(list(complaints()), "the layers of the library and of the program")
