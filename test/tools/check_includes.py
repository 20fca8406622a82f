#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every name of the library that a file uses as `CGP::name` is declared in a header that the file
reaches: otherwise it compiles only beside others that include it, or with a precompiled header. What
X.h includes, X.cpp does not include again."""

import collections
import functools
import re

import sources

USED = re.compile(r"\bCGP::(?:internal::)?(\w+)")
DECLARED = [re.compile(pattern, re.MULTILINE) for pattern in (
    r"^(?:struct|class|enum class|enum)(?: \[\[\w+\]\])? (\w+)", r"^using (\w+) =",
    r"^(?:inline )?constexpr [\w:]+ (\w+) =", r"^[A-Za-z][^\n=;{}#/]*?[ &*](\w+)\(")]
PLACES = [sources.INCLUDE, sources.ROOT / "test", sources.ROOT / "examples", sources.ROOT / "benchmark"]


def code(path):
    return re.sub(r"//.*", "", path.read_text(encoding="utf-8"))


@functools.cache
def included(path):
    found = set()
    for _, name in sources.includes(path):
        places = (folder / name for folder in (*PLACES, path.parent))
        found.update(place.resolve() for place in places if place.is_file())
    return found


def reached(path):
    found, left = {path}, [path]
    while left:
        new = included(left.pop()) - found
        found |= new
        left += new
    return found


def declarations():
    """The headers of the library that declare each name."""
    headers = collections.defaultdict(set)
    for header in sources.headers():
        text = code(sources.INCLUDE / header)
        for pattern in DECLARED:
            for name in pattern.findall(text):
                headers[name].add(sources.INCLUDE / header)
    return headers


def repeated():
    for path in sources.files(".cpp"):
        header = sources.ROOT / path.with_suffix(".h")
        if header.is_file():
            for name in {name for _, name in sources.includes(header)} & {
                    name for _, name in sources.includes(sources.ROOT / path)}:
                yield f"{path}: {header.name} includes {name}"


def complaints():
    yield from repeated()
    declared = declarations()
    for path in sources.files(".h", ".cpp"):
        if path.parts[0] in ("include", "doc"):
            continue
        found = reached(sources.ROOT / path)
        for name in sorted(set(USED.findall(code(sources.ROOT / path)))):
            if name in declared and not declared[name] & found:
                yield f"{path}: CGP::{name} is declared in no header that it includes"


if __name__ == "__main__":
    sources.finish(list(complaints()), "includes of the library's names")
