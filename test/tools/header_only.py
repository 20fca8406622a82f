#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The library for programs that link nothing, as CGAL wants it: headers that also define what they
declare, below FOLDER.

usage: header_only.py FOLDER

X.cpp becomes X_impl.h, with `inline` before its functions and without its instances of templates. The
header that it includes first, X.h, includes it at the end. Written by clang-format, a function begins
in the first column, and its body there or with {}.
"""

import pathlib
import re
import sys

import sources

OUTSIDE = re.compile(r"(?!(?:inline|static|constexpr|namespace|using|class|struct|enum|extern)\b)[A-Za-z_]")
INSTANCES = re.compile(r"^#define CGP_DEFINE\((?:.*\\\n)*.*\n.*\n#undef CGP_DEFINE\n+"
                       r"|^template (?!<)[^;{]*;\n+", re.MULTILINE)
EMPTY = re.compile(r"^namespace ([\w:]+) {\n+}  // namespace \1\n+", re.MULTILINE)
# Programs need not be compiled as the library is.
CONFIG = "config.h"
CONFIG_INCLUDED = f"#include <{sources.SOLVERS}/{CONFIG}>\n"


def ends(line):
    """Whether a declaration ends here, or the body of a definition begins."""
    return line.endswith((";", "{", "{}"))


def inlined(text):
    """The text with `inline` before each function outside of unnamed namespaces; templates need none."""
    lines = text.split("\n")
    begin, is_unnamed = None, False
    for number, line in enumerate(lines):
        if begin is None and line.startswith("template <"):
            begin = -1
        elif begin is None and OUTSIDE.match(line):
            begin = number
        if begin is not None and ends(line):
            if begin >= 0 and not is_unnamed and re.search(r"^\{$|\{\}$|= default;$", line):
                lines[begin] = "inline " + lines[begin]
            begin = None
        if re.match(r"namespace \{|\}  // namespace$", line):
            is_unnamed = line.startswith("n")
    return "\n".join(lines)


def guarded(text, path):
    """With a guard of its path; CGAL wants these."""
    guard = re.sub(r"\W", "_", path.as_posix().upper())
    opening, body = re.match(r"((?://.*\n)+)(?:#pragma once\n)?((?:.|\n)*)", text).groups()
    return f"{opening}#ifndef {guard}\n#define {guard}\n{body}\n#endif\n"


def headers():
    """(path below include/, text) of each header and each X_impl.h."""
    at_end = {}
    for source in sources.library(".cpp"):
        text = (sources.INCLUDE / source).read_text(encoding="utf-8")
        path = source.with_name(f"{source.stem}_impl.h")
        first = next(name for _, name in sources.includes(sources.INCLUDE / source))
        at_end[first] = at_end.get(first, "\n") + f"#include <{path.as_posix()}>\n"
        yield path, guarded(inlined(EMPTY.sub("", INSTANCES.sub("", text))), path)
    for header in sources.headers():
        if header.name != CONFIG:
            text = (sources.INCLUDE / header).read_text(encoding="utf-8").replace(CONFIG_INCLUDED, "")
            yield header, guarded(text + at_end.get(header.as_posix(), ""), header)


def write(folder):
    """Files that stay what they are keep their time, so that nothing is compiled again."""
    for path, text in headers():
        place = folder / path
        if not place.exists() or place.read_text(encoding="utf-8") != text:
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write(pathlib.Path(sys.argv[1]))
