#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every file states its copyright and licence, and every header has the guard of its path."""

import re

import sources

COPYRIGHT = "Copyright (c) 2026 The Conformal Geometry Processing authors"
LICENCE = "SPDX-License-Identifier: LGPL-3.0-or-later"


def guard(path):
    """The guard of a path below the root: include/A/b/C.h has A_B_C_H. Headers of tests and
    programs, which nobody else includes, may put any prefix before the path in their folder."""
    name = re.sub(r"[^A-Z0-9]", "_", str(path.relative_to(path.parts[0])).upper())
    return name if path.parts[0] == "include" else rf"(?:\w+_)?{name}"


def complaints():
    for path in sources.files(".h", ".cpp", ".py", ".pyi", ".sh"):
        text = (sources.ROOT / path).read_text(encoding="utf-8")
        head = "\n".join(text.splitlines()[:5])
        for line in (COPYRIGHT, LICENCE):
            if line not in head:
                yield f"{path}: no line \"{line}\" at the top"
        if path.suffix == ".h" and path.parts[0] != "doc":
            opening = re.search(rf"^#ifndef ({guard(path)})\n#define \1\n", text, re.MULTILINE)
            if not opening or not text.rstrip().split("\n")[-1].startswith("#endif"):
                yield f"{path}: the guard is not {guard(path)}"


if __name__ == "__main__":
    sources.finish(list(complaints()), "copyright lines and guards")
