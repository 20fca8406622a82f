#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What is below the skin of CGAL compiles with what Visual C++ and windows.h do to it: macros
min(), max(), near, far, small and interface; no M_PI; neither GCC's vectors nor its other extensions.

usage: check_hostile_macros.py COMPILER [COMPILER ARGUMENT...]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import check_headers_alone
import header_only
import sources

# What windows.h defines unless it is told NOMINMAX and WIN32_LEAN_AND_MEAN, and what <cmath> defines
# there only with _USE_MATH_DEFINES.
MACROS = """
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define interface struct
#undef M_PI
#undef M_PI_2
#undef M_PI_4
#undef M_SQRT2
#undef M_SQRT1_2
#undef M_E
"""


def kernels(headers):
    return [header for header in headers if not check_headers_alone.needs_more(header)
            and not check_headers_alone.SKIN.search(header.as_posix())]


def source():
    """The headers of others first, for they are read without these macros."""
    others = {name for header in kernels(sources.library(".h", ".cpp"))
              for _, name in sources.includes(sources.INCLUDE / header)
              if not sources.is_ours(name) and not re.match("boost/|CGAL/", name)}
    # Some are there on one system only.
    lines = [f"#if __has_include(<{name}>)\n#include <{name}>\n#endif" for name in sorted(others)]
    lines.append(MACROS)
    lines += [f"#include <{header.as_posix()}>"
              for header in kernels(sources.headers()) if header.name != header_only.CONFIG]
    return "\n".join(lines) + "\n"


def main():
    compiler = sys.argv[1:] or ["c++", "-isystem", "/usr/include/eigen3"]
    with tempfile.TemporaryDirectory() as folder:
        header_only.write(pathlib.Path(folder))
        path = pathlib.Path(folder) / "hostile_macros.cpp"
        path.write_text(source(), encoding="utf-8")
        command = [*compiler, "-std=c++17", "-fsyntax-only", "-pedantic-errors",
                   "-DCONFORMAL_GEOMETRY_PROCESSING_NO_VECTOR_EXTENSIONS",
                   "-I", folder, path]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
    complaints = [line for line in result.stderr.splitlines() if "error:" in line]
    if result.returncode != 0 and not complaints:
        complaints = [result.stderr]
    sources.finish(complaints, "headers under the macros of windows.h")


if __name__ == "__main__":
    main()
