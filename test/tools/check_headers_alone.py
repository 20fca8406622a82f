#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every header compiles alone, and what is below the skin of CGAL needs neither CGAL nor Boost.

To read Eigen takes ten times as long as to read one of our headers. So the headers that reach the same
ones of others (by themselves or by what they include) share these, precompiled: what they do not
include stays missing.

usage: check_headers_alone.py COMPILER [COMPILER ARGUMENT...]
"""

import collections
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import sources

SKIN = re.compile(rf"^{sources.LIBRARY}/(core/|(?!version)[^/]*$)")
OTHERS = re.compile(r"(Eigen|CGAL|boost)/")


def needs_more(header):
    """Whether it is over a library that may be missing here."""
    name = header.as_posix()
    return bool(re.search(r"adapters/(Cholmod|Metis|Petsc|Slepc)_", name))


def reached(header):
    """The headers of Eigen, CGAL and Boost that it includes, by itself or by ours."""
    waiting, seen, others = [header], {header}, set()
    while waiting:
        for _, name in sources.includes(sources.INCLUDE / waiting.pop()):
            if OTHERS.match(name):
                others.add(name)
            elif sources.is_ours(name):
                own = pathlib.Path(name)
                waiting += {own} - seen
                seen.add(own)
    return frozenset(others)


def precompile(command, folder, names):
    """The options that read these headers."""
    path = pathlib.Path(tempfile.mkdtemp(dir=folder)) / "others.h"
    path.write_text("".join(f"#include <{name}>\n" for name in sorted(names)), encoding="utf-8")
    subprocess.run([*command, "-x", "c++-header", path, "-o", f"{path}.gch"], check=True)
    return ["-include", path]


def complaints(command, header):
    foreign = [name for name in sorted(reached(header)) if not name.startswith("Eigen/")]
    if foreign and not SKIN.search(header.as_posix()):
        return [f"{header}: needs {foreign[0]}"]
    result = subprocess.run([*command, "-fsyntax-only", "-x", "c++", sources.INCLUDE / header],
                            capture_output=True, text=True, check=False)
    return [f"{header}: does not compile alone: {result.stderr}"] if result.returncode else []


def main():
    compiler = sys.argv[1:] or ["c++", "-isystem", "/usr/include/eigen3"]
    command = [*compiler, "-std=c++17", "-w", "-I", sources.ROOT / "include"]
    needs = {header: reached(header) for header in sources.headers() if not needs_more(header)}
    often = [names for names, count in collections.Counter(needs.values()).items() if count > 2]
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        shared = dict(zip(often, pool.map(lambda names: precompile(command, folder, names), often)))

        def check(header):
            most = max((names for names in often if names <= needs[header]), key=len, default=())
            return complaints(command + shared.get(most, []), header)

        found = sum(pool.map(check, needs), [])
    sources.finish(found, f"{len(needs)} headers, each alone")


if __name__ == "__main__":
    main()
