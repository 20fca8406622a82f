#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Which lines of the library the tests have run: per folder, in total, and those that are missing.

Reads the counts (.gcda) that tests compiled with CGP_COVERAGE have left in the build folder. A line
counts as run when one translation unit, one instantiation of its template, has run it; what gcov
takes for a line is a line. A file that no test has compiled counts with the lines that look like
statements; a template that none instantiates is not seen at all.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import sources

STATEMENT = re.compile(r"^\s{2,}(return|throw|if|for|while)\b.*[;{)]$", re.MULTILINE)


def lines_of(gcov, counts):
    """{file: {line: was it run}} of one translation unit."""
    with tempfile.TemporaryDirectory() as folder:  # gcov writes nothing there, but it might
        answer = subprocess.run([gcov, "--json-format", "--stdout", str(counts.resolve())],
                                cwd=folder, capture_output=True, text=True, check=True)
    found = collections.defaultdict(dict)
    for text in filter(None, answer.stdout.splitlines()):
        unit = json.loads(text)
        for file in unit["files"]:
            path = pathlib.Path(os.path.normpath(
                os.path.join(unit["current_working_directory"], file["file"])))
            if path.is_relative_to(sources.INCLUDE):
                merge(found[path.relative_to(sources.INCLUDE)],
                      ((line["line_number"], line["count"] > 0) for line in file["lines"]))
    return found


def merge(lines, more):
    """A line is run where any has run it."""
    for number, run in more:
        lines[number] = lines.get(number, False) or run


def statements(name):
    """{line: False} of what looks like statements in a file of which gcov knows nothing."""
    text = (sources.INCLUDE / name).read_text(encoding="utf-8")
    return {text.count("\n", 0, match.start(1)) + 1: False for match in STATEMENT.finditer(text)}


def measure(gcov, build):
    """{file: {line: was it run}} of all files, and the number of translation units."""
    counts = sorted(build.rglob("*.gcda"))
    total = {file: {} for file in sources.library(".h", ".cpp")}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for unit in pool.map(lambda file: lines_of(gcov, file), counts):
            for name, lines in unit.items():
                if name in total:  # else it is of an older state of the sources
                    merge(total[name], lines.items())
    return {name: lines or statements(name) for name, lines in total.items()}, len(counts)


def ranges(numbers):
    """[3, 4, 5, 9] as "3-5 9"."""
    parts = []
    for number in sorted(numbers):
        if parts and number == parts[-1][1] + 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return " ".join(f"{a}" if a == b else f"{a}-{b}" for a, b in parts)


def print_missing(files):
    for name, lines in files.items():
        missing = [number for number, run in lines.items() if not run]
        if missing:
            print(f"{name}: {len(missing)} of {len(lines)}: {ranges(missing)}")


def print_table(files):
    """One row per folder and one for all; returns the percentage of all."""
    rows = collections.defaultdict(lambda: [0, 0])
    for path, lines in files.items():
        for name in (path.parent.as_posix(), "all of it"):
            rows[name][0] += sum(lines.values())
            rows[name][1] += len(lines)
    print(f"\n{'folder':<50}{'lines':>8}{'run':>8}{'per cent':>10}")
    for name in sorted(rows, key=lambda name: (name == "all of it", name)):
        run, lines = rows[name]
        print(f"{name:<50}{lines:>8}{run:>8}{100 * run / max(lines, 1):>10.2f}")
    run, lines = rows["all of it"]
    return 100 * run / max(lines, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="the build folder")
    parser.add_argument("--gcov", default="gcov", help="the gcov of the compiler")
    parser.add_argument("--missing", action="store_true", help="list the lines that were not run")
    parser.add_argument("--at-least", type=float, default=0, metavar="PER_CENT")
    arguments = parser.parse_args()
    files, units = measure(arguments.gcov, arguments.build)
    if not units:
        sys.exit(f"{arguments.build}: nothing counted; is it configured with CGP_COVERAGE?")
    if arguments.missing:
        print_missing(files)
    percentage = print_table(files)
    print(f"{units} translation units; wanted: {arguments.at_least:g} per cent")
    sys.exit(0 if percentage >= arguments.at_least else 1)


if __name__ == "__main__":
    main()
