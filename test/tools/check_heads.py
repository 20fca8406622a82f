#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every file states its copyright and licence, and every header has the guard of its path."""

import re
from pathlib import PurePath

import sources
from sources import LIBRARY

COPYRIGHT = "Copyright (c) 2026 The Conformal Geometry Processing authors"
LICENCE = "SPDX-License-Identifier: LGPL-3.0-or-later"


def guards(path):
    """include/A/b/C.h has the guard A_B_C_H. Headers of tests and programs, which nobody else
    includes, may leave out the first folder: examples/conformal/io/a.h has CONFORMAL_IO_A_H."""
    inside = path.relative_to(path.parts[0])
    names = [inside] if path.parts[0] == "include" else [inside, path, PurePath(LIBRARY) / path]
    return [re.sub(r"[^A-Z0-9]", "_", str(name).upper()) for name in names]


def complaints():
    for path in sources.files(".h", ".cpp", ".py", ".sh"):
        text = (sources.ROOT / path).read_text(encoding="utf-8")
        head = "\n".join(text.splitlines()[:5])
        for line in (COPYRIGHT, LICENCE):
            if line not in head:
                yield f"{path}: no line \"{line}\" at the top"
        if path.suffix == ".h" and path.parts[0] != "doc":
            openings = [f"#ifndef {name}\n#define {name}\n" for name in guards(path)]
            closed = text.rstrip().split("\n")[-1].startswith("#endif")
            if not closed or not any(opening in text for opening in openings):
                yield f"{path}: the guard is not {guards(path)[0]}"


if __name__ == "__main__":
    sources.finish(list(complaints()), "copyright lines and guards")
