#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""clang-format would change nothing in our files. `--fix` makes it so."""

import shutil
import subprocess
import sys

import sources

PROGRAMS = ("clang-format-14", "clang-format")  # version 14 is Debian 12's, and the reference


def main():
    program = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        sys.exit("clang-format not found; on Debian: apt-get install clang-format")
    mode = ["-i"] if "--fix" in sys.argv[1:] else ["--dry-run", "-Werror"]
    files = sources.files(".h", ".cpp")
    result = subprocess.run([program, *mode, *map(str, files)], cwd=sources.ROOT, check=False)
    if result.returncode != 0:
        print("run test/tools/check_format.py --fix")
    sys.exit(result.returncode)


if __name__ == "__main__":
    main()
