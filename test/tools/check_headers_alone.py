#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every header compiles alone, and what is below the skin of CGAL needs neither CGAL nor Boost.

usage: check_headers_alone.py COMPILER [COMPILER ARGUMENT...]
"""

import concurrent.futures
import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import sources

SKIN = re.compile(r"^core/|^(?!config|exceptions|templates|version)[^/]*$")
FOREIGN = re.compile(r"/(?:CGAL|boost)/\S*")


def needs_more(header):
    """Whether it is over a library that may be missing here."""
    name = header.as_posix()
    return bool(re.search(r"adapters/(Cholmod|Metis|Petsc|Slepc)_", name))


def complaints(compiler, header):
    with tempfile.TemporaryDirectory() as folder:
        files = pathlib.Path(folder) / "files"
        command = [*compiler, "-std=c++17", "-fsyntax-only", "-x", "c++", "-w", "-MD", "-MF", files,
                   "-I", sources.ROOT / "include", sources.INCLUDE / header]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            return [f"{header}: does not compile alone: {result.stderr}"]
        used = FOREIGN.search(files.read_text(encoding="utf-8"))
    if used and not SKIN.search(header.as_posix()):
        return [f"{header}: needs {used.group()}"]
    return []


def main():
    compiler = sys.argv[1:] or ["c++", "-isystem", "/usr/include/eigen3"]
    headers = [header for header in sources.interfaces() if not needs_more(header)]
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        found = pool.map(functools.partial(complaints, compiler), headers)
    sources.finish(sum(found, []), f"{len(headers)} headers, each alone")


if __name__ == "__main__":
    main()
