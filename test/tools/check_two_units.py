#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Header-only: all headers in two translation units that are linked. A function that is not inline, or
a variable that is defined twice, does not link. The second is a copy of what the first became.

usage: check_two_units.py COMPILER [COMPILER ARGUMENT...]
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import check_headers_alone
import sources


def source():
    return "\n".join(f"#include <{sources.LIBRARY}/{header.as_posix()}>"
                     for header in sources.interfaces()
                     if not check_headers_alone.needs_more(header)) + "\n"


def main():
    compiler = sys.argv[1:] or ["c++", "-isystem", "/usr/include/eigen3"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "all.cpp").write_text(source(), encoding="utf-8")
        (folder / "main.cpp").write_text("int main() {}\n", encoding="utf-8")
        command = [*compiler, "-std=c++17", "-O0", "-DCONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY",
                   "-I", sources.ROOT / "include"]
        subprocess.run([*command, "-c", "all.cpp", "-o", "all.o"], cwd=folder, check=True)
        shutil.copy(folder / "all.o", folder / "second.o")
        result = subprocess.run([*command, "main.cpp", "all.o", "second.o", "-lpthread", "-o", "main"],
                                cwd=folder, capture_output=True, text=True, check=False)
    complaints = [line for line in result.stderr.splitlines() if "multiple definition" in line]
    sources.finish(complaints or [result.stderr] * (result.returncode != 0), "headers in two units")


if __name__ == "__main__":
    main()
