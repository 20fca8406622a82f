#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The pages on the thesis (doc/) name files and tests that exist, and leave nothing out: the
map has every numbered equation of the thesis, every erratum says what shows it.

In backticks, `operators/calculus.h` is a file below the root or below the include folder, and
`Dirac.of_a_constant_is_zero` a test in one of the test files named in the same row or item.
"""

import pathlib
import re

import sources

MAP, ERRATA = "doc/thesis_map.md", "doc/errata.md"
CONVENTIONS = "doc/conventions.md"
EQUATIONS = {2: 2, 3: 3, 4: 7, 5: 5, 6: 2}  # how many are numbered in each chapter
SUFFIXES = {".h", ".cpp", ".py", ".md", ".png", ".svg", ".txt", ".cmake"}
FILE = re.compile(r"[A-Za-z_][\w.+/-]*")
TEST = re.compile(r"[A-Z]\w*\.[a-z]\w*")
DEFINITION = re.compile(r"TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\)")
NO_CODE = "no code yet"


def read(name):
    return (sources.ROOT / name).read_text(encoding="utf-8")


def blocks(text):
    """Rows of tables, items of lists, headings and paragraphs."""
    return [block for block in re.split(r"\n(?=\n|\||- |#)", text) if block.strip()]


def find(name):
    return next((base / name for base in (sources.ROOT, sources.INCLUDE, *sources.HOUSES)
                 if (base / name).exists()), None)


def is_file_name(span):
    return FILE.fullmatch(span) and ("/" in span or pathlib.PurePath(span).suffix in SUFFIXES)


def tests_in(path):
    return {".".join(names) for names in DEFINITION.findall(path.read_text(encoding="utf-8"))}


def names_that_do_not_exist(page):
    for block in blocks(read(page)):
        spans = re.findall(r"`([^`]+)`", block)
        known = set()
        for name in filter(is_file_name, spans):
            path = find(name)
            if path is None:
                yield f"{page}: there is no {name}"
            elif name.startswith("test/") and path.is_file():
                known |= tests_in(path)
        for name in spans:
            if TEST.fullmatch(name) and not is_file_name(name) and name not in known:
                yield f"{page}: {name} is in no test file named beside it"


def equations_left_out():
    rows = re.findall(r"^\| \((\d)\.(\d)\)", read(MAP), re.MULTILINE)
    for chapter, count in EQUATIONS.items():
        for number in range(1, count + 1):
            if (str(chapter), str(number)) not in rows:
                yield f"{MAP}: no row of equation ({chapter}.{number})"


def errata_without_evidence():
    heads = re.split(r"^### E(\d+)\. ", read(ERRATA), flags=re.MULTILINE)[1:]
    numbers, bodies = [int(n) for n in heads[::2]], heads[1::2]
    if numbers != list(range(1, len(numbers) + 1)):
        yield f"{ERRATA}: the errata are not numbered 1, 2, 3, ..."
    for number, body in zip(numbers, bodies):
        evidence = body.partition("*Test:*")[2].partition("\n#")[0]
        if NO_CODE not in evidence and not any(map(TEST.fullmatch,
                                                   re.findall(r"`([^`]+)`", evidence))):
            yield f"{ERRATA}: E{number} names no test, nor says \"{NO_CODE}\""
    for number in map(int, re.findall(r"\bE(\d+)\b", read(MAP) + read(ERRATA))):
        if number not in numbers:
            yield f"E{number} is referred to and does not exist"


def complaints():
    for page in (MAP, ERRATA, CONVENTIONS):
        yield from names_that_do_not_exist(page)
    yield from equations_left_out()
    yield from errata_without_evidence()


if __name__ == "__main__":
    sources.finish(list(complaints()), "the pages on the thesis")
