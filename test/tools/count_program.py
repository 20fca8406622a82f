#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Counts the files and lines of the command-line program, the cycles of its modules, and the files that
each subcommand touches: the rows of the table in doc/developers.md.

usage: count_program.py [FOLDER...]

There is a column for each FOLDER, `examples/conformal` of a checkout, of an older commit for example. A
subcommand touches the files that are named after it (`flow.cpp`, `Flow_options.h`), and those that list
subcommands: that name at least half of them.
"""

import pathlib
import re
import sys

import sources

COMMAND = re.compile(r"Command (\w+)_command\(\)|char\* about_(\w+) =")


def subcommands(texts):
    found = (match[1] or match[2] for text in texts.values() for match in COMMAND.finditer(text))
    return sorted(set(found))


def names(text, command):
    """Whether a text has an identifier or a string of this subcommand."""
    return re.search(rf'\b(about_)?{command}(_command)?\b(?=[("; ])|\b{command.capitalize()}_options\b', text)


def touched(texts, commands):
    """The files that each subcommand touches."""
    lists = [file for file, text in texts.items()
             if 2 * sum(bool(names(text, command)) for command in commands) >= len(commands)]
    return {command: sorted({file for file in texts if re.match(rf"{command}(_|$)", file.stem, re.I)} | set(lists))
            for command in commands}


def reachable(modules, start):
    found, left = set(), [start]
    while left:
        for other in modules.get(left.pop(), ()):
            if other not in found:
                found.add(other)
                left.append(other)
    return found


def cycles(modules):
    """The sets of modules that include each other, directly or not."""
    reach = {module: reachable(modules, module) for module in modules}
    return {frozenset(other for other in reach[module] if module in reach.get(other, ()))
            for module in modules if module in reach[module]}


def counts(root):
    """The numbers of a program, by what they count."""
    texts = {file: (root / file).read_text(encoding="utf-8") for file in sources.program(root)}
    modules = sources.program_modules(root)
    of_program = {
        "files": len(texts),
        "files outside folders": sum(file.parent == pathlib.Path() for file in texts),
        "lines": sum(text.count("\n") for text in texts.values()),
        "modules": len(modules),
        "cycles of modules": len(cycles(modules)),
    }
    of_commands = {f"files of `{command}`": len(files)
                   for command, files in touched(texts, subcommands(texts)).items()}
    return {**of_program, **of_commands}


def main():
    roots = [pathlib.Path(word).resolve() for word in sys.argv[1:]] or [sources.PROGRAM]
    columns = [counts(root) for root in roots]
    for what in columns[-1]:
        print("|", " | ".join([what, *(f"{column[what]:,}" if what in column else "-" for column in columns)]), "|")


if __name__ == "__main__":
    main()
