#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every subcommand of `conformal` is in the list of commands.cmake, in the table of
doc/manual/program.txt and in the list of doc/overview.md; its help has an example; a test of
test/program/ runs it, and says in its head that it tests its file. What is seldom set is a key of
`--advanced`, so that there are no more options than one can read.

usage: check_subcommands.py [PROGRAM]   (whose options are counted)
"""

import re
import subprocess
import sys

import check_mirrored_tests
import sources

COMMANDS = "examples/conformal/commands"
LIST = re.compile(r"set\(CGP_ALL_COMMANDS ([\w\s]*?)\s+CACHE")
MANUAL = "doc/manual/program.txt"
OVERVIEW = "doc/overview.md"
MOST_OPTIONS = {"spin": 30, "all": 230}
OPTION = re.compile(r"^ +-(?!h,--help)", re.MULTILINE)
DEFINITION = re.compile(r"^Command (\w+)_command\(\)\s*\{", re.MULTILINE)


def read(path):
    return (sources.ROOT / path).read_text(encoding="utf-8")


def names():
    """The subcommands, by the files that define them."""
    return sorted(name for path in (sources.ROOT / COMMANDS).glob("*.cpp")
                  for name in DEFINITION.findall(read(path)))


def built():
    """The subcommands that CMake builds."""
    return LIST.search(read(f"{COMMANDS}/commands.cmake"))[1].split()


def options(program):
    """{subcommand: the number of its options} as the help of a program with all of them shows."""
    helps = {name: subprocess.run([program, name, "--help"], check=True, capture_output=True, text=True).stdout
             for name in names()}
    counts = {name: len(OPTION.findall(text)) for name, text in helps.items()}
    return {**counts, "all": sum(counts.values())}


def too_many(program):
    counts = options(program)
    for name, most in MOST_OPTIONS.items():
        if counts[name] > most:
            yield (f"{COMMANDS}: {counts[name]} options of {name}, more than {most}: "
                   "what is seldom set is added to advanced()")


def tests():
    return [path for path in check_mirrored_tests.tests() if path.parts[:2] == ("test", "program")]


def runs(test, name):
    """Whether a test begins a command line with the subcommand."""
    return re.search(rf'"{name}[ "]', read(test)) is not None


def complaints(program=None):
    if program:
        yield from too_many(program)
    overview = next((paragraph for paragraph in read(OVERVIEW).split("\n\n")
                     if "command `conformal`" in paragraph), "")
    for name in names():
        file = f"{COMMANDS}/{name}.cpp"
        if name not in built():
            yield f"{COMMANDS}/commands.cmake: CGP_ALL_COMMANDS is without {name}"
        if not re.search(rf"Example[^:]*: conformal {name}\b", read(file)):
            yield f"{file}: its help has no line \"Example: conformal {name} ...\""
        if not re.search(rf"^\| `+conformal {name}\b", read(MANUAL), re.MULTILINE):
            yield f"{MANUAL}: its table has no row of `conformal {name}`"
        if f"`{name}`" not in overview:
            yield f"{OVERVIEW}: its list of commands is without `{name}`"
        own = [test for test in tests() if file in check_mirrored_tests.claims(test)]
        if not any(runs(test, name) for test in own):
            yield f"{file}: no test in test/program/ runs `{name}` and has the line \"// Tests {file}\""


if __name__ == "__main__":
    sources.finish(list(complaints(*sys.argv[1:])), f"{len(names())} subcommands")
