#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""An object file that is compiled for a vector unit defines nothing that another file may define as
well, and no other file defines what belongs to the unit: of two definitions a linker keeps any.

usage: check_vector_symbols.py NM OBJECT_FILE...
"""

import pathlib
import subprocess
import sys

UNITS = ("Avx2_unit", "Avx512_unit")


def defined(nm, path):
    """The symbols that the object file shows to others."""
    lines = subprocess.run([nm, "-P", "-g", path], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    found = (line.split()[:2] for line in lines)
    return [name for name, kind in found if kind.upper() != "U" and kind != "w"]


def complaints(nm, paths):
    for path in paths:
        own = pathlib.Path(path).name.split(".")[0]
        for name in defined(nm, path):
            units = [unit for unit in UNITS if f"{len(unit)}{unit}" in name]
            if units != ([own] if own in UNITS else []):
                yield f"{path}: defines {name}"


if __name__ == "__main__":
    found = list(complaints(sys.argv[1], sys.argv[2:]))
    missing = [unit for unit in UNITS
               if not any(pathlib.Path(path).name.startswith(unit) for path in sys.argv[2:])]
    for line in found + [f"no object file of {unit}" for unit in missing]:
        print(line)
    sys.exit(1 if found or missing else 0)
