#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Each test of a program is run by one test of ctest: the filters that CMake reads from the files
select every test once.

usage: check_selected_tests.py BUILD_FOLDER
"""

import collections
import fnmatch
import json
import pathlib
import subprocess
import sys

import sources


def output(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def filters(folder):
    """{program: filters of GoogleTest}; a test on several processes runs the same ones again. CTest
    knows no command of a program that is not built."""
    found = collections.defaultdict(list)
    for test in json.loads(output("ctest", "--test-dir", folder, "--show-only=json-v1"))["tests"]:
        for argument in test.get("command", []):
            if argument.startswith("--gtest_filter=") and not test["name"].endswith("_processes"):
                found[test["command"][0]].append(argument.partition("=")[2].split(":"))
    return found


def tests_of(program):
    """Suite.test for each, also Prefix/Suite/0.test."""
    suite = ""
    for line in output(program, "--gtest_list_tests").splitlines():
        name = line.partition("#")[0].rstrip()
        if name.startswith(" "):
            yield suite + name.strip()
        elif name.endswith("."):
            suite = name


def complaints(folder):
    programs = filters(folder)
    if not programs:
        yield "no program is built; try: cmake --build"
    for program, selections in programs.items():
        for test in tests_of(program):
            count = sum(any(fnmatch.fnmatchcase(test, pattern) for pattern in selection)
                        for selection in selections)
            if count != 1:
                yield f"{pathlib.Path(program).name}: {test} is run {count} times"


if __name__ == "__main__":
    sources.finish(list(complaints(sys.argv[1])), "the tests of all programs")
