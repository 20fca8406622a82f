#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Everything a core header includes of CGAL, directly or not, is LGPL or Boost licensed, and
nothing is SuiteSparse's.

usage: check_licences.py COMPILER [COMPILER ARGUMENT...]
Headers of one mesh type and those over CHOLMOD are exempt (sources.GPL_HEADER): they are the
documented way to the GPL parts. So are those over libraries that may be missing.
"""

import concurrent.futures
import functools
import pathlib
import re
import subprocess
import sys

import sources

PERMITTED = re.compile(r"\bLGPL-|\bBSL-1\.0|\bMIT\b")
FORBIDDEN = re.compile(r"(?<!L)GPL-")


@functools.lru_cache(maxsize=None)
def licence(path):
    """The SPDX expression of a file, or none."""
    text = pathlib.Path(path).read_text(encoding="utf-8", errors="replace")
    match = re.search(r"SPDX-License-Identifier:\s*(.*)", text)
    return match.group(1).strip() if match else "none"


def is_permitted(expression):
    return bool(PERMITTED.search(expression)) and not FORBIDDEN.search(expression)


def closure(compiler, header):
    """All files the preprocessor opens for one header."""
    command = [*compiler, "-std=c++17", "-x", "c++", "-M", "-I", str(sources.ROOT / "include"),
               str(sources.INCLUDE / header)]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"{header}: {result.stderr}")
    return result.stdout.partition(":")[2].replace("\\\n", " ").split()


def complaints(compiler, header):
    found = []
    for path in closure(compiler, header):
        if "/suitesparse/" in path:
            found.append(f"{header}: includes {path}, which is for adapters/Cholmod_*.h")
        elif "/include/CGAL/" in path and not is_permitted(licence(path)):
            found.append(f"{header}: includes {path}, whose licence is {licence(path)}")
    return found


def main():
    compiler = sys.argv[1:] or ["c++", "-isystem", "/usr/include/eigen3"]
    core = [header for header in sources.headers()
            if not sources.GPL_HEADER.search(header.as_posix())
            and not sources.OPTIONAL_HEADER.search(header.as_posix())]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        found = pool.map(functools.partial(complaints, compiler), core)
    sources.finish(sum(found, []), f"the licences {len(core)} core headers depend on")


if __name__ == "__main__":
    main()
