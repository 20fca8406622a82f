#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The library header-only, as header_only.py writes it, in two translation units that are linked. A
function that is not inline, or a variable that is defined twice, does not link. The second is a copy
of what the first became.

usage: check_two_units.py COMPILER [COMPILER ARGUMENT...]
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import check_headers_alone
import header_only
import sources


def source():
    return "\n".join(f"#include <{header.as_posix()}>"
                     for header in sources.headers()
                     if not check_headers_alone.needs_more(header)
                     and header.name != header_only.CONFIG) + "\n"


def main():
    compiler = sys.argv[1:] or ["c++", "-isystem", "/usr/include/eigen3"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "all.cpp").write_text(source(), encoding="utf-8")
        (folder / "main.cpp").write_text("int main() {}\n", encoding="utf-8")
        header_only.write(folder)
        command = [*compiler, "-std=c++17", "-O0", "-I", folder]
        subprocess.run([*command, "-c", "all.cpp", "-o", "all.o"], cwd=folder, check=True)
        shutil.copy(folder / "all.o", folder / "second.o")
        result = subprocess.run([*command, "main.cpp", "all.o", "second.o", "-lpthread", "-o", "main"],
                                cwd=folder, capture_output=True, text=True, check=False)
    complaints = [line for line in result.stderr.splitlines() if "multiple definition" in line]
    sources.finish(complaints or [result.stderr] * (result.returncode != 0), "headers in two units")


if __name__ == "__main__":
    main()
