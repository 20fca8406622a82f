#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""clang-format would change nothing in our files; `--fix` makes it so. Python has no tabs, nothing at
the ends of lines, and lines of 120 characters at most, except for rows of tables."""

import shutil
import subprocess
import sys

import sources

LONGEST_LINE = 120  # of Python
PROGRAMS = ("clang-format-14", "clang-format")  # version 14 is Debian 12's, and the reference


def python_complaints():
    for path in sources.files(".py", ".pyi"):
        lines = (sources.ROOT / path).read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines, 1):
            is_too_long = len(line) > LONGEST_LINE and not line.startswith("|")
            if "\t" in line or line != line.rstrip() or is_too_long:
                yield f"{path}:{number}: a tab, a space at the end, or too long"


def main():
    program = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        sys.exit("clang-format not found; on Debian: apt-get install clang-format")
    mode = ["-i"] if "--fix" in sys.argv[1:] else ["--dry-run", "-Werror"]
    files = sources.files(".h", ".cpp")
    result = subprocess.run([program, *mode, *map(str, files)], cwd=sources.ROOT, check=False)
    if result.returncode != 0:
        print("run test/tools/check_format.py --fix")
    complaints = list(python_complaints())
    for complaint in complaints:
        print(complaint)
    sys.exit(result.returncode or len(complaints) > 0)


if __name__ == "__main__":
    main()
