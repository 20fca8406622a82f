#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A file includes its own folder or lower layers, never a folder beside it: the headers of the
library, and the files of the program."""

import graphlib

import sources

SOLVERS_LEVEL = {
    "threads": 1,
    "algebra": 2,
    ".": 3, "adapters": 3, "dense": 3, "direct": 3, "krylov": 3, "reduced": 3, "vector_units": 3,
}
LEVEL = {
    "mesh": 4,
    "operators": 5,
    "conformal_class": 6, "forms": 6, "measure": 6, "painting": 6,
    "spin": 7,
    "flow": 8, "parameterization": 8, "surfaces": 8, "curves": 8,
    "core": 9,
    ".": 10,
}
PROGRAM = "conformal"
PROGRAM_LEVEL = {
    "io/file": 1,
    "io/data": 2, "process": 2,
    "io/csv": 3, "io/glb": 3, "io/obj": 3, "io/off": 3, "io/picture": 3, "io/ply": 3, "io/stl": 3, "io/svg": 3,
    "io/usd": 3, "io/vtk": 3,
    "io": 4,
    "repair": 5,
    "input": 6,
    "report": 7,
    "curves": 8, "studio": 8, "transform": 8,
    "commands": 9, "studio/wasm": 9,
    ".": 10,
    "mpi": 11,
}
BASE = {"config.h", "exceptions.h", "version.h"}


def place(header):
    """(folder, level) of a path below include/; the files at the top are the base, or else the entry
    points, `.`. The solvers are one folder with several inside."""
    house, *folders, name = header.parts
    folder = folders[0] if folders else "."
    if name in BASE and not folders:
        return "base", 0
    if house == sources.SOLVERS:
        level = SOLVERS_LEVEL.get(folder)
        return (sources.SOLVERS if level == SOLVERS_LEVEL["."] else folder), level
    return folder, LEVEL.get(folder)


def program_place(path):
    folder = path.parent.as_posix()
    return folder, PROGRAM_LEVEL.get(folder)


def own_of_program(name):
    return name.removeprefix(f"{PROGRAM}/") if name.startswith(f"{PROGRAM}/") else None


def of_file(root, file, own, place_of):
    """The complaints about one file; own(name) is the path below the root of an included name, if it is
    one of ours."""
    folder, level = place_of(file)
    if level is None:
        yield f"{file}: the folder {folder} has no layer; see check_layers.py"
        return
    for line, name in sources.includes(root / file):
        if not own(name):
            continue
        other = sources.pathlib.PurePath(own(name))
        other_folder, other_level = place_of(other)
        if not (root / other).exists():
            yield f"{file}:{line}: includes {other}, which does not exist"
        elif other_folder != folder and (other_level is None or other_level >= level):
            yield (f"{file}:{line}: layer {level} ({folder}) includes {other} "
                   f"of layer {other_level} ({other_folder})")


def program_cycles():
    """A cycle of includes, if there is one."""
    try:
        graphlib.TopologicalSorter(sources.program_modules()).prepare()
    except graphlib.CycleError as error:
        yield "a cycle of includes: " + ", ".join(map(str, error.args[1]))


def complaints():
    for file in sources.library(".h", ".cpp"):
        yield from of_file(sources.INCLUDE, file, lambda name: name if sources.is_ours(name) else None, place)
    for file in sources.program():
        yield from of_file(sources.PROGRAM, file, own_of_program, program_place)
    yield from program_cycles()


if __name__ == "__main__":
    sources.finish(list(complaints()), "the layers of the library and of the program")
